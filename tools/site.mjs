// SPDX-License-Identifier: Apache-2.0
// The documents as a static site in out/site, with the page that plays beside them: node tools/site.mjs, called by scripts/web. Every Markdown file
// that git knows becomes a page; what they link to comes along; a link that leads nowhere ends it. The page of a method or vehicle links to that
// one, live in a scenario that has it.
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, posix, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Simulator } from '../bindings/web/module.mjs';

const root = fileURLToPath(new URL('../', import.meta.url));
const out = join(root, 'out/site');
const { Marked } = createRequire(join(root, 'viewer/package.json'))('marked');
const text = (path) => readFileSync(join(root, path), 'utf8');
const tracked = new Set(execFileSync('git', ['-C', root, 'ls-files', '--cached', '--others', '--exclude-standard'], { encoding: 'utf8' }).split('\n').filter(Boolean));
const pages = [...tracked].filter((path) => path.endsWith('.md') && existsSync(join(root, path)));
const page_of = (path) => path.replace(/\.md$/, '.html');
const escaped = (words) => words.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** As GitHub names a heading, for links to it. */
const slug = (heading) => heading.toLowerCase().replace(/<[^>]*>|[^\p{L}\p{N}\s_-]/gu, '').trim().replaceAll(' ', '-');

const broken = [];
const taken_along = new Set();
const anchors = new Map();
const wanted_anchors = [];

/** What a link of the page `from` is in the site. */
function linked(from, href) {
  if (/^[a-z]+:/i.test(href)) return href;
  const [path, anchor] = href.split('#');
  const target = path === '' ? from : posix.normalize(posix.join(posix.dirname(from), path)).replace(/\/$/, '');
  const there = tracked.has(target) ? target : tracked.has(`${target}/README.md`) ? `${target}/README.md` : null;
  const is_folder = there === null && [...tracked].some((each) => each.startsWith(`${target}/`));
  if (there === null && !is_folder) {
    broken.push(`${from}: ${href}`);
    return href;
  }
  if (is_folder || !there.endsWith('.md')) taken_along.add(is_folder ? `${target}/` : there);
  else if (anchor !== undefined) wanted_anchors.push([from, there, anchor]);
  const goal = is_folder ? `${target}/index.html` : page_of(there);
  return (posix.relative(posix.dirname(from), goal) || posix.basename(goal)) + (anchor === undefined ? '' : `#${anchor}`);
}

