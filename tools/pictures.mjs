// SPDX-License-Identifier: Apache-2.0
// Draws the pictures listed in docs/images/pictures.json, or with --check compares them with what is there.
//
// A picture is a command that writes a page, and what of it is photographed:
//   {"name", "program"?, "commands": [[word...]...], "page", "size": [width, height], "scheme"?, "hash"?, "clip"?: css selector,
//    "moving"?: {"from_s", "to_s", "frames", "frame_ms", "quality"}}
// `program`, of build/bin, is fairway unless another is named. Words may hold {dir}, a scratch folder. `hash` is the page's fragment: moment, vehicles, camera, layers. What is `moving` is a playback
// photographed at as many instants as it has frames, from one to the other; when checked, at five of them.
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

function run(program, words, accepted) {
  const { status, error } = spawnSync(program, words, { cwd: root, stdio: ['ignore', 'ignore', 'inherit'] });
  if (!accepted.includes(status)) throw new Error(`${program} ${words.join(' ')} ended with ${error ?? status}`);
}

/** Makes the page and photographs it: once, or the frames of these numbers. */
async function photograph({ program = 'fairway', commands, page: name, size: [width, height], scheme = 'light', hash = '', clip, moving }, frames) {
  // 1: an expectation of the scenario failed, which under another method it may.
  for (const command of commands) run(join(root, 'build/bin', program), command.map((word) => word.replaceAll('{dir}', folder)), [0, 1]);
  // A still is drawn twice as fine, then made smaller: edges come out smooth although the processor draws them.
  const context = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: moving === undefined ? 2 : 1, colorScheme: scheme, reducedMotion: 'reduce' });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);  // of a machine that is busy besides
    await page.goto(pathToFileURL(name.replaceAll('{dir}', folder)).href + hash);
    await page.waitForSelector('main');
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(1500);
    // A part of a report that the fragment names: what is above it takes its size only as it is drawn.
    await page.evaluate(() => window.document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView());
    await page.waitForTimeout(500);
    const drawn = [];
    for (const frame of frames) {
      if (moving !== undefined) {
        const { from_s, to_s, frames: count } = moving;
        await page.evaluate((time) => {
          window.fairway.seek(time);
          return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        }, from_s + (to_s - from_s) * frame / (count - 1));
      }
      const part = clip === undefined ? {} : { clip: await page.locator(clip).first().boundingBox() };
      const picture = await page.screenshot({ type: 'png', timeout: 0, ...part });
      drawn.push(moving === undefined ? await halved(picture) : picture);
    }
    return drawn;
  } finally {
    await context.close();
  }
}

/** The file of a moving picture. */
function put_together(drawn, { frame_ms, quality }) {
  const names = drawn.map((frame, index) => {
    const file = join(folder, `frame${index}.png`);
    writeFileSync(file, frame);
    return file;
  });
  const file = join(folder, 'moving.webp');
  run('img2webp', ['-lossy', '-q', `${quality}`, '-m', '6', '-d', `${frame_ms}`, ...names, '-o', file], [0]);
  return readFileSync(file);
}

/** Mean difference of a frame of a picture and a new one, of the whole range of colours; 1 where their sizes differ. */
async function difference(there, frame, drawn) {
  const page = await browser.newPage();
  try {
    await page.goto(pathToFileURL(join(images, 'pictures.json')).href);  // decoders are for pages that have an address
    return await page.evaluate(async (sources) => {
      const [a, b] = await Promise.all(sources.map(async ([source, frameIndex, type]) => {
        const data = Uint8Array.from(atob(source), (letter) => letter.charCodeAt(0));
        const { image } = await new ImageDecoder({ data, type }).decode({ frameIndex });
        const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, canvas.width, canvas.height);
      }));
      if (a.width !== b.width || a.height !== b.height) return 1;
      let sum = 0;
      for (let i = 0; i < a.data.length; ++i) sum += Math.abs(a.data[i] - b.data[i]);
      return sum / a.data.length / 255;
    }, [[there.toString('base64'), frame, 'image/webp'], [drawn.toString('base64'), 0, drawn[0] === 0x89 ? 'image/png' : 'image/webp']]);
  } finally {
    await page.close();
  }
}

let stale = 0;
try {
  for (const picture of all.filter(({ name }) => names.length === 0 || names.includes(name))) {
    const file = join(images, `${picture.name}.webp`);
    const { moving } = picture;
    const count = moving?.frames ?? 1;
    const frames = moving !== undefined && checking ? [0, 1, 2, 3, 4].map((part) => Math.round(part * (count - 1) / 4)) : [...Array(count).keys()];
    const drawn = await photograph(picture, frames);
    if (!checking) {
      const whole = moving === undefined ? drawn[0] : put_together(drawn, moving);
      writeFileSync(file, whole);
      console.log(`${picture.name}: ${Math.round(whole.length / 1000)} kB`);
      continue;
    }
    const there = readFileSync(file);
    let differs = 0;
    for (const [at, frame] of frames.entries()) differs = Math.max(differs, await difference(there, frame, drawn[at]));
    console.log(`${picture.name}: differs by ${(100 * differs).toFixed(2)} %`);
    if (differs > tolerance) ++stale;
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
if (stale > 0) console.error(`${stale} pictures have gone stale: scripts/pictures draws them anew`);
process.exit(stale > 0 ? 1 : 0);
