// An exported page as its user meets it: mouse, files, links, lost contexts and old browsers.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { afterglow, difference, drawnFrames, isSame, launchForPages, pixelsOfFile, pixelsOfUrl,
    skipPages, temporaryFolder } from './page_tools.mjs';
import { pngPixels } from './png_pixels.mjs';
import { floatWav, soundOf } from './sound_files.mjs';

const skip = skipPages;
const size = '240x136';
const usualWindow = { width: 800, height: 600 };
const folder = skip ? { path: '', remove: () => {} } : temporaryFolder();
const phosphor = join(folder.path, 'phosphor.html');
const downloads = join(folder.path, 'downloads');
const circle = join(folder.path, 'circle.wav');

/** A clock of 60 Hz that only `step(frames)` advances. */
const steppedClock = `{
    let now = 1000;
    let waiting = [];
    performance.now = () => now;
    window.requestAnimationFrame = (callback) => waiting.push(callback);
    window.step = async (frames) => {
        for (let i = 0; i < frames; i++) {
            const due = waiting;
            waiting = [];
            now += 1000 / 60;
            for (const callback of due) callback(now);
            await new Promise((resolve) => setTimeout(resolve));
        }
    };
}`;

let browser;

before(async () => {
    if (skip) return;
    mkdirSync(downloads);
    writeFileSync(circle, floatWav(soundOf(48000, 48000,  // 120 turns per second
        (i) => 0.5 * Math.cos(Math.PI * i / 200), (i) => 0.5 * Math.sin(Math.PI * i / 200))));
    const [launched] = await Promise.all([launchForPages(usualWindow),
        afterglow('export', 'phosphor', '--to', 'web', '-o', phosphor)]);
    browser = launched.browser;
    await browser.send('Browser.setDownloadBehavior',
        { behavior: 'allow', downloadPath: downloads }, undefined);
    await browser.send('Browser.grantPermissions',
        { permissions: ['clipboardReadWrite', 'clipboardSanitizedWrite'] }, undefined);
});

after(async () => {
    if (browser) await browser.close();
    folder.remove();
});

/** Opens a page with a stepped clock. `script` runs before the page's own. */
async function openPage(page, suffix = `?size=${size}`, script = '') {
    const stop = await browser.beforeEachPage(steppedClock + script);
    await browser.open('about:blank');
    browser.errors.length = 0;
    await browser.open(`file://${page}${suffix}`);
    const ready = suffix.includes('bare') ? 'document.body.classList.contains("bare")' : 'false';
    await browser.until(`${ready} || document.querySelector('#panel, .failure')`);
    await stop();
}

const step = (frames) => browser.evaluate(`step(${frames})`);
const hasText = (text) => browser.evaluate(`[...document.querySelectorAll(
    '#panel, #messages, .failure')].some((one) =>
        one.textContent.includes(${JSON.stringify(text)}))`);

/** Whether the browser has written all of it: a PNG ends with the chunk IEND and its checksum. */
const isWholePng = (file) =>
    existsSync(file) && readFileSync(file).subarray(-8, -4).toString('latin1') === 'IEND';

/** The picture, by the screenshot that the page saves. */
async function savedPicture(look = 'phosphor') {
    const file = join(downloads, `${look}.png`);
    rmSync(file, { force: true });
    await browser.key('s');
    for (let i = 0; i < 250 && !isWholePng(file); i++)
        await new Promise((resolve) => setTimeout(resolve, 20));
    return pngPixels(readFileSync(file));
}

/** What the program draws. */
async function rendered(frames, ...words) {
    const file = join(folder.path, 'rendered.png');
    await afterglow('render', ...words, '--size', size, '--frames', String(frames), '-o', file);
    return pixelsOfFile(file);
}

function assertSame(picture, expected) {
    const found = difference(picture, expected);
    assert.ok(isSame(found), JSON.stringify(found));
}

test('while paused, a slider moved by the mouse shows what render --set draws', { skip },
    async () => {
        await openPage(phosphor);
        await step(12);
        await browser.key(' ');
        assertSame(await savedPicture(), await rendered(12, 'phosphor'));
        const slider = 'input[type=range][aria-label="Beam intensity"]';
        const from = await browser.placeOf(slider, 0.6);
        const to = await browser.placeOf(slider, 0.2);
        await browser.drag([[from.x, from.y], [to.x, to.y]]);
        await browser.until('location.hash.startsWith("#beam_gain=")');
        const value = await browser.evaluate('location.hash.slice(1)');
        await step(4);
        const picture = await savedPicture();
        assertSame(picture, await rendered(12, 'phosphor', '--set', value));
        assert.deepEqual(browser.errors, []);
    });

