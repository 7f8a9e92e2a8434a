// Draws a fixed number of frames for a comparison: ?frames=N&size=WxH.

/**
 * The number of frames in `?frames=N`. 0 without one. Throws if it is invalid.
 * @param {string} search of the address
 */
export function wantedFrames(search) {
    const text = new URLSearchParams(search).get('frames');
    if (text === null)
        return 0;
    const frames = /^\d{1,6}$/.test(text) ? Number(text) : 0;
    if (frames < 1 || frames > 100000)
        throw new Error(`The number of frames '${text}' is invalid. Use frames=60.`);
    return frames;
}

/**
 * Draws frames 1 to N on a clock of 60 Hz, then stores the last one as a PNG in the attribute
 * `data-png` of the canvas.
 * @param {import('./player.js').Player} player
 * @param {number} frames
 */
export async function drawFrames(player, frames) {
    for (let number = 1; number <= frames; number++) {
        const { source } = player.content;
        if (source)
            await source.prepare(number / 60);
        player.drawFixed(number);
        // A browser ends a page whose GPU work takes too long.
        player.context.gl.finish();
    }
    player.present();
    const image = player.pixels();
    const copy = document.createElement('canvas');
    copy.width = image.width;
    copy.height = image.height;
    /** @type {CanvasRenderingContext2D} */ (copy.getContext('2d')).putImageData(image, 0, 0);
    player.canvas.dataset.png = copy.toDataURL('image/png');
}
