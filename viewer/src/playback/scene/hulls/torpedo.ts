// SPDX-License-Identifier: Apache-2.0
// REMUS: a slim cylinder with a rounded nose, a tapered tail, a cross of fins and a propeller.
import { HullBuilder, type Hull } from './builder';

export function torpedo(length: number, beam: number): Hull {
  const l = length / 2;
  const r = Math.min(beam / 2, 0.1 * length);
  const fin = 1.1 * r;
  return new HullBuilder()
    .turned('yellow', [[0.5 * l, r], [0.86 * l, r], [0.93 * l, 0.86 * r], [0.98 * l, 0.55 * r], [l, 0]])
    .turned('accent', [[0.24 * l, r], [0.24 * l, 1.03 * r], [0.5 * l, 1.03 * r], [0.5 * l, r]])
    .turned('yellow', [[-0.4 * l, r], [0.24 * l, r]])
    .turned('black', [[-0.95 * l, 0], [-0.945 * l, 0.16 * r], [-0.7 * l, 0.62 * r], [-0.4 * l, r]])
    .box('accent', [0.1 * l, 2 * fin + r, 0.1 * r], [-0.78 * l, 0, 0])
    .box('accent', [0.1 * l, 0.1 * r, 2 * fin + r], [-0.78 * l, 0, 0])
    .box('black', [0.02 * l, 1.5 * r, 0.28 * r], [-0.97 * l, 0, 0], 0.6)
    .box('black', [0.02 * l, 1.5 * r, 0.28 * r], [-0.97 * l, 0, 0], 0.6 + Math.PI / 2)
    .rod('black', [-l, 0, 0], [-0.94 * l, 0, 0], 0.14 * r)
    // Transducer under the nose and a short antenna.
    .rod('black', [0.7 * l, 0, -r], [0.7 * l, 0, -1.5 * r], 0.3 * r, 0.24 * r)
    .rod('black', [-0.1 * l, 0, r], [-0.1 * l, 0, 2.2 * r], 0.12 * r, 0.06 * r)
    .build();
}
