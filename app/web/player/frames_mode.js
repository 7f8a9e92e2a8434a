// Draws a fixed number of frames for a comparison: ?frames=N&size=WxH.

const mostFrames = 100000;

/**
 * The numbers of the frames in `?frames=60` or `?frames=1,16,60`. Empty without them. Throws if
 * they are invalid.
 * @param {string} search of the address
 * @returns {number[]} rising
 */
export function wantedFrames(search) {
    const text = new URLSearchParams(search).get('frames');
    if (text === null)
        return [];
    const frames = text.split(',').map((part) => (/^\d{1,6}$/.test(part) ? Number(part) : 0));
    const isRising = frames.every((frame, i) => frame > (i > 0 ? frames[i - 1] : 0));
    if (!isRising || frames[frames.length - 1] > mostFrames)
        throw new Error(`The number of frames '${text.slice(0, 40)}' is invalid. Use frames=60, or `
            + `rising numbers up to ${mostFrames} such as frames=1,60.`);
    return frames;
}

/**
 * Draws frames from 1 on a clock of 60 Hz. The attribute `data-png` of the canvas gets the last
 * one as a PNG. Of several wanted frames, `data-png-16` has frame 16.
 * @param {import('./player.js').Player} player
 * @param {number[]} wanted rising numbers of frames
 */
export async function drawFrames(player, wanted) {
    const { canvas, frames } = player;
    const { drawing } = frames;
    const last = wanted[wanted.length - 1];
    for (let number = 1; number <= last; number++) {
        await frames.prepareFixed(number);
        frames.drawFixed(number);
        // A browser ends a page whose GPU work takes too long.
        drawing.finish();
        if (wanted.length > 1 && wanted.includes(number))
            canvas.setAttribute(`data-png-${number}`, drawing.copy().toDataURL('image/png'));
    }
    drawing.present();
    canvas.dataset.png = drawing.copy().toDataURL('image/png');
}
