// SPDX-License-Identifier: Apache-2.0
import type { VehicleSpec } from '../../model';
import { auv } from './auv';
import type { Hull } from './builder';
import { catamaran } from './catamaran';
import { point } from './point';
import { rov } from './rov';
import { torpedo } from './torpedo';
import { transport } from './transport';

export function hull_of(spec: VehicleSpec): Hull {
  switch (spec.shape) {
    case 'auv': return auv(spec.length_m, spec.beam_m);
    case 'torpedo': return torpedo(spec.length_m, spec.beam_m);
    case 'rov': return rov(spec.length_m, spec.beam_m);
    case 'transport': return transport(spec);
    case 'catamaran': return catamaran(spec.length_m, spec.beam_m);
    case 'point': return point(spec.length_m, spec.beam_m);
  }
}

/** Vehicles of the same key look the same but for their accents. */
export function hull_key(spec: VehicleSpec): string {
  return JSON.stringify([spec.shape, spec.length_m, spec.beam_m, spec.parts]);
}
