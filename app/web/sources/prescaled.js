// Detects and removes nearest-neighbour scaling of a picture by an integer.

/**
 * Pixels in memory: interleaved channels, row 0 at the top.
 * @typedef {object} PixelArray
 * @property {number} width
 * @property {number} height
 * @property {number} channels
 * @property {Float32Array | Uint8Array | Uint8ClampedArray} pixels
 */

const largestFoundPrescale = 8;
const fewestChanges = 8;

/**
 * @param {number} a
 * @param {number} b
 * @returns {number}
 */
function greatestCommonDivisor(a, b) {
    while (b !== 0) {
        [a, b] = [b, a % b];
    }
    return a;
}

/**
 * @param {PixelArray} picture
 * @param {number} y
 * @returns {boolean}
 */
function isRowNew({ width, channels, pixels }, y) {
    const length = width * channels;
    for (let i = y * length; i < (y + 1) * length; ++i) {
        if (pixels[i] !== pixels[i - length]) {
            return true;
        }
    }
    return false;
}

/**
 * @param {PixelArray} picture
 * @param {number} x
 * @returns {boolean}
 */
function isColumnNew({ width, height, channels, pixels }, x) {
    for (let y = 0; y < height; ++y) {
        const start = (y * width + x) * channels;
        for (let i = start; i < start + channels; ++i) {
            if (pixels[i] !== pixels[i - channels]) {
                return true;
            }
        }
    }
    return false;
}

/**
 * The positions where neighbouring lines differ: their greatest common divisor and their number.
 * Stops when the divisor is 1.
 * @param {number} length
 * @param {(position: number) => boolean} isNew
 * @returns {{divisor: number, count: number}}
 */
function changesAlong(length, isNew) {
    let divisor = length;
    let count = 0;
    for (let position = 1; position < length && divisor > 1; ++position) {
        if (isNew(position)) {
            divisor = greatestCommonDivisor(divisor, position);
            ++count;
        }
    }
    return { divisor, count };
}

/**
 * The integer factor, 2 to 8, by which a picture was enlarged with nearest-neighbour sampling. 1
 * for other pictures, and for pictures with changes at fewer than eight columns or rows.
 * @param {PixelArray} picture
 * @returns {number}
 */
export function foundPrescale(picture) {
    const rows = changesAlong(picture.height, (y) => isRowNew(picture, y));
    if (rows.divisor <= 1 || rows.count < fewestChanges) {
        return 1;
    }
    const columns = changesAlong(picture.width, (x) => isColumnNew(picture, x));
    if (columns.count < fewestChanges) {
        return 1;
    }
    const common = greatestCommonDivisor(rows.divisor, columns.divisor);
    for (let times = largestFoundPrescale; times > 1; --times) {
        if (common % times === 0) {
            return times;
        }
    }
    return 1;
}

/**
 * The size of the result of withoutPrescale().
 * @param {{width: number, height: number}} size
 * @param {number} times
 * @returns {{width: number, height: number}}
 */
export function sizeWithoutPrescale(size, times) {
    return {
        width: Math.max(Math.trunc(size.width / times), 1),
        height: Math.max(Math.trunc(size.height / times), 1),
    };
}

/**
 * The original of a picture that shows each pixel as `times` x `times` pixels: the middle pixel of
 * each block. Remaining pixels at the right and bottom are dropped.
 * @param {PixelArray} picture
 * @param {number} times
 * @returns {PixelArray} Its pixels have the type of the given ones.
 */
export function withoutPrescale(picture, times) {
    const { channels } = picture;
    const { width, height } = sizeWithoutPrescale(picture, times);
    const pixels = picture.pixels.slice(0, width * height * channels);
    const middle = Math.trunc(times / 2);
    let to = 0;
    for (let y = 0; y < height; ++y) {
        const fromY = Math.min(y * times + middle, picture.height - 1);
        for (let x = 0; x < width; ++x) {
            const fromX = Math.min(x * times + middle, picture.width - 1);
            const from = (fromY * picture.width + fromX) * channels;
            for (let i = 0; i < channels; ++i) {
                pixels[to++] = picture.pixels[from + i];
            }
        }
    }
    return { width, height, channels, pixels };
}
