// SPDX-License-Identifier: Apache-2.0
import { h } from './dom';

/** Offers `blob` as a file to save. */
export function save_blob(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = h('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Offers `text` as a file to save. */
export function save_text(name: string, type: string, text: string): void {
  save_blob(name, new Blob([text], { type: `${type};charset=utf-8` }));
}

/** Puts `text` on the clipboard; false where the browser refuses. */
export async function copy_text(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h('textarea', { class: 'offscreen', 'aria-hidden': 'true' });
    area.value = text;
    // Nothing outside an open dialog can be selected.
    (document.querySelector('dialog[open]') ?? document.body).append(area);
    area.select();
    const copied = document.execCommand('copy');
    area.remove();
    return copied;
  }
}

/** A small button that says for a moment that it has done its work. */
export function action_button(label: string, title: string, done: string,
                              action: () => boolean | void | Promise<boolean | void>): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'action', title, 'aria-label': title }, label);
  button.addEventListener('click', async () => {
    const worked = (await action()) !== false;
    button.textContent = worked ? done : 'failed';
    button.classList.add('done');
    setTimeout(() => {
      button.textContent = label;
      button.classList.remove('done');
    }, 1400);
  });
  return button;
}
