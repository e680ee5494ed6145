// SPDX-License-Identifier: Apache-2.0
// A real browser for the tests of the pages: opens each with a fresh profile, notes what it complains about, and counts
// what held. Needs `npm ci` in viewer/ and a Chromium (CHROMIUM names another one than /usr/bin/chromium).
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const root = fileURLToPath(new URL('../../', import.meta.url));
const { chromium } = createRequire(join(root, 'viewer/package.json'))('playwright-core');

/** [PAGE.html] [--screenshots DIR] of the command line, null where not given. */
export function command_line() {
  const words = process.argv.slice(2);
  const flag = words.indexOf('--screenshots');
  const screenshots = flag < 0 ? null : resolve(words.splice(flag, 2)[1] ?? '.');
  if (screenshots !== null) mkdirSync(screenshots, { recursive: true });
  return { path: words[0] === undefined ? null : resolve(words[0]), screenshots };
}

export class Browser {
  folder = mkdtempSync(join(tmpdir(), 'fairway-web-'));
  failures = [];
  held = 0;

  /** `template` is a path below the root; `harmless` a pattern of complaints that are none. */
  constructor(template, flags, harmless = /^\b$/) {
    Object.assign(this, { template, flags, harmless });
  }

  /** The template filled with a document. */
  render(json) {
    const safe = json.replaceAll('</', '<\\/').replaceAll('<!', '\\u003c!');
    return readFileSync(join(root, this.template), 'utf8').replace('__FAIRWAY_DATA__', () => safe);
  }

  write(name, json) {
    const path = join(this.folder, name);
    writeFileSync(path, this.render(json));
    return path;
  }

  /** For a check called `name`: counts, or keeps what did not hold. */
  expecting(name) {
    return (condition, what) => {
      if (condition) ++this.held;
      else this.failures.push(`${name}: ${what}`);
    };
  }

  /** The one program that opens all pages. */
  program() {
    this.started ??= chromium.launch({
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, timeout: 120_000,
      args: ['--no-sandbox', '--disable-dev-shm-usage', '--disable-background-networking',
        '--disable-component-update', '--disable-sync', '--no-first-run', ...this.flags],
    });
    return this.started;
  }

  /** Opens a path or an address and hands the page to `look`; only an address may ask for more, from where it came. A browser without `missing` is one
   *  whose window has nothing of that name; without 'WebGL', whose canvas has no such context. */
  async open(target, name, { width, height = 900, scheme, fragment = '', harmless = this.harmless, missing = '' }, look) {
    const url = target.startsWith('http:') ? target : pathToFileURL(target).href + fragment;
    const allowed = target.startsWith('http:') ? [new URL(target).origin] : [];
    const context = await (await this.program()).newContext({ viewport: { width, height }, colorScheme: scheme, acceptDownloads: true });
    const complaints = [];
    const complain = (text) => { if (!harmless.test(text)) complaints.push(text); };
    const expect = this.expecting(name);
    try {
      const page = await context.newPage();
      page.on('console', (message) => {
        if (['error', 'warning'].includes(message.type())) complain(`console ${message.type()}: ${message.text()}`);
      });
      page.on('pageerror', (error) => complain(`page error: ${error.message}`));
      page.on('request', (request) => {
        const address = request.url();
        if (!/^(file|data|blob):/.test(address) && !allowed.includes(new URL(address).origin)) complain(`network request: ${address}`);
      });
      page.setDefaultTimeout(120_000);  // of a machine that is half as fast and busy besides
      page.setDefaultNavigationTimeout(120_000);
      if (missing === 'WebGL') {
        await page.addInitScript(() => {
          const context = HTMLCanvasElement.prototype.getContext;
          HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind.startsWith('webgl') ? null : context.call(this, kind, ...more); };
        });
      } else if (missing !== '') {
        await page.addInitScript((name) => { delete window[name]; }, missing);
      }
      await page.goto(url);
      await page.waitForSelector('main');
      await page.evaluate(() => document.fonts.ready);
      await look(page, expect, context);
      expect(complaints.length === 0, complaints.join('; '));
    } catch (error) {
      expect(false, `the test stopped: ${error.stack}`);
    } finally {
      await context.close();
    }
  }

  /** Says what did not hold, and ends with 1 if there was any. */
  finish() {
    rmSync(this.folder, { recursive: true, force: true });
    for (const failure of this.failures) console.log(`FAILED ${failure}`);
    console.log(`${this.held} checks held, ${this.failures.length} failed`);
    process.exit(this.failures.length === 0 ? 0 : 1);
  }
}
