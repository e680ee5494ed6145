// SPDX-License-Identifier: Apache-2.0
// The whole page: header, contents, sections, footer.
import { Palette } from '../common/colour';
import { h, slug } from '../common/dom';
import { action_button, copy_text } from '../common/save';
import { theme_toggle } from '../common/theme';
import { block_element, Numbering, type Context } from './block';
import type { Palettes } from './charts/chart';
import { buoy } from '../common/buoy';
import type { Block, Document } from './model';

function all_blocks(blocks: Block[]): Block[] {
  return blocks.flatMap((block) => block.kind === 'grid' ? all_blocks(block.blocks) : [block]);
}

/** Colours in the order in which names first occur; vehicles have their own row of colours. */
function palettes_of(document: Document): Palettes {
  const palettes = { series: new Palette(), vehicles: new Palette() };
  const blocks = all_blocks(document.sections.flatMap((section) => section.blocks));
  for (const block of blocks) {
    if (block.kind === 'trajectories') palettes.vehicles.add(block.vehicles.map(({ label }) => label));
  }
  for (const block of blocks) {
    if (block.kind === 'boxes' || block.kind === 'intervals') palettes.series.add(block.series.map(({ label }) => label));
    if (block.kind !== 'lines' && block.kind !== 'raster') continue;
    const names = (block.kind === 'lines' ? block.series : block.marks).map(({ label }) => label);
    palettes.series.add(names.filter((name) => !palettes.vehicles.has(name)));
  }
  return palettes;
}

function unique_ids(document: Document): string[] {
  const used = new Set(['page', 'contents', 'fairway-data']);
  return document.sections.map((section) => {
    const wanted = slug(section.id || section.title);
    let id = wanted;
    for (let i = 2; used.has(id) || /^(figure|table)-\d/.test(id); ++i) id = `${wanted}-${i}`;
    used.add(id);
    return id;
  });
}

function header(document: Document): HTMLElement {
  const facts = document.facts.map(({ label, value }) => h('div', {}, h('dt', {}, label), h('dd', {}, value)));
  return h('header', { class: 'top' },
    h('div', { class: 'bar' }, h('span', { class: 'brand' }, buoy(), 'fairway report'), theme_toggle()),
    h('h1', {}, document.title),
    document.subtitle === '' ? null : h('p', { class: 'subtitle' }, document.subtitle),
    document.command === '' ? null : h('div', { class: 'command' }, h('code', {}, document.command),
      action_button('Copy', 'Copy the command', 'copied', () => copy_text(document.command))),
    facts.length === 0 ? null : h('dl', { class: 'facts' }, ...facts));
}

/** The contents, beside the text where there is room and folded above it where there is not. */
function contents(document: Document, ids: string[]): HTMLElement {
  const links = document.sections.map((section, i) => h('li', {}, h('a', { href: `#${ids[i]}` }, section.title)));
  const details = h('details', {}, h('summary', {}, 'Contents'), h('ol', {}, ...links));
  const wide = matchMedia('(min-width: 1080px)');
  const fold = (): void => { details.open = wide.matches; };
  wide.addEventListener('change', fold);
  fold();
  details.addEventListener('click', (event) => {
    if (!wide.matches && event.target instanceof HTMLAnchorElement) details.open = false;
  });
  return h('nav', { class: 'contents', id: 'contents', 'aria-label': 'Contents' }, details);
}

/** Marks the section that is being read. */
function follow_reading(sections: HTMLElement[], nav: HTMLElement): void {
  const links = [...nav.querySelectorAll('a')];
  const mark = (): void => {
    const line = window.innerHeight * 0.3;
    const last = sections.findLastIndex((section) => section.getBoundingClientRect().top <= line);
    const end = window.innerHeight + window.scrollY >= window.document.documentElement.scrollHeight - 2;
    const current = end ? sections.length - 1 : Math.max(0, last);
    links.forEach((link, i) => i === current ? link.setAttribute('aria-current', 'true') : link.removeAttribute('aria-current'));
  };
  addEventListener('scroll', mark, { passive: true });
  mark();
}

/** What the address names; nothing of an address that no page writes. */
function linked_element(): HTMLElement | null {
  try {
    return window.document.getElementById(decodeURIComponent(location.hash.slice(1)));
  } catch {
    return null;
  }
}

/** To what the address names, and there again while figures above get their heights, until the reader moves. */
function go_to_link(page: HTMLElement): void {
  const target = linked_element();
  if (target === null) return;
  const go = (): void => target.scrollIntoView({ behavior: 'instant' });
  go();
  const heights = new ResizeObserver(go);
  heights.observe(page);
  const stop = (): void => heights.disconnect();
  for (const moved of ['wheel', 'touchstart', 'pointerdown', 'keydown']) addEventListener(moved, stop, { once: true, passive: true });
  setTimeout(stop, 3000);
}

export function show_document(document: Document, into: HTMLElement): void {
  window.document.title = document.title;
  const context: Context = { palettes: palettes_of(document), numbering: new Numbering() };
  const ids = unique_ids(document);
  const sections = document.sections.map((section, i) => {
    const heading = h('h2', { id: `${ids[i]}-title` }, section.title,
      h('a', { class: 'anchor', href: `#${ids[i]}`, 'aria-label': `Link to ${section.title}` }, '#'));
    return h('section', { id: ids[i], 'aria-labelledby': `${ids[i]}-title` }, heading,
      ...section.paragraphs.map((text) => h('p', {}, text)),
      ...section.blocks.map((block) => block_element(block, context)));
  });
  const nav = contents(document, ids);
  into.replaceChildren(
    h('a', { class: 'skip', href: '#main' }, 'Skip to the text'),
    header(document),
    h('div', { class: 'columns' }, nav, h('main', { id: 'main', tabindex: -1 }, ...sections)),
    h('footer', {}, h('p', {}, document.version === '' ? 'Made by fairway.' : `Made by ${document.version}.`,
      ' This page is one file: it needs no network, and keeps working wherever it is copied.')));
  follow_reading(sections, nav);
  go_to_link(into);
}
