// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import './page.css';
import './chart.css';
import './print.css';
import { h } from '../common/dom';
import { theme_toggle } from '../common/theme';
import { problem_element } from './block';
import { decode } from './decode';
import { show_document } from './page';
import { DataError } from './reader';

function show_problem(into: HTMLElement, error: unknown): void {
  const reason = error instanceof Error ? error.message : String(error);
  into.replaceChildren(h('header', { class: 'top' }, h('div', { class: 'bar' }, h('span', { class: 'brand' }, 'fairway report'), theme_toggle()),
    h('h1', {}, 'This report cannot be shown')),
    h('main', { class: 'alone' }, problem_element(`${reason}.`),
      h('p', {}, 'The data are inside this file, in the element fairway-data. Making the report again with the version of ' +
        'fairway that wrote its results usually helps.')));
}

const into = document.getElementById('page')!;
try {
  const text = document.getElementById('fairway-data')?.textContent?.trim() ?? '';
  if (text === '' || text.startsWith('__')) {
    throw new DataError('this is the empty template: fairway puts the data of a report into it');
  }
  const report = decode(text);
  // Labels are measured to lay charts out, so the page's own font comes first; it is inside the file.
  await document.fonts.load('400 12px "Fairway Sans"').catch(() => []);
  show_document(report, into);
} catch (error) {
  show_problem(into, error);
}
