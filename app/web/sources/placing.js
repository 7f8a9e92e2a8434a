// Where a source picture is placed in the picture that a look reads.

import { sourcePixelAspect } from './source_settings.js';

/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */

/**
 * A size in pixels.
 * @typedef {object} PictureSize
 * @property {number} width
 * @property {number} height
 */

/**
 * The mapping from the pixels of a picture to those of the result. First, the means of
 * `shrink` x `shrink` pixels replace them. Pixel (x, y) of the result then shows pixel
 * (floor((x - left) / repeatX), floor((y - top) / repeatY)). The rest of the result is black and
 * opaque. (0, 0) is top left.
 * @typedef {object} Placing
 * @property {number} width Of the result, px.
 * @property {number} height Of the result, px.
 * @property {number} left Of the picture in the result, px. Negative if it is cropped.
 * @property {number} top Of the picture in the result, px. Negative if it is cropped.
 * @property {number} repeatX
 * @property {number} repeatY
 * @property {number} shrink
 */

/**
 * Start, distance and number of lines, relative to the height (rows) or width (columns).
 * @typedef {[number, number, number]} RasterAxis
 */

const largestPlacedSide = 16384;
const largestPlacedArea = 1 << 25;

/**
 * @param {number} length
 * @returns {number}
 */
function placedSide(length) {
    return Math.min(Math.max(Math.round(length), 1), largestPlacedSide);
}

/**
 * Changes only one side of the picture.
 * @param {PictureSize} picture
 * @param {number} shape Width / height of the viewport in pixels of the picture.
 * @param {boolean} isWhole
 * @returns {PictureSize}
 */
function fittedSourceSize(picture, shape, isWhole) {
    const wide = picture.height * shape;
    if ((wide > picture.width) === isWhole) {
        return { width: placedSide(wide), height: picture.height };
    }
    return { width: picture.width, height: placedSide(picture.width / shape) };
}

/**
 * The size of a picture after averaging `times` x `times` pixels.
 * @param {PictureSize} picture
 * @param {number} times
 * @returns {PictureSize}
 */
export function shrunkSize(picture, times) {
    return {
        width: Math.max(Math.trunc(picture.width / times), 1),
        height: Math.max(Math.trunc(picture.height / times), 1),
    };
}

/**
 * Limits memory: pictures above 2^25 pixels are averaged first.
 * @param {PictureSize} picture
 * @param {number} shape
 * @param {boolean} isWhole
 * @returns {PictureSize & {shrink: number}}
 */
function fittedInMemory(picture, shape, isWhole) {
    const size = fittedSourceSize(picture, shape, isWhole);
    const shrink = Math.ceil(Math.sqrt(size.width * size.height / largestPlacedArea));
    if (shrink <= 1) {
        return { ...size, shrink: 1 };
    }
    return { ...fittedSourceSize(shrunkSize(picture, shrink), shape, isWhole), shrink };
}

/**
 * @param {PictureSize} picture
 * @param {PictureSize} made
 * @param {number} repeatX
 * @param {number} repeatY
 * @param {number} shrink
 * @returns {Placing}
 */
function centredPlacing(picture, made, repeatX, repeatY, shrink) {
    const shown = shrink > 1 ? shrunkSize(picture, shrink) : picture;
    return {
        width: made.width,
        height: made.height,
        left: Math.floor((made.width - shown.width * repeatX) / 2),
        top: Math.floor((made.height - shown.height * repeatY) / 2),
        repeatX,
        repeatY,
        shrink,
    };
}

/**
 * Where a picture is placed for a look that draws `viewport` pixels.
 * @param {PictureSize} picture Its size without prescale.
 * @param {SourceSettings} settings
 * @param {PictureSize} viewport
 * @returns {Placing}
 */
export function placingOf(picture, settings, viewport) {
    if (settings.fit === 'stretch' || viewport.width <= 0 || viewport.height <= 0) {
        return centredPlacing(picture, picture, 1, 1, 1);
    }
    const aspect = sourcePixelAspect(settings, picture);
    if (settings.fit === 'integer') {
        const times = Math.min(
            viewport.width / (picture.width * aspect), viewport.height / picture.height);
        const tall = Math.max(1, Math.trunc(times));
        const wide = Math.max(1, Math.round(tall * aspect));
        return centredPlacing(picture, viewport, wide, tall, 1);
    }
    const shape = viewport.width / viewport.height / aspect;
    const made = fittedInMemory(picture, shape, settings.fit === 'whole');
    return centredPlacing(picture, made, 1, 1, made.shrink);
}

/**
 * Width / height of a pixel in the placed picture.
 * @param {PictureSize} picture
 * @param {SourceSettings} settings
 * @returns {number}
 */
export function placedAspect(picture, settings) {
    return settings.fit === 'integer' ? 1 : sourcePixelAspect(settings, picture);
}

/**
 * The position of a picture's lines and columns in the placed picture.
 * @param {PictureSize} picture
 * @param {SourceSettings} settings
 * @param {PictureSize} viewport
 * @returns {{rows: RasterAxis, columns: RasterAxis}} From the top and from the left.
 */
export function placedRaster(picture, settings, viewport) {
    const placing = placingOf(picture, settings, viewport);
    const smaller = placing.shrink > 1 ? shrunkSize(picture, placing.shrink) : picture;
    const { width, height, left, top, repeatX, repeatY } = placing;
    const rowPitch = smaller.height * repeatY / picture.height / height;
    const columnPitch = smaller.width * repeatX / picture.width / width;
    return {
        rows: [top / height, rowPitch, picture.height],
        columns: [left / width, columnPitch, picture.width],
    };
}
