// SPDX-License-Identifier: Apache-2.0
// Draws the pictures listed in docs/images/pictures.json, or with --check compares them with what is there.
//
// A picture is a command that writes a page, and what of it is photographed:
//   {"name", "commands": [[word...]...], "page", "size": [width, height], "scheme"?, "hash"?, "clip"?: css selector}
// Words may hold {dir}, a scratch folder. `hash` is the page's fragment: moment, vehicles, camera, layers.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('../', import.meta.url));
const { chromium } = createRequire(join(root, 'viewer/package.json'))('playwright-core');
const images = join(root, 'docs/images');

/** Share of the colour range by which a picture may differ from a new one: other fonts and rasterisers do. */
const tolerance = 0.02;

const words = process.argv.slice(2);
const checking = words[0] === '--check';
const names = checking ? words.slice(1) : words;
const all = JSON.parse(readFileSync(join(images, 'pictures.json'), 'utf8'));
const unknown = names.find((name) => !all.some((picture) => picture.name === name));
if (unknown !== undefined) {
  console.error(`scripts/pictures: no picture is called ${unknown}; there are ${all.map(({ name }) => name).join(', ')}`);
  process.exit(2);
}

const folder = mkdtempSync(join(tmpdir(), 'fairway-pictures-'));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars'],
});

/** A picture of half as many pixels in each direction, as WebP. */
async function halved(picture) {
  const page = await browser.newPage();
  try {
    const smaller = await page.evaluate(async (source) => {
      const image = new Image();
      image.src = `data:image/png;base64,${source}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [image.width / 2, image.height / 2];
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      return canvas.toDataURL('image/webp', 0.92).split(',')[1];
    }, picture.toString('base64'));
    return Buffer.from(smaller, 'base64');
  } finally {
    await page.close();
  }
}

/** Makes the page and photographs it. */
async function photograph({ commands, page: name, size: [width, height], scheme = 'light', hash = '', clip }) {
  for (const command of commands) {
    const filled = command.map((word) => word.replaceAll('{dir}', folder));
    const { status } = spawnSync(join(root, 'build/bin/fairway'), filled, { cwd: root, stdio: ['ignore', 'ignore', 'inherit'] });
    // 1: an expectation of the scenario failed, which under another method it may.
    if (status !== 0 && status !== 1) throw new Error(`fairway ${filled.join(' ')} ended with ${status}`);
  }
  // Twice as fine, then made smaller: edges come out smooth although the processor draws them.
  const context = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: 2, colorScheme: scheme, reducedMotion: 'reduce' });
  try {
    const page = await context.newPage();
    await page.goto(pathToFileURL(name.replaceAll('{dir}', folder)).href + hash);
    await page.waitForSelector('main');
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(1500);
    return await halved(await (clip === undefined ? page : page.locator(clip).first()).screenshot({ type: 'png' }));
  } finally {
    await context.close();
  }
}

/** Mean difference of two pictures, of the whole range of colours; 1 where their sizes differ. */
async function difference(one, other) {
  const page = await browser.newPage();
  try {
    return await page.evaluate(async (sources) => {
      const [a, b] = await Promise.all(sources.map(async (source) => {
        const image = new Image();
        image.src = `data:image/webp;base64,${source}`;
        await image.decode();
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      }));
      if (a.width !== b.width || a.height !== b.height) return 1;
      let sum = 0;
      for (let i = 0; i < a.data.length; ++i) sum += Math.abs(a.data[i] - b.data[i]);
      return sum / a.data.length / 255;
    }, [one.toString('base64'), other.toString('base64')]);
  } finally {
    await page.close();
  }
}

let stale = 0;
try {
  for (const picture of all.filter(({ name }) => names.length === 0 || names.includes(name))) {
    const file = join(images, `${picture.name}.webp`);
    const drawn = await photograph(picture);
    if (!checking) {
      writeFileSync(file, drawn);
      console.log(`${picture.name}: ${Math.round(drawn.length / 1000)} kB`);
      continue;
    }
    const differs = await difference(readFileSync(file), drawn);
    console.log(`${picture.name}: differs by ${(100 * differs).toFixed(2)} %`);
    if (differs > tolerance) ++stale;
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
if (stale > 0) console.error(`${stale} pictures have gone stale: scripts/pictures draws them anew`);
process.exit(stale > 0 ? 1 : 0);
