// SPDX-License-Identifier: Apache-2.0
// An image over velocities, turned as the vehicle is.
import { s } from '../../common/dom';
import { from_base64 } from '../film';
import { image_width, type ImageStroke } from '../model';

function pixels_of({ side, rgb }: ImageStroke): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  const bytes = from_base64(rgb);
  if (context === null || bytes.length < 3 * side * side) return canvas;
  const image = context.createImageData(side, side);
  for (let from = 0, to = 0; to < image.data.length; from += 3, to += 4) {
    image.data[to] = bytes[from]!;
    image.data[to + 1] = bytes[from + 1]!;
    image.data[to + 2] = bytes[from + 2]!;
    image.data[to + 3] = 255;
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

/** The image in a horizontal plane of `size` px that reaches so far [m/s]. */
export function image_under(stroke: ImageStroke, size: number, reach: number): SVGElement {
  const width = (image_width(stroke) / (2 * reach)) * size;
  return s('image', {
    href: pixels_of(stroke).toDataURL(), x: (size - width) / 2, y: (size - width) / 2, width, height: width,
    'image-rendering': 'pixelated', transform: `rotate(${(stroke.yaw * 180) / Math.PI} ${size / 2} ${size / 2})`,
  });
}
