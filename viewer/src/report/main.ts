// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import '../common/parts.css';
import './page.css';
import './chart.css';
import './runs.css';
import './print.css';
import { embedded_text, show_problem } from '../common/problem';
import { decode } from './model';
import { show_document } from './page';

const into = document.getElementById('page')!;
try {
  const report = decode(embedded_text('report'));
  // Labels are measured to lay charts out, so the page's own font comes first; it is inside the file.
  await document.fonts.load('400 12px "Fairway Sans"').catch(() => []);
  show_document(report, into);
} catch (error) {
  show_problem(into, 'report', error,
    'Making the report again with the version of fairway that wrote its results usually helps.');
}
