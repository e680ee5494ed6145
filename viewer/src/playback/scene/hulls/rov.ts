// SPDX-License-Identifier: Apache-2.0
// Minerva: an open frame under a block of buoyancy, with thrusters on all sides.
import { HullBuilder, type Hull } from './builder';

/** Adds one to a vehicle put together from several. */
export function add_rov(builder: HullBuilder, length: number, beam: number): HullBuilder {
  const l = 0.5 * length;
  const b = 0.5 * beam;
  const h = 0.36 * Math.min(length, 1.4 * beam);
  const bar = 0.04 * beam;
  builder.box('yellow', [1.92 * l, 1.84 * b, 0.62 * h], [0, 0, 0.62 * h]);
  builder.box('accent', [0.5 * l, 1.88 * b, 0.64 * h], [0.3 * l, 0, 0.625 * h]);
  for (const side of [-1, 1]) {
    for (const end of [-1, 0, 1]) builder.rod('grey', [end * 0.88 * l, side * 0.86 * b, -h], [end * 0.88 * l, side * 0.86 * b, 0.36 * h], bar);
    builder.rod('black', [-l, side * 0.86 * b, -h], [l, side * 0.86 * b, -h], 1.3 * bar);
    builder.rod('grey', [-0.88 * l, side * 0.86 * b, -0.3 * h], [0.88 * l, side * 0.86 * b, -0.3 * h], bar);
    builder.rod('grey', [side * 0.88 * l, -0.86 * b, -h], [side * 0.88 * l, 0.86 * b, -h], bar);
    builder.thruster('accent', 0.26 * b, [-0.72 * l, side * 0.5 * b, -0.3 * h]);
    builder.thruster('black', 0.26 * b, [0, side * 0.5 * b, 0.95 * h], 'up');
  }
  // Electronics, and the camera that looks ahead.
  builder.rod('pale', [-0.5 * l, 0, -0.5 * h], [0.5 * l, 0, -0.5 * h], 0.26 * b);
  builder.rod('black', [0.7 * l, 0, -0.2 * h], [0.98 * l, 0, -0.2 * h], 0.16 * b, 0.2 * b);
  return builder;
}

export function rov(length: number, beam: number): Hull {
  return add_rov(new HullBuilder(), length, beam).build();
}
