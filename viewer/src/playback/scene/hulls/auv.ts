// SPDX-License-Identifier: Apache-2.0
// Sparus II: a yellow hull with a black bow and stern, a small mast, two thrusters astern on fins and one upright.
import { HullBuilder, type Hull } from './builder';

export function auv(length: number, beam: number): Hull {
  const r = Math.min(0.085 * length, 0.32 * beam);
  const y = 0.5 * beam - 0.5 * r;
  const l = length / 2;
  return new HullBuilder()
    .turned('black', [[0.74 * l, 0.97 * r], [0.84 * l, 0.9 * r], [0.93 * l, 0.68 * r], [0.985 * l, 0.36 * r], [l, 0]])
    .turned('yellow', [[0.34 * l, r], [0.6 * l, r], [0.74 * l, 0.97 * r]])
    .turned('accent', [[0.02 * l, r], [0.02 * l, 1.02 * r], [0.34 * l, 1.02 * r], [0.34 * l, r]])
    .turned('yellow', [[-0.46 * l, 0.97 * r], [-0.3 * l, r], [0.02 * l, r]])
    .turned('black', [[-l, 0], [-0.98 * l, 0.14 * r], [-0.85 * l, 0.4 * r], [-0.62 * l, 0.84 * r], [-0.46 * l, 0.97 * r]])
    // Horizontal fins that carry the thrusters, and the upright one.
    .box('accent', [0.16 * l, 2 * y, 0.1 * r], [-0.74 * l, 0, 0])
    .box('accent', [0.18 * l, 0.1 * r, 1.1 * r], [-0.76 * l, 0, 0.9 * r])
    .thruster('black', 0.5 * r, [-0.82 * l, y, 0])
    .thruster('black', 0.5 * r, [-0.82 * l, -y, 0])
    .rod('black', [-0.16 * l, 0, 0.96 * r], [-0.16 * l, 0, 1.03 * r], 0.36 * r)
    // Mast with its antenna.
    .box('accent', [0.13 * l, 0.18 * r, 1.4 * r], [-0.02 * l, 0, 1.6 * r])
    .rod('black', [-0.03 * l, 0, 2.2 * r], [-0.03 * l, 0, 3.4 * r], 0.06 * r)
    .build();
}
