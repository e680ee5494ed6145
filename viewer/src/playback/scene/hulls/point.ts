// SPDX-License-Identifier: Apache-2.0
// A vehicle without a body: a cone that points ahead and a ring about its middle.
import { HullBuilder, type Hull } from './builder';

export function point(length: number, beam: number): Hull {
  const l = length / 2;
  const r = Math.min(beam, length) / 2;
  return new HullBuilder()
    .turned('accent', [[-0.7 * l, 0], [-0.7 * l, 0.5 * r], [-0.62 * l, 0.54 * r], [l, 0]])
    .ring('grey', 0.9 * r, 0.06 * r, [-0.2 * l, 0, 0], 'up')
    .rod('grey', [-0.2 * l, -0.9 * r, 0], [-0.2 * l, 0.9 * r, 0], 0.04 * r)
    .build();
}
