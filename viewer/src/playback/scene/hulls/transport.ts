// SPDX-License-Identifier: Apache-2.0
// Several ROVs that carry a payload between them on bars.
import type { VehicleSpec } from '../../model';
import { HullBuilder, type Hull } from './builder';
import { add_rov } from './rov';

/** Without parts, four of them in the corners of its size. */
function places(spec: VehicleSpec): VehicleSpec['parts'] {
  if (spec.parts.length > 0) return spec.parts;
  const x = 0.36 * spec.length_m;
  const y = 0.36 * spec.beam_m;
  return [[x, y], [x, -y], [-x, -y], [-x, y]].map(([x_m, y_m]) => ({ x_m: x_m!, y_m: y_m!, z_m: 0, yaw_rad: 0 }));
}

export function transport(spec: VehicleSpec): Hull {
  const builder = new HullBuilder();
  const parts = places(spec);
  const reach = Math.min(...parts.map((p) => Math.hypot(p.x_m, p.y_m))) || spec.length_m / 3;
  // Hulls may not run into each other, however close they are carried.
  const apart = Math.min(...parts.flatMap((p, i) => parts.slice(0, i).map((q) => Math.hypot(p.x_m - q.x_m, p.y_m - q.y_m))), 2 * reach);
  const length = Math.min(1.44, 0.62 * apart);
  const payload = 0.32 * reach;
  builder.box('grey', [2 * payload, 2 * payload, 0.5 * payload], [0, 0, 0]);
  builder.box('accent', [2.04 * payload, 0.4 * payload, 0.54 * payload], [0, 0, 0]);
  // An arrow of darker paint tells its bow.
  builder.rod('black', [0.5 * payload, 0, 0.2 * payload], [1.7 * payload, 0, 0.2 * payload], 0.4 * payload, 0.01, 4);
  for (const part of parts) {
    builder.rod('black', [0, 0, 0], [part.x_m, part.y_m, -part.z_m], 0.045 * length);
    builder.in_part([part.x_m, part.y_m, -part.z_m], part.yaw_rad);
    add_rov(builder, length, 0.64 * length).in_part([0, 0, 0], 0);
  }
  return builder.build();
}
