// SPDX-License-Identifier: Apache-2.0
import { h } from './dom';

type Theme = 'light' | 'dark';
const key = 'fairway-theme';
const system = matchMedia('(prefers-color-scheme: dark)');

// Storage can be refused, as in a sandboxed frame: then the choice lasts as long as the page.
function stored(): Theme | null {
  try {
    const value = localStorage.getItem(key);
    return value === 'light' || value === 'dark' ? value : null;
  } catch {
    return null;
  }
}

let chosen: Theme | null = stored();

function current(): Theme {
  return chosen ?? (system.matches ? 'dark' : 'light');
}

function apply(): void {
  document.documentElement.dataset['theme'] = current();
}

/** Follows the system until the reader chooses, then remembers the choice. */
export function theme_toggle(): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'theme-toggle', 'aria-label': 'Dark theme' },
    h('span', { class: 'theme-icon', 'aria-hidden': 'true' }));
  const show = (): void => {
    apply();
    button.setAttribute('aria-pressed', String(current() === 'dark'));
    button.title = current() === 'dark' ? 'Switch to the light theme' : 'Switch to the dark theme';
  };
  button.addEventListener('click', () => {
    chosen = current() === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(key, chosen);
    } catch {
      // The choice is not remembered.
    }
    show();
  });
  system.addEventListener('change', show);
  show();
  return button;
}

/** Runs `action` while the light theme is in force, without a paint in between. */
export function in_light_theme<T>(action: () => T): T {
  const before = document.documentElement.dataset['theme'];
  document.documentElement.dataset['theme'] = 'light';
  try {
    return action();
  } finally {
    if (before !== undefined) document.documentElement.dataset['theme'] = before;
  }
}
