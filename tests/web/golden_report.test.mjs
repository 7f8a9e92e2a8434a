// The report of golden pictures in a browser: what it shows, and its wipe.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { Browser, chromiumPath } from './browser.js';
import { pngPixels } from './png_pixels.mjs';

const program = process.env.AFTERGLOW;
const skip = !program ? 'AFTERGLOW is not set' : chromiumPath() ? false : 'chromium is not installed';
const folder = mkdtempSync(join(tmpdir(), 'afterglow-golden-'));
const wipe = '#moved .wipe div';
/** @type {Browser} */
let browser;

/** Writes a look of one gray from 0 to 1. */
function writeLook(name, gray) {
    const look = join(folder, 'looks', name);
    mkdirSync(look, { recursive: true });
    writeFileSync(join(look, 'look.json'), JSON.stringify({ format: 'afterglow-look', version: 1, name,
        driven_by: 'nothing', passes: [{ name: 'show', fragment: 'show.frag' }] }));
    writeFileSync(join(look, 'show.frag'),
        `#version 410 core\nout vec4 color;\nvoid main() { color = vec4(vec3(${gray}), 1.0); }\n`);
}

function golden(...words) {
    return spawnSync(program, ['golden', 'looks', ...words], { cwd: folder, encoding: 'utf8' });
}

before(async () => {
    if (skip) return;
    writeLook('moved', 0.2);
    writeLook('same', 0.5);
    assert.equal(golden('--size', '64x36', '--update').status, 0);
    writeLook('moved', 0.6);
    assert.equal(golden().status, 1);
    browser = await Browser.launch();
    await browser.open(`file://${join(folder, 'golden', 'report.html')}`);
});

after(async () => {
    if (browser) await browser.close();
    rmSync(folder, { recursive: true, force: true });
});

/** The position of the wipe in percent. */
async function position() {
    const text = await browser.evaluate(
        `getComputedStyle(document.querySelector(${JSON.stringify(wipe)})).getPropertyValue('--at')`);
    return parseFloat(text);
}

/** The red byte of the page at a fraction of the width of the wipe. */
async function grayAt(across) {
    const { x, y } = await browser.placeOf(wipe, across, 0.5);
    const { width, values, channels } = pngPixels(await browser.screenshot());
    return values[(Math.round(y) * width + Math.round(x)) * channels];
}

test('differing pictures are open, equal ones closed until they are clicked', { skip }, async () => {
    const isOpen = (id) => browser.evaluate(`document.getElementById('${id}').open`);
    assert.deepEqual([await isOpen('moved'), await isOpen('same')], [true, false]);
    await browser.click('#same summary');
    assert.equal(await isOpen('same'), true);
    const sizes = await browser.evaluate(
        '[...document.images].map((image) => [image.naturalWidth, image.naturalHeight])');
    assert.equal(sizes.length, 9);
    for (const size of sizes) assert.deepEqual(size, [64, 36]);
    await browser.click('button[value=close]');
    assert.deepEqual([await isOpen('moved'), await isOpen('same')], [false, false]);
    await browser.click('button[value=open]');
    assert.deepEqual(browser.errors, []);
});

test('the wipe follows the mouse, the keyboard and a finger', { skip }, async () => {
    const at = (across) => browser.placeOf(wipe, across).then(({ x, y }) => [x, y]);
    await browser.drag([await at(0.5), await at(0.4), await at(0.25)]);
    assert.ok(Math.abs(await position() - 25) < 1, `${await position()} %`);
    assert.deepEqual([await grayAt(0.1), await grayAt(0.4)], [51, 153]);
    await browser.mouse('mouseMoved', ...await at(0.9));
    const before = await position();
    assert.ok(before < 30);
    await browser.key('ArrowRight');
    assert.equal(await position(), Math.round(before) + 1);
    await browser.resize({ width: 400, height: 800, mobile: true });
    await browser.touch([[await at(0.3)], [await at(0.5)], [await at(0.8)]]);
    assert.ok(Math.abs(await position() - 80) < 1, `${await position()} %`);
    assert.deepEqual([await grayAt(0.7), await grayAt(0.9)], [51, 153]);
    const width = await browser.evaluate('document.documentElement.scrollWidth');
    assert.equal(width, 400);
});

test('the report needs no other file', { skip }, () => {
    const html = readFileSync(join(folder, 'golden', 'report.html'), 'utf8');
    assert.doesNotMatch(html, /(?:src|href)\s*=\s*["'](?!data:)|https?:/);
});
