// SPDX-License-Identifier: Apache-2.0
import { s } from './dom';

/** The mark of the page: a safe-water buoy, red and white in vertical stripes, as it stands in a fairway. */
export function buoy(): SVGElement {
  return s('svg', { class: 'buoy', viewBox: '0 0 24 24', width: 22, height: 22, 'aria-hidden': 'true' },
    s('circle', { class: 'red', cx: 12, cy: 3.2, r: 2.4 }),
    s('path', { class: 'outline', d: 'M12 5.5V9' }),
    s('path', { class: 'white', d: 'M8 9h8l2 9.5H6Z' }),
    s('path', { class: 'red', d: 'M8 9h2.4l-1 9.5H6ZM13.6 9H16l2 9.5h-3.4Z' }),
    s('path', { class: 'outline', d: 'M8 9h8l2 9.5H6Z' }),
    s('path', { class: 'water', d: 'M1 20.5c1.8 0 1.8 1.4 3.7 1.4s1.8-1.4 3.6-1.4s1.8 1.4 3.7 1.4s1.8-1.4 3.7-1.4s1.8 1.4 3.6 1.4s1.8-1.4 3.7-1.4' }));
}
