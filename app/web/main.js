// Starts the page: reads its data, draws frames or plays live.

import { buildControls } from './controls/controls.js';
import { applyShared, readShared } from './controls/shared_link.js';
import { readDescription } from './look/description.js';
import { drawFrames, wantedFrames } from './player/frames_mode.js';
import { playLive } from './player/live_page.js';
import { Player } from './player/player.js';
import { wantedSize } from './player/stage_size.js';

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
    if (frames.length > 0) {
        player.frames.drawing.size = size || player.frames.drawing.size;
        await drawFrames(player, frames);
        document.title = 'done';
        return;
    }
    const { say } = buildControls(player, document.body, { isBare: shared.isBare, search });
    for (const problem of problems)
        say(problem);
    playLive(player, { size, isBare: shared.isBare }, say);
}

startPage().catch(showFailure);
