// SPDX-License-Identifier: Apache-2.0
// The keyboard: what each key does, as the help lists it, and the listener.
import type { CameraKind, Layer } from './scene/stage_view';

export const camera_keys: Record<CameraKind, string> = { orbit: 'o', follow: 'c', top: 't', side: 's' };
export const layer_keys: Record<Layer, string> = {
  trails: 'r', spheres: 'b', goals: 'g', obstacles: 'x', grid: 'd', surface: 'w', current: 'u', sketch: 'k', tracks: 'n',
  sonar: 'a', messages: 'm', names: 'l',
};

export interface Binding {
  /** As KeyboardEvent.key, lower-case letters; the first is shown. */
  keys: string[];
  /** For the help; an empty one is not listed. */
  does: string;
  shown?: string;
  shift?: boolean;
  run(key: string): void;
}

const key_names: Record<string, string> = {
  ' ': 'Space', arrowleft: 'Left', arrowright: 'Right', arrowup: '↑', arrowdown: '↓', home: 'Home', end: 'End', escape: 'Esc',
};
export function key_name({ keys, shown, shift }: Binding): string {
  const name = shown ?? keys.map((key) => key_names[key] ?? key).join(' ');
  return shift === true ? `Shift ${name}` : name;
}

// Whoever types or turns a control with a key keeps that key.
function taken(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('dialog') !== null) return key !== '?';
  if (target.closest('textarea, select, [contenteditable], input:not([type="range"])') !== null) return true;
  if (target.closest('button, a, summary') !== null) return key === ' ' || key === 'enter';
  return false;
}

/** A button that was clicked gives the keys back: a space after it plays, and does not press it again. */
export function give_back_keys(within: HTMLElement): void {
  within.addEventListener('click', (event) => {
    const button = event.target instanceof Element ? event.target.closest('button') : null;
    // Pressed with a key, a click has no count.
    if (button !== null && event.detail > 0) button.blur();
  });
}

/** Keys reach `bindings` unless a control has use for them, or a modifier makes them the browser's. */
export function listen(bindings: Binding[]): void {
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    const key = event.key.toLowerCase();
    if (taken(event.target, key)) return;
    const fitting = bindings.filter((binding) => binding.keys.includes(key));
    const binding = fitting.find(({ shift }) => (shift ?? false) === event.shiftKey) ?? fitting.find(({ shift }) => shift === undefined);
    if (binding === undefined) return;
    event.preventDefault();
    binding.run(key);
  });
}
