// SPDX-License-Identifier: Apache-2.0
// One HTML file out of a page, its scripts, styles and fonts; and data in it while developing.
import { readFileSync, writeFileSync } from 'node:fs';
import type { Plugin } from 'vite';

export const marker = '__FAIRWAY_DATA__';

// Nothing may be loaded from anywhere: the page says so itself, and browsers hold it to that.
const policy =
  "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; font-src data:";

// A page that is given its data here simulates, in a Worker that is inside it as well.
const simulating = policy.replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:");

/** Writes the built page to `target` with everything inlined, and with `data`, if it is there, in place of the marker; there is no other output. */
export function single_page(target: string, data?: string): Plugin {
  return {
    name: 'fairway-single-page',
    apply: 'build',
    enforce: 'post',
    generateBundle: {
      order: 'post',
      handler(_options, bundle) {
        const files = Object.values(bundle);
        const page = files.find((file) => file.fileName.endsWith('.html'));
        if (page?.type !== 'asset') throw new Error('the build made no page');
        let scripts = '';
        let styles = '';
        for (const file of files) {
          if (file.type === 'chunk') scripts += file.code;
          else if (file.fileName.endsWith('.css')) styles += String(file.source);
          else if (file !== page) throw new Error(`${file.fileName} would be a second file`);
          delete bundle[file.fileName];
        }
        if (scripts.includes(marker)) throw new Error('the marker for the data must not occur in a script');

        // Replacements are functions: code may contain "$&", which a replacement string would expand.
        const html = String(page.source)
          .replace(/\s*<link rel="(stylesheet|modulepreload)"[^>]*>/g, '')
          .replace(/\s*<script type="module"[^>]*src=[^>]*><\/script>/g, '')
          .replace('<head>', () => `<head>\n  <meta http-equiv="Content-Security-Policy" content="${data === undefined ? policy : simulating}">`)
          .replace('</head>', () => `  <style>${styles.trim()}</style>\n</head>`)
          .replace('</body>', () => {
            const code = scripts.trim().replaceAll('</script', '<\\/script').replaceAll('<!--', '\\x3C!--');
            return `<script type="module">${code}</script>\n</body>`;
          });
        if (html.split(marker).length !== 2) throw new Error(`the page needs ${marker} once`);
        const filled = data === undefined ? html : html.replace(marker, () => data.replaceAll('</', '<\\/').replaceAll('<!', '\\u003c!'));
        writeFileSync(target, filled.endsWith('\n') ? filled : filled + '\n');
        this.info(`${target}: ${(html.length / 1000).toFixed(1)} kB`);
      },
    },
  };
}

/** While developing, the marker of each page is replaced with the data of a page that fairway made. */
export function data_of(made: (page: string) => string): Plugin {
  const data = /<script id="fairway-data" type="application\/json">([^]*?)<\/script>/;
  return {
    name: 'fairway-data',
    apply: 'serve',
    transformIndexHtml: (html, { path }) =>
      html.replace(marker, () => data.exec(readFileSync(made(path.replace(/^\/|\.html$/g, '')), 'utf8'))?.[1] ?? marker),
  };
}
