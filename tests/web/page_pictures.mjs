// Writes a page for each look, and the pictures of docs/export.md: page_pictures.mjs PROGRAM FOLDER.
// The pages are in FOLDER. Chromium draws them with the system's GL.

import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './browser.js';

const looks = ['phosphor', 'vector-beam', 'crt', 'shadow-mask', 'caffeine'];
const shots = [
    { name: 'phosphor', look: 'phosphor', width: 1280, height: 800, scale: 1,
        size: '928x522' },
    { name: 'shadow-mask-2x', look: 'shadow-mask', width: 900, height: 560, scale: 2,
        size: '1096x616' },
    { name: 'vector-beam-phone', look: 'vector-beam', width: 360, height: 740, scale: 2,
        isMobile: true, size: '720x405' },
];
const settleMilliseconds = 8000;

const [, , program, folder] = process.argv;
const pictures = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'docs', 'export');
mkdirSync(pictures, { recursive: true });
mkdirSync(folder, { recursive: true });
for (const look of looks)
    execFileSync(program, ['export', look, '--to', 'web', '-o', join(folder, `${look}.html`)]);
// A fixed size, because software GL is slow and the page would make the picture smaller.
for (const { name, look, size, ...window } of shots) {
    const browser = await Browser.launch({ ...window, timeout: 120000,
        flags: ['--use-angle=gl-egl', '--ignore-gpu-blocklist'] });
    try {
        await browser.open(`${pathToFileURL(join(folder, `${look}.html`))}?size=${size}`);
        await new Promise((resolve) => setTimeout(resolve, settleMilliseconds));
        writeFileSync(join(pictures, `${name}.png`), await browser.screenshot());
    } finally {
        await browser.close();
    }
}
