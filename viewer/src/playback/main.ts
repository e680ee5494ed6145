// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import '../common/parts.css';
import './page.css';
import './side.css';
import './transport.css';
import './panel.css';
import { h } from '../common/dom';
import { embedded_text, show_problem } from '../common/problem';
import { DataError } from '../common/read';
import { reason_of } from '../common/reason';
import { Film } from './film';
import { LiveRun } from './live';
import { decode, type Document, type Part } from './model';
import { show_page } from './page';
import { page_around, server } from './source';

const into = document.getElementById('page')!;

function complain(error: unknown): void {
  show_problem(into, 'playback', error, 'Making the page again from its recording usually helps.');
}

function recorded(film: Film, part: Part): void {
  try {
    film.append(part);
  } catch (error) {
    throw new DataError(`film: ${reason_of(error)}`);
  }
  if (film.count === 0) throw new DataError('film: it has no frames');
}

/** The page appears with the first frame. */
function watch(playback: Document, film: Film): void {
  into.replaceChildren(h('p', { class: 'waiting', role: 'status' }, 'Waiting for the first frame of the run.'));
  const live = new LiveRun(film, playback.live === 'page' ? page_around() : server());
  let shown = false;
  live.on_answer(() => {
    if (!shown && film.count > 0) {
      shown = true;
      show_page(playback, film, live, into);
    } else if (!shown && live.trouble !== '') {
      into.replaceChildren(h('p', { class: 'waiting', role: 'status' }, live.trouble));
    }
  });
  live.watch().catch(complain);
}

try {
  const playback = decode(embedded_text('playback'));
  const film = new Film(playback.columns, playback.scene.vehicles.length);
  if (playback.film === null) {
    watch(playback, film);
  } else {
    recorded(film, playback.film);
    show_page(playback, film, null, into);
  }
} catch (error) {
  complain(error);
}
