// SPDX-License-Identifier: Apache-2.0
// Who a track is, by its number: fairway/core/ids.hpp.
import type { VehicleSpec } from '../model';
import { vehicle_colour } from '../printed';

const first_tracker_id = 0x4000_0000;
const first_drifter_id = 0x8000_0000;

export interface Who {
  name: string;
  /** Of a vehicle its own, the same over the whole page; else null. */
  colour: string | null;
}

function numbered(kind: string, serial: number, vehicles: readonly VehicleSpec[]): Who {
  const vehicle = kind === 'vehicle' ? vehicles.findIndex(({ id }) => id === serial) : -1;
  return vehicle < 0 ? { name: `${kind} ${serial}`, colour: null }
    : { name: vehicles[vehicle]!.name, colour: vehicle_colour(vehicle) };
}

export function who_is(id: number, vehicles: readonly VehicleSpec[]): Who {
  if (id >= first_drifter_id) return numbered('drifter', id - first_drifter_id, vehicles);
  if (id >= first_tracker_id) return numbered('contact', id - first_tracker_id, vehicles);
  return numbered('vehicle', id, vehicles);
}

/** A meaning that ends in who it is about, as "allowed by vehicle 3": what it says, and who; null if it is about nobody. */
export function about(meaning: string, vehicles: readonly VehicleSpec[]): { what: string; who: Who } | null {
  const found = /^(.*) (vehicle|contact|drifter) (\d+)$/.exec(meaning);
  return found === null ? null : { what: found[1]!, who: numbered(found[2]!, Number(found[3]), vehicles) };
}
