// Starts the page: reads its data, draws frames or plays live.

import { buildControls } from './controls/controls.js';
import { applyShared, readShared } from './controls/shared_link.js';
import { readDescription } from './look/description.js';
import { drawFrames, wantedFrames } from './player/frames_mode.js';
import { Player } from './player/player.js';
import { fittedSize, wantedSize } from './player/stage_size.js';

/**
 * Shows why the page can't draw.
 * @param {unknown} error
 */
function showFailure(error) {
    const message = error instanceof Error ? error.message : String(error);
    document.title = `error: ${message}`;
    const note = document.createElement('p');
    note.className = 'failure';
    note.setAttribute('role', 'alert');
    note.textContent = message;
    document.body.append(note);
}

/**
 * Draws at the size of the window until the page is closed.
 * @param {Player} player
 * @param {{size: {width: number, height: number}|null, isBare: boolean}} options
 */
function playLive(player, options) {
    const stage = /** @type {HTMLElement} */ (player.canvas.parentElement);
    const [width, height] = player.description.size;
    const resize = () => {
        const box = stage.getBoundingClientRect();
        const divisor = 2 ** player.pace.halvings;
        player.size = options.size || fittedSize(box, window.devicePixelRatio,
            options.isBare ? 0 : width / height, divisor);
    };
    new ResizeObserver(resize).observe(stage);
    resize();
    let before = performance.now();
    /** @param {number} now */
    const draw = (now) => {
        const elapsed = (now - before) / 1000;
        before = now;
        player.drawLive(elapsed);
        if (player.pace.note(now / 1000) && !options.size) {
            resize();
            player.changed('notes');
        }
        if (player.number % 30 === 1)
            player.changed('state');
        requestAnimationFrame(draw);
    };
    requestAnimationFrame(draw);
    let wasPaused = false;
    document.addEventListener('visibilitychange', () => {
        if (document.hidden)
            wasPaused = player.isPaused;
        player.setPaused(document.hidden || wasPaused);
        before = performance.now();
    });
}

/** Runs the page. */
async function startPage() {
    const search = window.location.search;
    const shared = readShared(search, window.location.hash);
    const data = /** @type {HTMLElement} */ (document.getElementById('data'));
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('picture'));
    const frames = wantedFrames(search);
    const size = wantedSize(search);
    const player = new Player(readDescription(data.textContent || '{}'), canvas,
        { isTransparent: shared.isTransparent });
    await player.load();
    const problems = await applyShared(player, shared);
    if (frames > 0) {
        player.size = size || player.size;
        await drawFrames(player, frames);
        document.title = 'done';
        return;
    }
    const { say } = buildControls(player, document.body, { isBare: shared.isBare, search });
    for (const problem of problems)
        say(problem);
    playLive(player, { size, isBare: shared.isBare });
}

startPage().catch(showFailure);
