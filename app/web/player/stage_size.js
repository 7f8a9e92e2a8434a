// The size of the picture on the page.

/**
 * @typedef {{width: number, height: number}} StageSize in pixels of the screen
 */

/** Largest number of pixels that a page draws by itself. */
const mostPixels = 2560 * 1440;

/**
 * The size in `?size=WxH`. Null without one. Throws if it is invalid.
 * @param {string} search of the address
 * @returns {StageSize|null}
 */
export function wantedSize(search) {
    const text = new URLSearchParams(search).get('size');
    if (text === null)
        return null;
    const parts = /^(\d{1,5})x(\d{1,5})$/.exec(text);
    const width = parts ? Number(parts[1]) : 0;
    const height = parts ? Number(parts[2]) : 0;
    if (width < 1 || height < 1 || width > 8192 || height > 8192)
        throw new Error(`The size '${text}' is invalid. Use size=640x360, with sides up to 8192.`);
    return { width, height };
}

/**
 * The largest picture of a shape that fits a stage, at the pixels of the screen.
 * @param {{width: number, height: number}} stage CSS pixels
 * @param {number} pixelRatio pixels of the screen per CSS pixel
 * @param {number} aspect width / height; 0: as the stage
 * @param {number} divisor of both sides, for a slow device
 * @returns {StageSize}
 */
export function fittedSize(stage, pixelRatio, aspect, divisor) {
    const width = Math.max(stage.width * pixelRatio, 1);
    const height = Math.max(stage.height * pixelRatio, 1);
    const shape = aspect > 0 ? aspect : width / height;
    let shown = { width: Math.min(width, height * shape), height: Math.min(height, width / shape) };
    const scale = Math.min(1, Math.sqrt(mostPixels / (shown.width * shown.height))) / divisor;
    shown = { width: shown.width * scale, height: shown.height * scale };
    return { width: Math.max(1, Math.round(shown.width)),
        height: Math.max(1, Math.round(shown.height)) };
}
