// SPDX-License-Identifier: Apache-2.0
// Pictures of a page as pixels: reads the PNG that the browser makes of what it shows.
import { inflateSync } from 'node:zlib';

/** Of the byte before, above and diagonally before, the one nearest to their plane. */
function paeth(a, b, c) {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/** 8 bits a channel, RGB or RGBA, not interlaced, which is what Chromium writes. */
export class Picture {
  constructor(png) {
    this.width = png.readUInt32BE(16);
    this.height = png.readUInt32BE(20);
    this.channels = { 2: 3, 6: 4 }[png[25]];
    if (png[24] !== 8 || this.channels === undefined || png[28] !== 0) throw new Error('a PNG of another kind');
    const parts = [];
    for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
      if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
    }
    this.unfilter(inflateSync(Buffer.concat(parts)));
  }

  unfilter(raw) {
    const step = this.channels;
    const stride = this.width * step;
    this.data = Buffer.alloc(stride * this.height);
    for (let y = 0; y < this.height; ++y) {
      const filter = raw[y * (stride + 1)];
      const row = y * stride;
      for (let x = 0; x < stride; ++x) {
        const left = x < step ? 0 : this.data[row + x - step];
        const up = y === 0 ? 0 : this.data[row + x - stride];
        const corner = x < step || y === 0 ? 0 : this.data[row + x - stride - step];
        const from = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
        this.data[row + x] = raw[y * (stride + 1) + 1 + x] + from;
      }
    }
  }

  at(x, y) {
    const i = (Math.min(Math.max(0, Math.round(y)), this.height - 1) * this.width + Math.min(Math.max(0, Math.round(x)), this.width - 1)) * this.channels;
    return [this.data[i], this.data[i + 1], this.data[i + 2]];
  }

  /** The colours within a radius of a point that lie inside the picture. */
  disc({ x, y }, radius) {
    const found = [];
    for (let dy = -radius; dy <= radius; ++dy) {
      for (let dx = -radius; dx <= radius; ++dx) {
        const [px, py] = [Math.round(x + dx), Math.round(y + dy)];
        const inside = px >= 0 && py >= 0 && px < this.width && py < this.height;
        if (inside && dx * dx + dy * dy <= radius * radius) found.push(this.at(px, py));
      }
    }
    return found;
  }

  /** Pixels of which some channel differs by more than `least`. */
  differs_from(other, least = 6) {
    if (other.width !== this.width || other.height !== this.height) return Infinity;
    let count = 0;
    for (let y = 0; y < this.height; ++y) for (let x = 0; x < this.width; ++x) {
      if (distance(this.at(x, y), other.at(x, y)) > least) ++count;
    }
    return count;
  }

  /** How many different colours, coarsely; a picture of nothing has one or two. */
  colours() {
    const seen = new Set();
    for (let y = 0; y < this.height; y += 2) for (let x = 0; x < this.width; x += 2) seen.add(this.at(x, y).map((part) => part >> 3).join());
    return seen.size;
  }
}

/** The largest difference of a channel. */
export function distance(a, b) {
  return Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]), Math.abs(a[2] - b[2]));
}

/** Degrees, or null of a colour that is nearly grey. */
export function hue([r, g, b]) {
  const most = Math.max(r, g, b);
  const range = most - Math.min(r, g, b);
  if (range < 18 || range < 0.2 * most) return null;
  const sixth = most === r ? ((g - b) / range + 6) % 6 : most === g ? (b - r) / range + 2 : (r - g) / range + 4;
  return 60 * sixth;
}
