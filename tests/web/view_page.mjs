// SPDX-License-Identifier: Apache-2.0
// A page of `fairway view` in the browser, as the checks drive it.
import { Picture, png_uri } from './picture.mjs';

/** As small as a desk's window may be: a processor draws every pixel of it. */
export const desk = { width: 920, height: 620 };

export class ViewPage {
  constructor(page) {
    this.page = page;
  }

  /** When the picture has been there for the first time [s after navigation]. */
  async first_picture() {
    await this.page.waitForFunction(() => window.fairway !== undefined);
    return this.page.evaluate(() => new Promise((done) => {
      requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() / 1000)));
    }));
  }

  state() {
    return this.page.evaluate(() => window.fairway.state());
  }

  async seek_frame(index) {
    await this.page.evaluate((i) => window.fairway.seek(window.fairway.film.time(i)), index);
  }

  /** Values of the film: what the page should show. */
  film() {
    return this.page.evaluate(() => {
      const { film } = window.fairway;
      return { count: film.count, vehicles: film.vehicles, end: film.end, events: film.events, sketches: film.sketches.any };
    });
  }

  values(index) {
    return this.page.evaluate((i) => {
      const { film } = window.fairway;
      const of = (name, v, k = 0) => film.value(name, i, v, k);
      return {
        time: film.time(i),
        vehicles: Array.from({ length: film.vehicles }, (_, v) => ({ position: [0, 1, 2].map((k) => of('position_m', v, k)), alert: of('alert', v) })),
      };
    }, index);
  }

  /** The frame of an event: the first at or after its time. */
  frame_of(time) {
    return this.page.evaluate((t) => {
      const { film } = window.fairway;
      let i = film.index_at(t - 1e-6);
      while (i + 1 < film.count && film.time(i) < t - 1e-6) ++i;
      return i;
    }, time);
  }

  /** Only these layers are drawn. */
  async layers(...wanted) {
    for (const button of await this.page.locator('[data-layer]').all()) {
      if (!(await button.isVisible())) continue;
      const on = (await button.getAttribute('aria-pressed')) === 'true';
      if (on !== wanted.includes(await button.getAttribute('data-layer'))) await button.click();
    }
  }

  camera(kind) {
    return this.page.click(`[data-camera="${kind}"]`);
  }

  /** What is drawn now, without the buttons that lie over it. */
  async shot() {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const clip = await this.page.locator('.picture').boundingBox();
    return Picture.of(png_uri(await this.page.screenshot({ clip, scale: 'css', style: '.cameras { visibility: hidden }' })), this.page);
  }

  /** The same once nothing moves any more, as a camera that glides. */
  async settled() {
    let last = await this.shot();
    for (let i = 0; i < 12; ++i) {
      const next = await this.shot();
      if (next.differs_from(last) === 0) return next;
      last = next;
    }
    return last;
  }
}

/** As the page prints numbers, with a true minus and thin spaces. */
export function plain(text) {
  return text.replace('\u2212', '-').replaceAll('\u2009', '');
}

/** As the page prints it, of the number itself: no minus before nothing. */
export function printed(value) {
  const text = value.toFixed(3);
  return Number(text) === 0 ? text.replace('-', '') : text;
}
