// SPDX-License-Identifier: Apache-2.0
// Zarco or Otter: two slender hulls, a deck on beams, a mast with a light.
import { HullBuilder, type Hull } from './builder';

export function catamaran(length: number, beam: number): Hull {
  const l = length / 2;
  const width = Math.min(0.15 * length, 0.28 * beam);
  const r = width / 2;
  const y = beam / 2 - r;
  const deck = 1.5 * r;
  const builder = new HullBuilder();
  for (const side of [-1, 1]) {
    builder.turned('yellow', [[-0.97 * l, 0], [-0.96 * l, 0.75 * r], [-0.6 * l, r], [0.35 * l, r], [0.75 * l, 0.7 * r], [0.94 * l, 0.3 * r], [l, 0]],
      [0, side * y, 0]);
    builder.turned('accent', [[-0.3 * l, r], [-0.3 * l, 1.04 * r], [0.1 * l, 1.04 * r], [0.1 * l, r]], [0, side * y, 0]);
    builder.thruster('black', 0.5 * r, [-0.9 * l, side * y, -0.9 * r]);
    for (const end of [-0.55, 0.4]) builder.rod('grey', [end * l, side * y, 0.8 * r], [end * l, side * 0.55 * y, deck], 0.18 * r);
  }
  return builder
    .rod('grey', [-0.55 * l, -y, deck], [-0.55 * l, y, deck], 0.2 * r)
    .rod('grey', [0.4 * l, -y, deck], [0.4 * l, y, deck], 0.2 * r)
    .box('black', [1.05 * l, 1.1 * y, 0.3 * r], [-0.08 * l, 0, deck + 0.2 * r])
    .box('accent', [0.6 * l, 0.8 * y, 0.7 * r], [-0.12 * l, 0, deck + 0.6 * r])
    .rod('pale', [-0.3 * l, 0, deck], [-0.3 * l, 0, deck + 0.62 * l], 0.16 * r, 0.1 * r)
    .rod('orange', [-0.3 * l, 0, deck + 0.62 * l], [-0.3 * l, 0, deck + 0.7 * l], 0.24 * r)
    .build();
}