test('a lost context comes back with the same picture', { skip }, async () => {
    await openPage(phosphor);
    await step(12);
    const before = await savedPicture();
    const lose = (name) => browser.evaluate(`(window.loss ||= document.getElementById('picture')
        .getContext('webgl2').getExtension('WEBGL_lose_context')).${name}()`);
    await browser.key(' ');
    await lose('loseContext');
    await step(2);
    assert.ok(await hasText('lost the graphics context'));
    await lose('restoreContext');
    await browser.until('step(1).then(() => document.querySelector(".notes").hidden)');
    await step(4);
    assertSame(await savedPicture(), before);
    assert.deepEqual(browser.errors, []);
});

test('a dropped sound is drawn while it plays', { skip }, async () => {
    await openPage(phosphor);
    await step(2);
    await browser.drop([circle], 300, 300);
    await browser.until(`step(1).then(() =>
        document.querySelector('.count').textContent === 'circle.wav')`);
    const end = Date.now() + 1000;
    while (Date.now() < end) await step(1);
    const expected = await rendered(60, 'phosphor', '--signal', `audio:${circle},mode=xy`);
    const { max } = difference(await savedPicture(), expected);
    assert.ok(max <= 16, `${max}`);  // these frames are not 1/60 s long
    assert.deepEqual(browser.errors, []);
});

test('a dropped picture is drawn as render --source draws it', { skip }, async () => {
    const page = join(folder.path, 'crt.html');
    const picture = join(folder.path, 'picture.png');
    await Promise.all([
        afterglow('export', 'crt', '--source', 'pattern:smpte', '--to', 'web', '-o', page),
        afterglow('render', 'vector-beam', '--frames', '2', '--size', '160x120', '-o', picture)]);
    await openPage(page);
    await browser.drop([picture], 300, 300);
    await browser.until(`step(1).then(() =>
        document.querySelector('.count').textContent === 'picture.png')`);
    await browser.key('r');
    await step(3);
    assertSame(await savedPicture('crt'), await rendered(3, 'crt', '--source', picture));
    assert.deepEqual(browser.errors, []);
});

test('an exported sound plays after one click, and the page says so', { skip }, async () => {
    const page = join(folder.path, 'sound.html');
    await afterglow('export', 'phosphor', '--signal', `audio:${circle},mode=xy`, '--to', 'web',
        '-o', page);
    browser.isClicking = false;
    await openPage(page);
    await browser.until('step(5).then(() => !document.querySelector("#start-sound").hidden)');
    browser.isClicking = true;
    await browser.click('#start-sound');
    await browser.until('step(5).then(() => document.querySelector("#start-sound").hidden)');
    assert.deepEqual(browser.errors, []);
});

test('links carry values and presets, which the program accepts too', { skip }, async () => {
    const link = '#decay=0.97&bloom_intensity=1.5&bogus=1';
    await openPage(phosphor, `?size=${size}${link}`);
    assert.ok(await hasText('Ignored from the link: bogus.'));
    await browser.click('footer button:nth-child(2)');
    await browser.until('document.querySelector("#messages").textContent.includes("copied")');
    const line = await browser.evaluate('navigator.clipboard.readText()');
    const values = ['--set', 'decay=0.97', '--set', 'bloom_intensity=1.5'];
    const expected = await rendered(12, 'phosphor', ...values);
    assertSame(await rendered(12, line), expected);
    for (const more of [link, `&preset=${encodeURIComponent(line)}`])
        assertSame((await drawnFrames(browser, phosphor, [12], size, more)).get(12), expected);
});

test('?bare shows the picture alone in the shape of the window', { skip }, async () => {
    await browser.resize({ width: 400, height: 300 });
    await openPage(phosphor, '?bare');
    await step(1);
    const shown = () => browser.evaluate(`(() => {
        const { width, height } = document.getElementById('picture');
        return [width, height, document.querySelectorAll('button').length];
    })()`);
    assert.deepEqual(await shown(), [400, 300, 0]);
    await browser.resize({ width: 300, height: 300, deviceScaleFactor: 2 });
    await browser.until(`(step(1), document.getElementById('picture').width === 600)`);
    assert.deepEqual(await shown(), [600, 600, 0]);
    await browser.resize(usualWindow);
});

