// Plays live: frames of the browser, the size of the window, and what happens while hidden.

import { fittedSize } from './stage_size.js';

const stateSeconds = 0.5;  // between updates of the panel

/**
 * Draws at the size of the window until the page is closed.
 * @param {import('./player.js').Player} player
 * @param {{size: {width: number, height: number}|null, isBare: boolean}} options
 *     `size` of the picture in pixels, or null to fit the window
 * @param {(message: string) => void} say shows a message to the user
 */
export function playLive(player, { size, isBare }, say) {
    const { frames } = player;
    const { drawing } = frames;
    const stage = /** @type {HTMLElement} */ (player.canvas.parentElement);
    const [width, height] = player.description.size;
    const fit = () => {
        const wanted = size || fittedSize(stage.getBoundingClientRect(), window.devicePixelRatio,
            isBare ? 0 : width / height, 2 ** frames.pace.halvings);
        if (wanted.width === drawing.size.width && wanted.height === drawing.size.height)
            return;
        drawing.size = wanted;
        frames.invalidate();
    };
    new ResizeObserver(() => {
        frames.pace.reset();
        fit();
    }).observe(stage);
    window.addEventListener('resize', fit);  // also when the pixel ratio has changed
    fit();
    pauseWhileHidden(player);
    player.startSound();
    let before = performance.now();
    let stated = before;
    let problem = '';
    /** @param {number} now ms */
    const draw = (now) => {
        requestAnimationFrame(draw);
        const elapsed = Math.max(0, (now - before) / 1000);
        before = now;
        try {
            frames.drawLive(elapsed);
            problem = '';
        } catch (error) {
            const { message } = /** @type {Error} */ (error);
            if (message !== problem)
                say(message);
            problem = message;
        }
        if (!frames.isPaused && frames.pace.note(elapsed, !size))
            fit();
        if (now - stated > 1000 * stateSeconds) {
            stated = now;
            player.dispatchEvent(new Event('state'));
        }
    };
    requestAnimationFrame(draw);
}

/** @param {import('./player.js').Player} player */
function pauseWhileHidden(player) {
    let wasPaused = false;
    const follow = () => {
        if (document.hidden)
            wasPaused = player.isPaused;
        player.setPaused(document.hidden || wasPaused);
    };
    document.addEventListener('visibilitychange', follow);
    if (document.hidden)
        follow();
}
