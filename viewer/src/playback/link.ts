// SPDX-License-Identifier: Apache-2.0
// A moment in the address: #t=12.500&v=2,3&camera=top. What is sent to somebody else opens there.
import type { Selection } from './selection';
import type { Clock } from './clock';
import type { Film } from './film';
import { cameras } from './scene/stage_view';

/** Browsers refuse an address that changes too often. */
const least_gap_ms = 1000;

export class MomentLink {
  private timer = 0;

  constructor(private readonly film: Film, private readonly clock: Clock, private readonly choice: Selection) {
    window.addEventListener('hashchange', () => this.go());
  }

  /** The address of what is shown now. */
  text(): string {
    const { index } = this.clock.moment;
    const parts = [`t=${this.film.time(index).toFixed(3)}`];
    const { chosen, camera, followed } = this.choice;
    const vehicles = camera === 'follow' ? [followed, ...[...chosen].filter((vehicle) => vehicle !== followed)] : [...chosen];
    if (vehicles.length > 0) parts.push(`v=${vehicles.join(',')}`);
    if (camera !== 'orbit') parts.push(`camera=${camera}`);
    return `${location.href.replace(/[#?].*$/, '')}#${parts.join('&')}`;
  }

  /** Goes to where the address says; false where it says nothing. */
  go(): boolean {
    const wanted = new URLSearchParams(location.search);
    new URLSearchParams(location.hash.slice(1)).forEach((value, key) => wanted.set(key, value));
    const time = Number(wanted.get('t') ?? NaN);
    const vehicles = (wanted.get('v') ?? '').split(',').filter((word) => /^\d+$/.test(word)).map(Number);
    const camera = cameras.find((kind) => kind === wanted.get('camera'));
    if (camera === 'follow') this.choice.follow(vehicles[0] ?? 0);
    if (vehicles.length > 0) this.choice.choose(vehicles);
    if (camera !== undefined && camera !== 'follow') this.choice.set_camera(camera);
    if (Number.isFinite(time)) this.clock.seek(time);
    return Number.isFinite(time);
  }

  /** Brings the address up to date, soon. */
  update(): void {
    if (this.timer !== 0) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      try {
        history.replaceState(null, '', this.text());
      } catch {
        // A frame without an address of its own: links cannot be made from it.
      }
    }, least_gap_ms);
  }
}
