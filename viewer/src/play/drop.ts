// SPDX-License-Identifier: Apache-2.0
// Files that are dropped on the page, wherever: a browser would open them in its place.

const holds_files = ({ dataTransfer }: DragEvent): boolean => dataTransfer?.types.includes('Files') ?? false;

/** `take` hears of what is dropped on this window. */
export function take_drops(on: Window, take: (file: File) => void): void {
  on.addEventListener('dragover', (event) => {
    if (holds_files(event)) event.preventDefault();
  });
  on.addEventListener('drop', (event) => {
    if (!holds_files(event)) return;
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file !== undefined) take(file);
  });
}
