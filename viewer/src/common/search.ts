// SPDX-License-Identifier: Apache-2.0

/** The first of 0 .. count - 1 for which `holds`, which then holds for all that follow; `count` where there is none. O(log count). */
export function first_index(count: number, holds: (i: number) => boolean): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
