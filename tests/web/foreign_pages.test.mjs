// Pages of looks in the formats of other programs, drawn by Chromium and compared with the program.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { ConstantChanges } from '../../app/web/player/constant_changes.js';
import { writeForeignLooks } from './foreign_looks.mjs';
import { afterglow, difference, drawnFrames, isSame, launchForPages, pixelsOfFile,
    skipPages, temporaryFolder } from './page_tools.mjs';

const size = '320x180';
const frame = 16;
const folder = skipPages ? null : temporaryFolder();
const looks = folder ? writeForeignLooks(folder.path) : {};
let browser;

// The rasteriser's faster filter of 8-bit textures is less exact, and not used for borders.
const exactFilter = 'no_aos_sampling';

before(async () => {
    process.env.GALLIVM_PERF = exactFilter;
    if (!skipPages) ({ browser } = await launchForPages({ width: 400, height: 300 }));
});

after(async () => {
    if (browser) await browser.close();
    if (folder) folder.remove();
});

/** Compares a page with the program, for other values of the same page. */
async function compare(look, name, values = {}) {
    const page = join(folder.path, `${name}.html`);
    const rendered = join(folder.path, `${name}.png`);
    const set = Object.entries(values).flatMap(([key, value]) => ['--set', `${key}=${value}`]);
    const link = new URLSearchParams(values).toString();
    await afterglow('export', look, '--to', 'web', '-o', page, '--size', size);
    await afterglow('render', look, ...set, '--size', size, '--frames', `${frame}`, '-o', rendered);
    const drawn = await drawnFrames(browser, page, [frame], size, link && `#${link}`);
    const wanted = pixelsOfFile(rendered);
    const levels = new Set(wanted.values).size;
    assert.ok(levels > 30, `the program's picture has ${levels} levels`);
    const found = difference(drawn.get(frame), wanted);
    assert.ok(isSame(found), `${name}: ${JSON.stringify(found)}`);
}

test('a libretro preset has integer targets, feedback, history, mip levels and borders',
    { skip: skipPages }, () => compare(looks.slang, 'slang'));

test('an ISF shader has persistent buffers, sound and pictures', { skip: skipPages },
    () => compare(looks.isf, 'isf'));

test('a page compiles its shaders with other constants', { skip: skipPages },
    () => compare(looks.isf, 'constants', { RINGS: 2, SHARE: 0.6 }));

test('a Shadertoy shader has cube maps, volumes and keys', { skip: skipPages },
    () => compare(looks.shadertoy, 'shadertoy'));

test('a constant that a directive evaluates is lost', { skip: skipPages }, async () => {
    const text = await afterglow('export', looks.isf, '--to', 'web', '-o',
        join(folder.path, 'unused.html'), '--dry-run');
    assert.match(text, /Sides/);
    assert.doesNotMatch(text, /Rings|Share/);
});

test('a dragged constant waits until the slider rests', () => {
    const look = { parameters: [{ name: 'N', type: 'int', value: 4, default: 4, items: [],
        constant_id: 0, constant_type: 'int' }] };
    const changes = new ConstantChanges(look);
    const at = (number, seconds, isPatient = true) =>
        changes.isDue(new Map([['N', [number]]]), seconds, isPatient);
    assert.equal(at(4, 0), false);
    assert.equal(at(5, 1), false);
    assert.equal(at(6, 1.1), false);
    assert.equal(at(6, 1.25), false);
    assert.equal(at(6, 1.35), true);
    assert.equal(at(6, 2), false);
    assert.equal(at(7, 2, false), true);
});
