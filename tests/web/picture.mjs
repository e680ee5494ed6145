// SPDX-License-Identifier: Apache-2.0
// Pictures of a page as pixels.

export const png_uri = (png) => `data:image/png;base64,${png.toString('base64')}`;

export class Picture {
  /** Of a data URI, as a page's browser reads it. */
  static async of(uri, page) {
    const { width, height, bytes } = await page.evaluate(async (uri) => {
      const image = new Image();
      image.src = uri;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
      canvas.drawImage(image, 0, 0);
      const { data } = canvas.getImageData(0, 0, image.width, image.height);
      let text = '';
      for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
      return { width: image.width, height: image.height, bytes: btoa(text) };
    }, uri);
    return Object.assign(new Picture(), { width, height, data: Buffer.from(bytes, 'base64') });
  }

  at(x, y) {
    const i = (Math.min(Math.max(0, Math.round(y)), this.height - 1) * this.width + Math.min(Math.max(0, Math.round(x)), this.width - 1)) * 4;
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
