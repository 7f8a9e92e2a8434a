// A wide, soft bloom: a picture at a quarter of its size, blurred, and scaled up again.

const bloomStrength = Math.fround(1.6);
const bloomScale = 4;

/**
 * Where the pixels of one axis are read in the small picture.
 * @typedef {object} BloomAxis
 * @property {Int32Array} low The pixel before.
 * @property {Float64Array} share Of the pixel after.
 */

/**
 * @param {number} count Of pixels.
 * @param {number} small Of pixels in the small picture.
 * @returns {BloomAxis}
 */
function bloomAxis(count, small) {
    const low = new Int32Array(count);
    const share = new Float64Array(count);
    for (let i = 0; i < count; ++i) {
        const from = Math.min(Math.max((i + 0.5) / bloomScale - 0.5, 0), small - 1);
        low[i] = Math.trunc(from);
        share[i] = from - low[i];
    }
    return { low, share };
}

/**
 * A running mean along a row of RGB pixels. Black outside of the row.
 * @param {Float32Array} from
 * @param {number} start Index of the first value of the row.
 * @param {number} length Number of values of the row.
 * @param {Float32Array} to
 * @param {number} startTo
 * @param {number} reach Pixels on each side.
 */
function blurBloomRow(from, start, length, to, startTo, reach) {
    const share = 1 / (2 * reach + 1);
    const away = reach * 3;
    let red = 0;
    let green = 0;
    let blue = 0;
    for (let next = 0; next < length + away; next += 3) {
        if (next < length) {
            red += from[start + next];
            green += from[start + next + 1];
            blue += from[start + next + 2];
        }
        const middle = next - away;
        if (middle >= 0) {
            to[startTo + middle] = red * share;
            to[startTo + middle + 1] = green * share;
            to[startTo + middle + 2] = blue * share;
        }
        const last = start + middle - away;
        if (last >= start) {
            red -= from[last];
            green -= from[last + 1];
            blue -= from[last + 2];
        }
    }
}

/**
 * One row of the running means of all columns.
 * @param {Float64Array} sums Of the rows that the previous and this mean have in common.
 * @param {Float32Array} from
 * @param {number} last Index of the first row of this mean.
 * @param {number} next Index of its last row.
 * @param {Float32Array} to
 * @param {number} startTo
 * @param {number} share
 */
function blurBloomColumns(sums, from, last, next, to, startTo, share) {
    for (let i = 0; i < sums.length; ++i) {
        const sum = sums[i] + from[next + i];
        to[startTo + i] = sum * share;
        sums[i] = sum - from[last + i];
    }
}

/**
 * Writes four rows between an upper and a lower row. One loop is much faster than four.
 * @param {Float32Array} to
 * @param {number[]} rows
 * @param {Float64Array} shares Of the lower row, by row.
 * @param {Float64Array} upper
 * @param {Float64Array} lower
 */
function writeBloomRows(to, rows, shares, upper, lower) {
    const length = upper.length;
    const [at0, at1, at2, at3] = rows.map((row) => row * length);
    const [share0, share1, share2, share3] = rows.map((row) => shares[row]);
    for (let i = 0; i < length; ++i) {
        const value = upper[i];
        const change = lower[i] - value;
        to[at0 + i] = value + change * share0;
        to[at1 + i] = value + change * share1;
        to[at2 + i] = value + change * share2;
        to[at3 + i] = value + change * share3;
    }
}

/** RGB floats, row 0 at the top, black outside of the picture. */
export class SoftBloom {
    /**
     * @param {number} width Of the picture, px.
     * @param {number} height
     */
    constructor(width, height) {
        this.width = width;
        this.height = height;
        this.smallWidth = Math.ceil(width / bloomScale);
        this.smallHeight = Math.ceil(height / bloomScale);
        this.reach = Math.max(1, Math.trunc(height / 360));
        this.columns = bloomAxis(width, this.smallWidth);
        this.rows = bloomAxis(height, this.smallHeight);
        /** Means of 4 x 4 pixels. */
        this.small = new Float32Array(this.smallWidth * this.smallHeight * 3);
        /** The same size, with `reach` black rows above and below. */
        this.padded = new Float32Array(this.small.length + 2 * this.reach * this.smallWidth * 3);
        this.sums = new Float64Array(this.smallWidth * 3);
        this.upper = new Float64Array(width * 3);
        this.lower = new Float64Array(width * 3);
    }

    clear() {
        this.small.fill(0);
    }

    /**
     * Adds a square of one colour to the small picture. Clipped at the right and bottom.
     * @param {number} left
     * @param {number} top
     * @param {number} side px
     * @param {Float32Array} light RGB.
     */
    addSquare(left, top, side, light) {
        const { small, smallWidth } = this;
        const right = Math.min(left + side, this.width);
        const bottom = Math.min(top + side, this.height);
        for (let y = top; y < bottom; ++y) {
            for (let x = left; x < right; ++x) {
                const at = ((y >> 2) * smallWidth + (x >> 2)) * 3;
                small[at] += light[0] / 16;
                small[at + 1] += light[1] / 16;
                small[at + 2] += light[2] / 16;
            }
        }
    }

    /**
     * Three running means along each axis approximate a Gaussian (P. Kovesi, "Fast
     * Almost-Gaussian Filtering", DICTA 2010).
     */
    blur() {
        const { small, padded, reach, sums } = this;
        const length = sums.length;
        const share = 1 / (2 * reach + 1);
        for (let pass = 0; pass < 3; ++pass) {
            for (let y = 0; y < this.smallHeight; ++y) {
                blurBloomRow(small, y * length, length, padded, (y + reach) * length, reach);
            }
            sums.fill(0);
            for (let i = 0; i < 2 * reach * length; ++i) {
                sums[i % length] += padded[i];
            }
            for (let y = 0; y < this.smallHeight; ++y) {
                const last = y * length;
                blurBloomColumns(
                    sums, padded, last, last + 2 * reach * length, small, last, share);
            }
        }
    }

    /**
     * Interpolates a row of the small picture to the width of the picture.
     * @param {number} y
     * @param {Float64Array} to
     */
    widenRow(y, to) {
        const { small, smallWidth } = this;
        const { low, share } = this.columns;
        const start = y * smallWidth * 3;
        const end = start + (smallWidth - 1) * 3;
        for (let x = 0, at = 0; at < to.length; ++x, at += 3) {
            const left = start + low[x] * 3;
            const right = Math.min(left + 3, end);
            const after = bloomStrength * share[x];
            const before = bloomStrength - after;
            to[at] = small[left] * before + small[right] * after;
            to[at + 1] = small[left + 1] * before + small[right + 1] * after;
            to[at + 2] = small[left + 2] * before + small[right + 2] * after;
        }
    }

    /**
     * Writes the bloom of the small picture with bilinear interpolation.
     * @param {Float32Array} pixels
     */
    writeTo(pixels) {
        const { low, share } = this.rows;
        this.widenRow(0, this.lower);
        for (let y = 0, end = 0; y < this.height; y = end) {
            while (end < this.height && low[end] === low[y]) {
                ++end;
            }
            [this.upper, this.lower] = [this.lower, this.upper];
            this.widenRow(Math.min(low[y] + 1, this.smallHeight - 1), this.lower);
            for (let first = y; first < end; first += 4) {
                const rows = [0, 1, 2, 3].map((i) => Math.min(first + i, end - 1));
                writeBloomRows(pixels, rows, share, this.upper, this.lower);
            }
        }
    }
}