test('?transparent is transparent where the picture is black', { skip }, async () => {
    const picture = (await drawnFrames(browser, phosphor, [12], size, '&transparent')).get(12);
    const composed = { ...picture, values: picture.values.map((value, i) =>
        Math.round(value * picture.values[i - i % 4 + 3] / 255)) };
    const alphas = picture.values.filter((_, i) => i % 4 === 3);
    assertSame(composed, await rendered(12, 'phosphor'));
    assert.ok(Math.min(...alphas) === 0 && Math.max(...alphas) > 200);
    await openPage(phosphor, `?bare&transparent&size=${size}`);
    await step(2);
    await browser.send('Emulation.setDefaultBackgroundColorOverride',
        { color: { r: 0, g: 0, b: 0, a: 0 } });
    const page = pngPixels(await browser.screenshot());
    await browser.send('Emulation.setDefaultBackgroundColorOverride');
    assert.deepEqual([page.channels, page.values[3]], [4, 0]);
});

test('the page stops while it is hidden', { skip }, async () => {
    await openPage(phosphor);
    const hide = (isHidden) => browser.evaluate(`Object.defineProperty(document, 'hidden',
        { value: ${isHidden}, configurable: true });
        document.dispatchEvent(new Event('visibilitychange')); step(1)`);
    const status = () => browser.evaluate('document.querySelector(".title small").textContent');
    await step(32);
    assert.equal(await status(), '60 fps');
    await hide(true);
    assert.equal(await status(), 'Paused');
    const before = await savedPicture();
    await step(4);
    assert.equal(difference(await savedPicture(), before).max, 0);
    await hide(false);
    await step(32);
    assert.equal(await status(), '60 fps');
    assert.ok(difference(await savedPicture(), before).max > 50);
});

test('without float extensions the page draws with 16 bits and says so', { skip }, async () => {
    const missing = ['OES_texture_float_linear', 'EXT_float_blend', 'EXT_color_buffer_float'];
    await openPage(phosphor, `?size=${size}`, `{
        const get = WebGL2RenderingContext.prototype.getExtension;
        WebGL2RenderingContext.prototype.getExtension = function (name) {
            return ${JSON.stringify(missing)}.includes(name) ? null : get.call(this, name);
        };
    }`);
    await step(12);
    for (const name of missing) assert.ok(await hasText(name), name);
    const found = difference(await savedPicture(), await rendered(12, 'phosphor'));
    assert.ok(found.max <= 8, JSON.stringify(found));
    assert.deepEqual(browser.errors, []);
});

test('drags, scrolling and pinches move the orbit of a look', { skip }, async () => {
    const page = join(folder.path, 'caffeine.html');
    await afterglow('export', 'caffeine', '--to', 'web', '-o', page);
    await openPage(page, '?size=64x36');
    await step(1);
    const pose = async () => {
        await step(1);
        return browser.evaluate(`['Object rotation x', 'Object rotation y', 'Object rotation z',
            'Camera azimuth', 'Camera elevation', 'Camera distance'].map((label) =>
            Number(document.querySelector('[aria-label="' + label + ', number"]').value))`);
    };
    // The stage is 448 x 600, and its shorter side is 180 degrees.
    await browser.drag([[100, 300], [120, 300], [212, 300]]);
    assert.deepEqual(await pose(), [0, 45, 0, 0, 0, 1]);
    await browser.drag([[200, 300], [256, 272]], 'right');
    assert.deepEqual(await pose(), [0, 45, 0, -22.5, -11.25, 1]);
    await browser.send('Input.dispatchMouseEvent', { type: 'mouseWheel', x: 200, y: 300, deltaX: 0,
        deltaY: -200, modifiers: 2 });
    assert.deepEqual(await pose(), [0, 45, 0, -22.5, -11.25, 0.81]);
    await browser.touch([[[150, 300]], [[150, 300], [250, 300]], [[156, 300], [356, 300]]]);
    assert.deepEqual((await pose()).slice(3), [-45, -11.25, 0.405]);
    await browser.key('z', { ctrl: true });
    await browser.key('z', { ctrl: true });
    assert.deepEqual(await pose(), [0, 45, 0, -22.5, -11.25, 1]);
    assert.deepEqual(browser.errors, []);
});

test('what is impossible is said in the page and in its title', { skip }, async () => {
    const title = () => browser.evaluate('document.title');
    await openPage(phosphor, '', 'HTMLCanvasElement.prototype.getContext = () => null;');
    assert.match(await title(), /^error: This browser has no WebGL 2\./);
    assert.ok(await hasText('This browser has no WebGL 2. Enable graphics acceleration'));
    for (const [search, message] of [['?frames=abc', /^error: The number of frames 'abc'/],
        ['?frames=4,2', /^error: The number of frames/], ['?size=9x', /^error: The size '9x'/]]) {
        await openPage(phosphor, search);
        assert.match(await title(), message);
    }
});
