// Milliseconds between the frames of an exported page: page_frames.mjs PAGE SIZE SECONDS.

import { pathToFileURL } from 'node:url';
import { Browser } from '../web/browser.js';

const [, , page, size, seconds] = process.argv;
const browser = await Browser.launch({
    flags: ['--use-angle=gl-egl', '--ignore-gpu-blocklist'], timeout: 120000 });
try {
    await browser.open(`${pathToFileURL(page)}?bare&size=${size}`);
    const milliseconds = await browser.evaluate(`new Promise((resolve) => {
        const times = [];
        const note = (now) => {
            times.push(now);
            const begin = times[0] + 2000;  // after the first draws
            if (now < begin + ${Number(seconds) * 1000})
                return requestAnimationFrame(note);
            const counted = times.filter((time) => time >= begin);
            resolve((counted[counted.length - 1] - counted[0]) / (counted.length - 1));
        };
        requestAnimationFrame(note);
    })`);
    console.log(milliseconds);
} finally {
    await browser.close();
}
