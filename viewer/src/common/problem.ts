// SPDX-License-Identifier: Apache-2.0
// The data inside a page, and what the page says when they cannot be read.
import { buoy } from './buoy';
import { h } from './dom';
import { DataError } from './read';
import { reason_of } from './reason';
import { theme_toggle } from './theme';

/** The text that fairway put into the template; throws DataError where it did not. */
export function embedded_text(what: string): string {
  const text = document.getElementById('fairway-data')?.textContent?.trim() ?? '';
  if (text === '' || text.startsWith('__')) {
    throw new DataError(`this is the empty template: fairway puts the data of a ${what} into it`);
  }
  return text;
}

export function problem_element(text: string): HTMLElement {
  return h('div', { class: 'note problem', role: 'alert' }, h('b', {}, 'Not shown'), h('p', {}, text));
}

/** Instead of the page: what is wrong with its data, and what to do. */
export function show_problem(into: HTMLElement, what: string, error: unknown, advice: string): void {
  const reason = reason_of(error);
  into.replaceChildren(h('div', { class: 'problem-page' },
    h('header', { class: 'brand-bar' }, h('span', { class: 'brand' }, buoy(), `fairway ${what}`), theme_toggle()),
    h('h1', {}, `This ${what} cannot be shown`),
    h('main', {}, problem_element(`${reason}.`),
      h('p', {}, `The data are inside this file, in the element fairway-data. ${advice}`))));
}
