// The panel of the page in a real browser, with a mock player.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { Browser, chromiumPath } from './browser.js';
import { controlsLook, controlsPage } from './controls_page.js';

const skip = chromiumPath() ? false : 'chromium is not installed';
const folder = mkdtempSync(join(tmpdir(), 'afterglow-controls-'));
const page = `file://${join(folder, 'page.html')}`;
/** @type {Browser} */
let browser;

before(async () => {
    writeFileSync(join(folder, 'page.html'), controlsPage(controlsLook()));
    if (!skip) browser = await Browser.launch();
});

after(async () => {
    if (browser) await browser.close();
    rmSync(folder, { recursive: true, force: true });
});

/** Opens the page afresh: a change of the fragment alone would not load it. */
async function openPage(suffix = '') {
    await browser.open('about:blank');
    await browser.open(page + suffix);
    await browser.until('window.isReady');
    await nextFrame();
    assert.deepEqual(browser.errors, []);
}

const nextFrame = () => browser.evaluate(
    'new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
const value = (name) => browser.evaluate(`player.values.get('${name}')`);
const slider = (label) => `input[type=range][aria-label="${label}"]`;

test('dragging a slider is one step of undo and ends up in the address', { skip }, async () => {
    await openPage();
    const from = await browser.placeOf(slider('Time scale'), 0.5);
    const to = await browser.placeOf(slider('Time scale'), 0.75);
    await browser.mouse('mouseMoved', from.x, from.y);
    await browser.mouse('mousePressed', from.x, from.y);
    await browser.mouse('mouseMoved', (from.x + to.x) / 2, to.y);
    await browser.mouse('mouseMoved', to.x, to.y);
    await browser.mouse('mouseReleased', to.x, to.y);
    const [dragged] = await value('time_scale');
    assert.ok(dragged > 2 && dragged < 4, `${dragged}`);  // three quarters of 0.1 .. 10 are 3.16
    await browser.until(`location.hash === '#time_scale=${dragged}'`);
    await nextFrame();
    assert.equal(await browser.evaluate('document.querySelectorAll(".row.changed").length'), 1);
    await browser.key('z', { ctrl: true });
    assert.deepEqual(await value('time_scale'), [1]);
    await browser.until('location.hash === ""');
    await browser.key('z', { ctrl: true, shift: true });
    assert.deepEqual(await value('time_scale'), [dragged]);
});

test('values change by keys, typing, lists, switches, colours and triggers', { skip }, async () => {
    await openPage();
    await browser.evaluate(`document.querySelector('${slider('Taps')}').focus()`);
    await browser.key('ArrowRight');
    assert.deepEqual(await value('taps'), [15]);
    await browser.click('[aria-label="Decay, number"]');
    await browser.type('100 ms');
    await browser.key('Enter');
    assert.ok(Math.abs((await value('decay'))[0] - 0.5 ** (1 / 6)) < 1e-9);
    await browser.click('[aria-label="Masks G"]');
    assert.deepEqual(await value('masks'), [1, 1, 1]);
    await browser.evaluate(`{
        const list = document.querySelector('select[aria-label=Tube]');
        list.value = '5';
        list.dispatchEvent(new Event('change'));
        const color = document.querySelector('input[type=color]');
        color.value = '#ff8000';
        color.dispatchEvent(new Event('input'));
    }`);
    assert.deepEqual(await value('tube'), [5]);
    assert.ok(Math.abs((await value('tint'))[1] - 0.2158605) < 1e-6);  // sRGB 128/255
    const pad = await browser.placeOf('.pad', 0.25, 0.5);
    await browser.mouse('mousePressed', pad.x, pad.y);
    await browser.mouse('mouseReleased', pad.x, pad.y);
    assert.ok((await value('center')).every((part, i) => Math.abs(part - [0.25, 0.25][i]) < 0.02));
    const trigger = await browser.placeOf('[aria-label="Trigger Flash"]');
    await browser.mouse('mousePressed', trigger.x, trigger.y);
    assert.deepEqual(await value('flash'), [1]);
    await browser.mouse('mouseReleased', trigger.x, trigger.y);
    assert.deepEqual(await value('flash'), [0]);
    await nextFrame();
    await browser.click('[aria-label="Reset Taps to 13"]');
    assert.deepEqual(await value('taps'), [13]);
    await browser.click('.tools button:last-child');
    assert.deepEqual([await value('tube'), await value('decay')], [[0], [0.92]]);
});

test('a parameter without effect is dimmed and says what it needs', { skip }, async () => {
    await openPage();
    const state = () => browser.evaluate(`(() => {
        const row = document.querySelector('${slider('Time scale')}').closest('.row');
        return [row.classList.contains('without-effect'), row.querySelector('.help').textContent];
    })()`);
    assert.deepEqual(await state(), [true, 'No effect now. Needs: Tube is not Custom.']);
    await browser.evaluate('player.setValue("tube", [5])');
    await nextFrame();
    assert.deepEqual(await state(), [false, '']);
});

test('search shows matches, and hidden parameters have no control', { skip }, async () => {
    await openPage('#secret=0.75');
    assert.deepEqual(await value('secret'), [0.75]);
    await browser.key('/');
    await browser.type('deca phos');
    const labels = await browser.evaluate(`[...document.querySelectorAll('.groups .label')]
        .filter((label) => label.offsetParent).map((label) => label.firstChild.data)`);
    assert.deepEqual(labels, ['Decay']);
    const text = await browser.evaluate('document.querySelector("#panel").textContent');
    assert.ok(!/Secret|Baked/.test(text));
});

test('keys hide the panel, pause, restart, save and list themselves', { skip }, async () => {
    await openPage();
    const isShown = () => browser.evaluate('!!document.querySelector("#panel").offsetParent');
    await browser.key('h');
    assert.equal(await isShown(), false);
    await browser.click('.show-panel');
    assert.equal(await isShown(), true);
    await browser.evaluate('document.activeElement.blur()');
    for (const key of [' ', 'r', 's']) await browser.key(key);
    await browser.until('player.calls.includes("screenshot")');
    assert.deepEqual(await browser.evaluate('[player.isPaused, player.calls]'),
        [true, ['restart', 'screenshot']]);
    await browser.key('?');
    assert.equal(await browser.evaluate('document.querySelectorAll("dialog kbd").length'), 12);
    await browser.key('Escape');
    await browser.until('!document.querySelector("dialog")');
    await browser.click('input[type=search]');
    await browser.key('h');
    assert.equal(await isShown(), true);  // typed into the field
});

test('an edited address is applied as one step', { skip }, async () => {
    await openPage('#width=4');
    assert.deepEqual(await value('width'), [4]);
    await browser.evaluate('location.hash = "#taps=17&bogus=1"');
    await browser.until('document.querySelector("#messages button")');
    assert.deepEqual([await value('width'), await value('taps')], [[2], [17]]);
    assert.equal(await browser.evaluate('document.querySelector("#messages").textContent'),
        'Ignored from the link: bogus.');
    await browser.key('z', { ctrl: true });
    assert.deepEqual([await value('width'), await value('taps')], [[4], [13]]);
});

test('presets are pasted, and files are dropped with a visible target', { skip }, async () => {
    await openPage();
    await browser.evaluate(`{
        const json = JSON.stringify({ format: 'afterglow-preset', version: 1, look: 'test',
            values: { taps: 21, tube: 'P7' } });
        const clipboardData = new DataTransfer();
        clipboardData.setData('text', json);
        document.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    }`);
    await browser.until('player.values.get("taps")[0] === 21');
    assert.deepEqual(await value('tube'), [5]);
    const drag = (type, name, mime) => browser.evaluate(`(() => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File(['x'], '${name}', { type: '${mime}' }));
        window.dispatchEvent(new DragEvent('${type}', { dataTransfer, cancelable: true }));
        return !document.querySelector('#drop-target').hidden;
    })()`);
    assert.equal(await drag('dragover', 'a.wav', 'audio/wav'), true);
    assert.equal(await drag('drop', 'a.wav', 'audio/wav'), false);
    assert.deepEqual(await browser.evaluate('player.calls'), ['sound a.wav']);
    await drag('drop', 'a.png', 'image/jpeg');
    await browser.until(`document.querySelector('#messages').textContent.includes(
        'This look can\\'t use "a.png". Drop a sound or a preset.')`);
});

test('sound that needs a click shows a button until it plays', { skip }, async () => {
    await openPage();
    await browser.evaluate('player.state.needsClick = true; player.fire("state")');
    await nextFrame();
    await browser.click('#start-sound');
    await nextFrame();
    assert.ok(await browser.evaluate('document.querySelector("#start-sound").hidden'));
});

test('texts of the look are never HTML, and each control has a name', { skip }, async () => {
    await openPage();
    const found = await browser.evaluate(`({
        tags: document.querySelectorAll('#panel b, #panel img, #panel script').length,
        heading: document.querySelector('h1').textContent,
        nameless: [...document.querySelectorAll('#panel button, #panel input, #panel select')]
            .filter((one) => !one.getAttribute('aria-label') && !one.textContent).length,
    })`);
    assert.deepEqual(found, { tags: 0, heading: 'Test </script><b>look', nameless: 0 });
});

test('?bare shows only the picture, and &transparent has no background', { skip }, async () => {
    await openPage('?bare&transparent#width=4');
    const found = await browser.evaluate(`({
        children: [...document.body.children].filter((one) => one.offsetParent)
            .map((one) => one.id),
        panels: document.querySelectorAll('#panel').length,
        background: getComputedStyle(document.body).backgroundColor,
        cursor: getComputedStyle(document.body).cursor,
    })`);
    assert.deepEqual(found, { children: ['stage'], panels: 0, background: 'rgba(0, 0, 0, 0)',
        cursor: 'none' });
    assert.deepEqual(await value('width'), [4]);
});

test('on a phone the panel is a sheet at the bottom with large targets', { skip }, async () => {
    await browser.resize({ width: 360, height: 740, deviceScaleFactor: 2, mobile: true });
    await openPage();
    const found = await browser.evaluate(`(() => {
        const box = (selector) => document.querySelector(selector).getBoundingClientRect();
        document.querySelectorAll('details').forEach((one) => { one.open = true; });
        const wide = [...document.querySelectorAll('#panel *')]
            .filter((one) => one.getBoundingClientRect().right > 361).map((one) => one.outerHTML);
        const targets = '#panel > header button, footer button, .buttons button, .label, select';
        const small = [...document.querySelectorAll(targets)].filter((one) => one.offsetParent)
            .filter((one) => one.closest('.head, header, div, footer').offsetHeight < 44).length;
        return { bottom: box('#panel').bottom, isBelow: box('#panel').top >= box('#stage').bottom,
            isHalf: box('#stage').height > 300, wide, small };
    })()`);
    assert.deepEqual(found, { bottom: 740, isBelow: true, isHalf: true, wide: [], small: 0 });
});
