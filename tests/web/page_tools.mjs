// Exports pages, draws their frames in a browser, and compares them with the program's.
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';

import { Browser, chromiumPath } from './browser.js';
import { pngPixels } from './png_pixels.mjs';

const run = promisify(execFile);
const softwareGl = { LIBGL_ALWAYS_SOFTWARE: '1', LP_NUM_THREADS: '0' };
/** The rasteriser of the program, without a display. */
const mesaFlags = ['--use-angle=gl-egl', '--ignore-gpu-blocklist'];
const ownFlags = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const rendererOf = `(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const info = gl && gl.getExtension('WEBGL_debug_renderer_info');
    return gl ? String(info && gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
})()`;

/** Why tests of pages are skipped, or false. */
export const skipPages = !process.env.AFTERGLOW ? 'AFTERGLOW is not set'
    : chromiumPath() ? false : 'chromium is not installed';

/** A folder that remove() deletes. */
export function temporaryFolder() {
    const path = mkdtempSync(join(tmpdir(), 'afterglow-pages-'));
    return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}

/** Runs the program with a software rasteriser. Throws with its messages. */
export async function afterglow(...words) {
    try {
        return (await run(process.env.AFTERGLOW, words,
            { env: { ...process.env, ...softwareGl } })).stdout;
    } catch (error) {
        throw new Error(`afterglow ${words.join(' ')}: ${error.stderr || error.message}`);
    }
}

/** A browser with WebGL 2, and the name of its rasteriser. */
export async function launchForPages(options = {}) {
    Object.assign(process.env, softwareGl);
    for (const flags of [mesaFlags, ownFlags]) {
        const browser = await Browser.launch({ timeout: 60000, ...options,
            flags: [...flags, ...(options.flags || [])] });
        const renderer = await browser.evaluate(rendererOf);
        if (renderer) return { browser, renderer };
        await browser.close();
    }
    throw new Error('Chromium has no WebGL 2');
}

/** The pixels of a data URL. */
export function pixelsOfUrl(url) {
    return pngPixels(Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
}

/** The pixels of a PNG file. */
export function pixelsOfFile(path) {
    return pngPixels(readFileSync(path));
}

/** Draws frames of a page with `?frames=` and returns their pixels by number. */
export async function drawnFrames(browser, page, frames, size, more = '') {
    await browser.open('about:blank');  // another fragment alone does not load a page
    await browser.open(`file://${page}?frames=${frames.join()}&size=${size}${more}`);
    await browser.until('/^(done|error)/.test(document.title)');
    const title = await browser.evaluate('document.title');
    if (title !== 'done') throw new Error(`${page}: ${title}`);
    const urls = await browser.evaluate(`${JSON.stringify(frames)}.map((frame) => {
        const { attributes } = document.getElementById('picture');
        return (attributes['data-png-' + frame] || attributes['data-png']).value;
    })`);
    return new Map(frames.map((frame, i) => [frame, pixelsOfUrl(urls[i])]));
}

/**
 * The largest difference of red, green and blue in levels of 255, and the shares of pixels that
 * differ at all and by more than one level.
 */
export function difference(a, b) {
    if (a.width !== b.width || a.height !== b.height)
        throw new Error(`${a.width} x ${a.height} is not ${b.width} x ${b.height}`);
    const count = a.width * a.height;
    const found = { max: 0, differing: 0, above1: 0 };
    for (let i = 0; i < count; i++) {
        let largest = 0;
        for (let c = 0; c < 3; c++)
            largest = Math.max(largest, Math.abs(a.values[i * a.channels + c]
                - b.values[i * b.channels + c]));
        found.max = Math.max(found.max, largest);
        found.differing += largest > 0 ? 1 / count : 0;
        found.above1 += largest > 1 ? 1 / count : 0;
    }
    return found;
}

/** Whether a page shows the same as the program. */
export function isSame({ max, above1 }) {
    return max <= 3 && above1 <= 0.001;
}

/** Calls a function for each item, some at once, and returns the results in order. */
export async function inParallel(items, atOnce, act) {
    const results = [];
    let next = 0;
    const work = async () => {
        while (next < items.length) {
            const index = next++;
            results[index] = await act(items[index]);
        }
    };
    await Promise.all(Array.from({ length: atOnce }, work));
    return results;
}
