// SPDX-License-Identifier: Apache-2.0
import type { Moment } from './film';

/** A part of the page that keeps in step with it; it leaves out what makes no difference to it. */
export interface Panel {
  readonly element: HTMLElement;
  /** Called for every picture; has to be quick. */
  show?(moment: Moment): void;
  /** None chosen: all alike. */
  choose?(vehicles: ReadonlySet<number>): void;
  /** More frames have come in, or all were replaced. */
  grown?(): void;
  /** The theme has changed, or the panel another size. */
  restyle?(): void;
}
