// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { play_data } from './bundle/play_data.ts';
import { data_of, single_page } from './bundle/single_page.ts';

// One page per mode: `vite build --mode report` makes report.html into the template that the C++ library
// fairway/report embeds, and so on; of play it makes the page itself, with its data.
const templates: Record<string, string> = {
  report: '../fairway/report/template.html',
  view: '../fairway/view/template.html',
  play: '../out/play.html',
};
// Of scripts/demo: their data are shown while developing.
const demo: Record<string, string> = { report: '../out/cubes/report.html', view: '../out/cube20_8.html' };
const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig(({ mode, command }) => {
  const template = templates[mode];
  if (command === 'build' && template === undefined) throw new Error(`no page is called ${mode}`);
  return {
    base: './',
    publicDir: false as const,
    build: {
      target: 'es2022',
      assetsInlineLimit: 1_000_000,
      cssCodeSplit: false,
      modulePreload: false,
      write: false,
      reportCompressedSize: false,
      rollupOptions: { input: here(`./${command === 'build' ? mode : 'report'}.html`) },
    },
    plugins: [data_of((page) => here(demo[page] ?? '')), ...(template ? [single_page(here(template), mode === 'play' ? play_data(here('../')) : undefined)] : [])],
  };
});
