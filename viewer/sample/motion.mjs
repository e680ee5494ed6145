// SPDX-License-Identifier: Apache-2.0
// Invented motion for the sample: vehicles that swap corners of a cube and swerve around its centre.
const round = (value) => Math.round(value * 1000) / 1000;

export function avoidance_runs() {
  const steps = 240;
  const duration = 118;
  const starts = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 10 : -10, i & 2 ? 10 : -10, i & 4 ? 22 : 2]);
  const vehicles = starts.map((start, i) => {
    const goal = [-start[0], -start[1], 24 - start[2]];
    const track = { label: `robot${i}`, n: [], e: [], d: [], t: [] };
    for (let k = 0; k <= steps; ++k) {
      const part = k / steps;
      // Slower in the middle, aside by a bell about the centre, a slow wobble on top.
      const along = part - 0.055 * Math.sin(2 * Math.PI * part);
      const bell = Math.exp(-(((part - 0.5 - 0.02 * (i - 3.5)) / 0.16) ** 2));
      const phase = i * 0.785 + 1.9 * part;
      const aside = (2.6 + 0.35 * (i % 3)) * bell;
      track.n.push(round(start[0] + (goal[0] - start[0]) * along + aside * Math.cos(phase)));
      track.e.push(round(start[1] + (goal[1] - start[1]) * along + aside * Math.sin(phase)));
      track.d.push(round(start[2] + (goal[2] - start[2]) * along + 0.8 * aside * Math.sin(phase + 1.1)));
      track.t.push(round(duration * part));
    }
    return track;
  });
  return {
    vehicles,
    goals: starts.map((start) => [-start[0], -start[1], 24 - start[2]]),
    spheres: [{ centre: [0, 0, 12], radius: 1.6, label: 'obstacle' }],
  };
}

export function gap_curves(methods) {
  return methods.map((label, m) => {
    const end = [118, 104, 141, 160][m];
    const [x, y] = [[], []];
    for (let t = 0; t <= end; t += 0.5) {
      const bell = Math.exp(-(((t - end * 0.48) / (end * 0.23)) ** 2));
      const ripple = 0.5 * Math.sin(t / 3.1 + m) * Math.sin(t / 7.3) * bell;
      x.push(t);
      y.push(m === 3 && t > 120 && t < 124 ? null : round(Math.max(1.9, 20 - (16.6 - 0.9 * m) * bell + 2.2 * ripple)));
    }
    return { label, x, y };
  });
}
