// Exported pages of looks and presets, drawn by Chromium and compared with the program.
// With AFTERGLOW_ALL_PAGES, all presets of the project are drawn instead of a choice.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { afterglow, difference, drawnFrames, inParallel, isSame, launchForPages, pixelsOfFile,
    skipPages, temporaryFolder } from './page_tools.mjs';

const looks = ['crt', 'shadow-mask', 'phosphor', 'vector-beam', 'caffeine'];
const chosenPresets = ['caffeine/macro', 'caffeine/studio', 'crt/film-transfer', 'crt/night-shift',
    'crt+crt/filmed-off-the-screen', 'phosphor/article', 'phosphor/crt-television',
    'phosphor/oscilloscope-music', 'phosphor/radar-p7', 'phosphor+crt/night-ward',
    'shadow-mask/dot-triads', 'shadow-mask/test-card', 'vector-beam/oscilloscope-text',
    'vector-beam/wireframe', 'vector-beam+shadow-mask/station-ident'];
const presetFolder = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'presets');
const size = '320x180';
const folder = skipPages ? null : temporaryFolder();
let browser;
let renderer = '';

/** 'crt/arcade-cabinet' and so on. */
function allPresets() {
    return readdirSync(presetFolder).flatMap((look) => readdirSync(join(presetFolder, look))
        .filter((file) => file.endsWith('.json'))
        .map((file) => `${look}/${file.slice(0, -5)}`));
}

/** Each look, and presets. */
function picturesToCompare() {
    const presets = process.env.AFTERGLOW_ALL_PAGES ? allPresets() : chosenPresets;
    return [...looks.map((look) => ({ look, preset: '', frames: [1, 16, 60] })),
        ...presets.map((preset) => ({ look: preset.split('/')[0], preset: preset.split('/')[1],
            frames: [16] }))];
}

/** Exports and renders the same. All frames are rendered where several are compared. */
async function prepared({ look, preset, frames }) {
    const name = [look, preset].filter(Boolean).join('-');
    const words = [look, '--size', size, ...(preset ? ['--preset', preset] : [])];
    const file = join(folder.path, `${name}.html`);
    const last = frames[frames.length - 1];
    const files = frames.length > 1 ? '-%04d' : '';
    await afterglow('export', ...words, '--to', 'web', '-o', file);
    await afterglow('render', ...words, '--frames', String(last), '-o',
        join(folder.path, `${name}${files}.png`));
    const rendered = new Map(frames.map((frame) => [frame, pixelsOfFile(join(folder.path,
        `${name}${files && `-${String(frame - 1).padStart(4, '0')}`}.png`))]));
    return { name, frames, file, rendered };
}

before(async () => {
    if (!skipPages) ({ browser, renderer } = await launchForPages({ width: 400, height: 300 }));
});

after(async () => {
    if (browser) await browser.close();
    if (folder) folder.remove();
});

test('pages of looks and presets show what the program renders', { skip: skipPages },
    async (context) => {
        const wrong = [];
        const table = [];
        let drawing = Promise.resolve();
        const draw = async ({ name, frames, file, rendered }) => {
            const drawn = await drawnFrames(browser, file, frames, size);
            for (const frame of frames) {
                const found = difference(drawn.get(frame), rendered.get(frame));
                const shares = [found.differing, found.above1].map((one) =>
                    `${(100 * one).toFixed(3)} %`.padStart(10)).join('');
                const page = `${name.padEnd(44)}${String(frame).padStart(3)}`;
                table.push(`${page}  ${found.max}/255${shares}`);
                if (!isSame(found)) wrong.push(`${name}, frame ${frame}: ${JSON.stringify(found)}`);
            }
        };
        await inParallel(picturesToCompare(), 1, async (picture) => {
            const one = await prepared(picture);
            await drawing;
            drawing = draw(one);
        });
        await drawing;
        context.diagnostic(renderer);
        context.diagnostic('page, frame, largest difference, pixels that differ, by more than 1');
        for (const row of table) context.diagnostic(row);
        assert.deepEqual(wrong, []);
    });
