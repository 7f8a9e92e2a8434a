// Turns pictures of palette indices into colours, at any size.

/** @typedef {import('./index_canvas.js').IndexCanvas} IndexCanvas */

/**
 * The old pixels along one axis that a new pixel covers, and their weights.
 * @typedef {object} AreaShare
 * @property {number} first Of the old pixels.
 * @property {number[]} weights Their sum is 1.
 */

/**
 * @param {number} from Number of old pixels.
 * @param {number} to Number of new pixels.
 * @returns {AreaShare[]}
 */
function areaShares(from, to) {
    const step = from / to;
    return Array.from({ length: to }, (_, i) => {
        const low = i * step;
        const high = low + step;
        /** @type {AreaShare} */
        const share = { first: -1, weights: [] };
        for (let at = Math.trunc(low); at < from && at < high; ++at) {
            const part = Math.min(high, at + 1) - Math.max(low, at);
            if (part > 1e-9 * step) {
                share.first = share.first < 0 ? at : share.first;
                share.weights.push(Math.fround(part / step));
            }
        }
        return share;
    });
}

/**
 * Each new pixel is the mean of the old area that it covers. Whole multiples stay sharp, and have
 * bytes. Other sizes have floats.
 */
export class PaletteScaler {
    /**
     * @param {number[]} palette 0xRRGGBB, display values.
     * @param {{width: number, height: number}} from
     * @param {{width: number, height: number}} to
     */
    constructor(palette, from, to) {
        this.from = from;
        this.to = to;
        this.isSharp = to.width % from.width === 0 && to.height % from.height === 0;
        this.bytes = Uint8Array.from(palette.flatMap(
            (color) => [color >> 16, color >> 8 & 255, color & 255]));
        this.floats = Float32Array.from(this.bytes, (byte) => byte / 255);
        const values = to.width * to.height * 3;
        this.colors = this.isSharp ? new Uint8ClampedArray(values) : new Float32Array(values);
        this.columns = this.isSharp ? [] : areaShares(from.width, to.width);
        this.rows = this.isSharp ? [] : areaShares(from.height, to.height);
        this.wide = new Float32Array(this.isSharp ? 0 : to.width * from.height * 3);
    }

    /**
     * RGB, row 0 at the top. The array is reused by the next call.
     * @param {IndexCanvas} canvas
     * @returns {Uint8ClampedArray | Float32Array}
     */
    colorsOf(canvas) {
        if (this.isSharp) {
            this.enlarge(canvas);
        } else {
            this.averageColumns(canvas);
            this.averageRows();
        }
        return this.colors;
    }

    /** @param {IndexCanvas} canvas */
    enlarge({ pixels }) {
        const { from, to, bytes, colors } = this;
        const timesX = to.width / from.width;
        const timesY = to.height / from.height;
        const length = to.width * 3;
        for (let y = 0; y < from.height; ++y) {
            const start = y * timesY * length;
            let at = start;
            for (let x = 0; x < from.width; ++x) {
                const color = pixels[y * from.width + x] * 3;
                for (let i = 0; i < timesX; ++i) {
                    colors[at++] = bytes[color];
                    colors[at++] = bytes[color + 1];
                    colors[at++] = bytes[color + 2];
                }
            }
            for (let i = 1; i < timesY; ++i) {
                colors.copyWithin(start + i * length, start, start + length);
            }
        }
    }

    /** @param {IndexCanvas} canvas */
    averageColumns({ pixels }) {
        const { from, to, floats, wide } = this;
        this.columns.forEach(({ first, weights }, x) => {
            for (let y = 0; y < from.height; ++y) {
                let red = 0;
                let green = 0;
                let blue = 0;
                for (let i = 0; i < weights.length; ++i) {
                    const color = pixels[y * from.width + first + i] * 3;
                    red += weights[i] * floats[color];
                    green += weights[i] * floats[color + 1];
                    blue += weights[i] * floats[color + 2];
                }
                const at = (y * to.width + x) * 3;
                wide[at] = red;
                wide[at + 1] = green;
                wide[at + 2] = blue;
            }
        });
    }

    averageRows() {
        const { to, wide, colors } = this;
        const length = to.width * 3;
        this.rows.forEach(({ first, weights }, y) => {
            for (let x = 0; x < length; ++x) {
                let sum = 0;
                for (let i = 0; i < weights.length; ++i) {
                    sum += weights[i] * wide[(first + i) * length + x];
                }
                colors[y * length + x] = sum;
            }
        });
    }
}
