// SPDX-License-Identifier: Apache-2.0
// The stretch of time that all charts show together.

const least_width_s = 0.5;

export class Span {
  private whole: readonly [number, number] = [0, 1];
  private part: readonly [number, number] | null = null;

  /** `changed` is called when another stretch is to be seen, not when the run grows. */
  constructor(private readonly changed: () => void) {}

  get shown(): readonly [number, number] {
    return this.part ?? this.whole;
  }
  get is_zoomed(): boolean {
    return this.part !== null;
  }

  /** The run is this long now; what is zoomed into stays where it is. */
  grow(from: number, to: number): void {
    this.whole = [from, to > from ? to : from + 1];
  }

  /** A stretch `factor` times as wide, in which `about` keeps its place. */
  zoom(factor: number, about: number): void {
    const [from, to] = this.shown;
    const width = Math.max((to - from) * factor, least_width_s);
    if (width >= this.whole[1] - this.whole[0]) return this.reset();
    const part = Math.min(Math.max((about - from) / (to - from), 0), 1);
    this.move_to(about - part * width, width);
  }

  reset(): void {
    if (this.part === null) return;
    this.part = null;
    this.changed();
  }

  /** Turns the page when the moment leaves the stretch. */
  keep_in_view(time: number): void {
    if (this.part === null) return;
    const [from, to] = this.part;
    if (time >= from && time <= to) return;
    this.move_to(time - 0.1 * (to - from), to - from);
  }

  private move_to(from: number, width: number): void {
    const start = Math.min(Math.max(from, this.whole[0]), Math.max(this.whole[1] - width, this.whole[0]));
    this.part = [start, start + width];
    this.changed();
  }
}
