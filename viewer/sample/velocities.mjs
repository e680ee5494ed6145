// SPDX-License-Identifier: Apache-2.0
// Invented velocity spaces for the sample: cones of velocities that end in contact, the rest by distance from one velocity.
const top_speed = 1.5;
const desired = { label: 'desired', x: 0.62, y: 0.95 };

const hex = (colour) => colour.map((part) => Math.round(part).toString(16).padStart(2, '0')).join('');
const mixed = (a, b, part) => a.map((value, i) => value + (b[i] - value) * part);

/** `cones` are [heading in rad from north, half width in rad]. */
export function velocity_image(title, cells, cones) {
  const value = (i) => ((2 * i + 1) / cells - 1) * top_speed;
  const in_contact = (x, y) => cones.some(([heading, half]) => {
    const ahead = (x - 0.1) * Math.sin(heading) + (y - 0.05) * Math.cos(heading);
    const aside = Math.abs((x - 0.1) * Math.cos(heading) - (y - 0.05) * Math.sin(heading));
    return ahead > 0.12 && Math.atan2(aside, ahead) < half;
  });
  const distance = (x, y) => Math.hypot(x - desired.x, y - desired.y);
  const reachable = (x, y) => Math.hypot(x, y) <= top_speed;
  let rgb = '';
  let chosen = null;
  for (let row = 0; row < cells; ++row) {
    for (let column = 0; column < cells; ++column) {
      const [x, y] = [value(column), -value(row)];
      const part = Math.min(1, distance(x, y) / 2.6);
      const free = reachable(x, y) && !in_contact(x, y);
      rgb += !reachable(x, y) ? 'e6e8e8' : hex(mixed(free ? [232, 243, 238] : [242, 190, 178], free ? [22, 58, 102] : [140, 42, 40], part));
      if (free && (chosen === null || distance(x, y) < distance(chosen.x, chosen.y))) chosen = { label: 'chosen', x, y };
    }
  }
  return {
    kind: 'raster', title, x_label: 'velocity east [m/s]', y_label: 'velocity north [m/s]',
    x: [-top_speed, top_speed], y: [-top_speed, top_speed], width: cells, height: cells, rgb,
    marks: [desired, chosen, { label: 'present', x: 0.35, y: 0.55 }],
  };
}