function rendered(from) {
  const ids = new Map();
  const marked = new Marked({
    gfm: true,
    walkTokens(token) {
      if (token.type === 'link' || token.type === 'image') token.href = linked(from, token.href);
    },
    renderer: {
      heading({ tokens, depth, text: words }) {
        const base = slug(words);
        const seen = ids.get(base) ?? 0;
        ids.set(base, seen + 1);
        const id = seen === 0 ? base : `${base}-${seen}`;
        return `<h${depth} id="${id}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
    },
  });
  const html = marked.parse(text(from));
  anchors.set(from, new Set([...html.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id)));
  return html;
}

function written(path, title, body, live = '') {
  const up = posix.relative(posix.dirname(path), '.') || '.';
  const target = join(out, path);
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark">
<title>${escaped(title)}</title><link rel="icon" href="data:,"><link rel="stylesheet" href="${up}/site.css"></head>
<body><nav><a href="${up}/index.html"><b>Fairway</b></a><a href="${up}/docs/README.html">Documents</a><a class="play" href="${up}/play.html">Play it here</a></nav>
<main>${live}${body}</main></body></html>
`);
}

/** For each name of a method or vehicle, the address at which it plays; of what cannot run in a browser there is none. */
function live_addresses() {
  const simulator = new Simulator(new WebAssembly.Module(readFileSync(join(root, 'build/web/fairway.wasm'))));
  const { algorithms, vehicles } = simulator.names();
  const scenarios = [...['scenarios', 'scenarios/failures'].flatMap((folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith('.yaml')).sort()
    .map((name) => `${folder}/${name}`))];
  const address = (scenario, set) => {
    try {
      simulator.load({ yaml: text(scenario), file: scenario, set, filmed: false });
      simulator.run(20);
      return { scenario, link: `#${new URLSearchParams([['scenario', scenario], ...set.map((change) => ['set', change.join('=')])])}`, scene: simulator.document().scene };
    } catch {
      return null;
    }
  };
  const shipped = scenarios.map((path) => address(path, [])).filter((found) => found !== null);
  const first = (has) => shipped.find(({ scene }) => scene.vehicles.some(has)) ?? null;
  const addresses = new Map();
  for (const { name, wraps } of algorithms) {
    const found = first(({ avoider }) => avoider === name || (wraps && avoider.split('+').includes(name)));
    addresses.set(name, found ?? address('scenarios/swap_8.yaml', [['vehicles[*].avoider', wraps ? `orca3d+${name}` : name]]));
  }
  for (const { name } of vehicles) addresses.set(name, first(({ model }) => model === name));
  return addresses;
}

function live_link(path, addresses) {
  const folder = /^fairway\/(?:avoidance|planning|dynamics)\/(\w+)\/README\.md$/.exec(path)?.[1];
  if (folder === undefined) return '';
  const name = [...addresses.keys()].find((each) => (each === folder || each.startsWith(`${folder}_`)) && addresses.get(each) !== null);
  if (name === undefined) return '';
  const found = addresses.get(name);
  const up = posix.relative(posix.dirname(path), '.');
  return `<p class="live"><a href="${escaped(`${up}/play.html${found.link}`)}">See ${escaped(name)} live</a>, in ${escaped(posix.basename(found.scenario, '.yaml'))}: the simulator runs in that page.</p>\n`;
}

/** How many of them have something live. */
function write_pages() {
  const addresses = live_addresses();
  let live = 0;
  for (const path of pages) {
    const body = rendered(path);
    const link = live_link(path, addresses);
    if (link !== '') ++live;
    written(page_of(path), /^# (.+)$/m.exec(text(path))?.[1] ?? path, body, link);
  }
  return live;
}

/** Of each folder that is linked to, a list of what is in it; all of that comes along. */
function write_folders() {
  for (const path of [...taken_along].filter((each) => each.endsWith('/'))) {
    const inside = [...tracked].filter((each) => each.startsWith(path)).sort();
    const entry = (each) => `<li><a href="${escaped(posix.relative(path, page_of(each)))}">${escaped(posix.relative(path, each))}</a></li>`;
    written(`${path}index.html`, path, `<h1>${escaped(path)}</h1><ul>${inside.map(entry).join('')}</ul>`);
    taken_along.delete(path);
    for (const each of inside) if (!each.endsWith('.md')) taken_along.add(each);
  }
}

function take_along() {
  for (const path of taken_along) {
    mkdirSync(dirname(join(out, path)), { recursive: true });
    cpSync(join(root, path), join(out, path));
  }
}

rmSync(out, { recursive: true, force: true });
const live = write_pages();
write_folders();
take_along();
for (const [from, there, anchor] of wanted_anchors) if (!anchors.get(there)?.has(anchor)) broken.push(`${from}: ${there}#${anchor}`);
writeFileSync(join(out, 'site.css'), text('viewer/src/common/tokens.css').replace(/@font-face\s*\{[^}]*\}/g, '') + text('tools/site.css'));
cpSync(join(root, 'out/play.html'), join(out, 'play.html'));
cpSync(join(out, 'README.html'), join(out, 'index.html'));
const size = execFileSync('du', ['-sm', out], { encoding: 'utf8' }).split('\t')[0];
console.log(`${relative(root, out)}: ${pages.length} pages, ${live} of them with a method or vehicle live, ${size} MB`);
for (const line of broken) console.error(`a link that leads nowhere: ${line}`);
process.exit(broken.length === 0 ? 0 : 1);
