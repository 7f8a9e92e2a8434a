// The page of a gallery in a browser: search, share lines, live pages, phones.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { Browser, chromiumPath } from './browser.js';

const program = process.env.AFTERGLOW;
const skip = !program ? 'AFTERGLOW is not set' : chromiumPath() ? false : 'chromium is not installed';
const folder = mkdtempSync(join(tmpdir(), 'afterglow-gallery-'));
const hostile = '</script><img src=x onerror="window.isAttacked = true">';
/** @type {Browser} */
let browser;

function writeLook(id, about) {
    mkdirSync(join(folder, id));
    writeFileSync(join(folder, id, 'look.json'), JSON.stringify({ format: 'afterglow-look', version: 1,
        name: id.toUpperCase(), about, driven_by: 'nothing', settle_frames: 1,
        passes: [{ name: 'show', fragment: 'show.frag' }] }));
    writeFileSync(join(folder, id, 'show.frag'), '#version 410 core\nuniform float gray = 0.5;  // '
        + '@range 0 1\nout vec4 color;\nvoid main() { color = vec4(vec3(gray), 1.0); }\n');
}

before(async () => {
    if (skip) return;
    writeLook('one', `A lamp ${hostile}`);
    writeLook('two+', 'A tube');
    const made = spawnSync(program, ['gallery', 'one/', 'two+/', '-o', 'out'],
        { cwd: folder, encoding: 'utf8' });
    assert.equal(made.status, 0, made.stderr);
    browser = await Browser.launch();
    await browser.send('Emulation.setFocusEmulationEnabled', { enabled: true });  // for the clipboard
    await browser.open(`file://${join(folder, 'out', 'index.html')}`);
});

after(async () => {
    if (browser) await browser.close();
    rmSync(folder, { recursive: true, force: true });
});

/** Types into the search field. Returns what is visible then. */
function found(words) {
    return browser.evaluate(`(() => {
        const field = document.querySelector('[type=search]');
        field.value = ${JSON.stringify(words)};
        field.dispatchEvent(new Event('input'));
        const visible = (selector) => [...document.querySelectorAll(selector)]
            .filter((one) => one.checkVisibility()).map((one) => one.textContent.trim());
        return { looks: visible('h2 code'), links: visible('nav a'), count: visible('output')[0],
            none: visible('.none').length };
    })()`);
}

test('the search finds names, looks and descriptions', { skip }, async () => {
    const all = { looks: ['one', 'two+'], links: ['ONE 1', 'TWO+ 1'], count: '2 presets', none: 0 };
    assert.deepEqual(await found(''), all);
    for (const words of ['two+', 'tube a', 'TWO default'])
        assert.deepEqual(await found(words),
            { looks: ['two+'], links: ['TWO+ 1'], count: '1 of 2 presets', none: 0 }, words);
    assert.deepEqual(await found('lamp tube'), { looks: [], links: [], count: '0 of 2 presets', none: 1 });
    await browser.evaluate(`document.querySelector('.none button').click()`);
    assert.deepEqual(await found(''), all);
});

test('a share line is copied, with and without permission', { skip }, async () => {
    for (const isAllowed of [true, false]) {
        const [copied, line] = await browser.evaluate(`(async () => {
            let copied = '';
            const writeText = async (text) => { if (!${isAllowed}) throw new Error(); copied = text; };
            Object.defineProperty(navigator, 'clipboard', { value: { writeText }, configurable: true });
            document.addEventListener('copy', ({ target }) => {
                copied = target.value.slice(target.selectionStart, target.selectionEnd);
            }, { once: true });
            const button = document.querySelectorAll('.share button')[${isAllowed ? 0 : 1}];
            button.click();
            while (button.textContent !== 'Copied') await new Promise((done) => setTimeout(done, 5));
            return [copied, button.previousElementSibling.value];
        })()`);
        assert.match(line, /^afterglow:1:/);
        assert.equal(copied, line);
    }
});

test('thumbnails load, and a click opens the live page', { skip }, async () => {
    await browser.until(`[...document.images].every((one) => one.complete && one.naturalWidth === 480)`);
    const loaded = browser.next('Page.loadEventFired');
    await browser.evaluate(`document.querySelectorAll('a.picture')[1].click()`);
    await loaded;
    assert.match(await browser.evaluate('location.pathname'), /pages\/two.*\.html$/);
    await browser.until(`document.querySelector('canvas')`);
    await browser.open(`file://${join(folder, 'out', 'index.html')}`);
});

test('a phone shows one column without scrolling sideways', { skip }, async () => {
    await browser.resize({ width: 360, height: 740, deviceScaleFactor: 2, mobile: true });
    assert.equal(await browser.evaluate('document.documentElement.scrollWidth'), 360);
    await browser.resize({ width: 1280, height: 800 });
});

test('texts of looks run no scripts', { skip }, async () => {
    assert.equal(await browser.evaluate('window.isAttacked'), undefined);
    assert.deepEqual(browser.errors, []);
});
