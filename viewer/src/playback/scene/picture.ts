// SPDX-License-Identifier: Apache-2.0
import type { PlacedLabel } from './labels';

/** The canvas with the labels that are laid over it, as a PNG of the canvas' own resolution. */
export function picture_of(canvas: HTMLCanvasElement, labels: readonly PlacedLabel[], halo: string): Promise<Blob> {
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  const pen = copy.getContext('2d');
  if (pen === null) throw new Error('the browser cannot draw a picture');
  pen.drawImage(canvas, 0, 0);
  const ratio = canvas.width / Math.max(1, canvas.clientWidth);
  pen.scale(ratio, ratio);
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  for (const { text, x, y, element } of labels) {
    const style = getComputedStyle(element);
    pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    pen.lineWidth = 3;
    pen.strokeStyle = halo;
    pen.strokeText(text, x, y + 7);
    pen.fillStyle = style.color;
    pen.fillText(text, x, y + 7);
  }
  return new Promise((resolve, reject) => {
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the browser made no picture'))), 'image/png');
  });
}
