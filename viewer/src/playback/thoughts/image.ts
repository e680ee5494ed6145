// SPDX-License-Identifier: Apache-2.0
// An image over velocities, turned as the vehicle is.
import { from_base64 } from '../film';
import { image_width, type ImageStroke } from '../model';

export function pixels_of({ side, rgb }: ImageStroke): HTMLCanvasElement {
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

/** Paints the image below a horizontal plane of `size` px that reaches so far [m/s]. */
export function paint_image(canvas: HTMLCanvasElement, stroke: ImageStroke | null, size: number, reach: number): void {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = canvas.height = Math.round(size * ratio);
  canvas.style.width = canvas.style.height = `${size}px`;
  const context = canvas.getContext('2d');
  if (stroke === null || context === null) return;
  const width = (image_width(stroke) / (2 * reach)) * canvas.width;
  context.imageSmoothingEnabled = false;
  context.translate(canvas.width / 2, canvas.height / 2);
  context.rotate(stroke.yaw);
  context.drawImage(pixels_of(stroke), -width / 2, -width / 2, width, width);
}
