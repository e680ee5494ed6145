// SPDX-License-Identifier: Apache-2.0
// The numbers in parts of a film, by the columns that the page's document names.
const bytes_of = { f64: 8, f32: 4, u8: 1 };

export function document_of(page) {
  const text = /<script id="fairway-data" type="application\/json">([\s\S]*?)<\/script>/.exec(page)?.[1];
  return JSON.parse(text);
}

/** Of each frame: its time, and the position of each vehicle. */
export function frames_of(parts, document) {
  const vehicles = document.scene.vehicles.length;
  return parts.flatMap((part) => {
    const bytes = Buffer.from(part.data, 'base64');
    const places = new Map();
    let at = 0;
    for (const column of document.columns) {
      places.set(column.name, at);
      at += part.count * bytes_of[column.type] * column.width * (column.per === 'vehicle' ? vehicles : 1);
    }
    if (at !== bytes.length) throw new Error(`a part of ${bytes.length} bytes; its columns take ${at}`);
    return Array.from({ length: part.count }, (_, i) => ({
      time: bytes.readDoubleLE(places.get('time_s') + 8 * i),
      positions: Array.from({ length: vehicles }, (_, v) =>
        [0, 1, 2].map((k) => bytes.readDoubleLE(places.get('position_m') + 8 * (3 * (vehicles * i + v) + k))),
      ),
    }));
  });
}
