// A picture of indices into a small palette, for pixel art.

/**
 * Pixels that are drawn together: their positions and colours.
 * @typedef {object} CanvasLayer
 * @property {Uint32Array} positions y * width + x, ascending.
 * @property {Uint8Array} colors
 */

const bayerSteps = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];
const bayerThresholds = bayerSteps.map((step) => (step + 0.5) / 16);

/** Shapes have hard edges. Shades between two colours are dithered. (0, 0) is at the top left. */
export class IndexCanvas {
    /**
     * @param {number} width
     * @param {number} height
     */
    constructor(width, height) {
        this.width = width;
        this.height = height;
        /** Row 0 at the top. */
        this.pixels = new Uint8Array(width * height);
    }

    /**
     * The colour of the nearest pixel of the canvas.
     * @param {number} x
     * @param {number} y
     * @returns {number}
     */
    at(x, y) {
        const column = Math.min(Math.max(x, 0), this.width - 1);
        return this.pixels[Math.min(Math.max(y, 0), this.height - 1) * this.width + column];
    }

    /**
     * Pixels outside of the canvas are ignored.
     * @param {number} x
     * @param {number} y
     * @param {number} color
     */
    set(x, y, color) {
        if (x >= 0 && y >= 0 && x < this.width && y < this.height) {
            this.pixels[y * this.width + x] = color;
        }
    }

    /**
     * @param {number} x
     * @param {number} y
     * @param {number} width
     * @param {number} height
     * @param {number} color
     */
    rectangle(x, y, width, height, color) {
        for (let row = y; row < y + height; ++row) {
            for (let column = x; column < x + width; ++column) {
                this.set(column, row, color);
            }
        }
    }

    /**
     * @param {number} x Of the centre, rounded towards 0.
     * @param {number} y
     * @param {number} radius
     * @param {number} color
     */
    disc(x, y, radius, color) {
        const reach = Math.ceil(radius);
        for (let row = -reach; row <= reach; ++row) {
            for (let column = -reach; column <= reach; ++column) {
                if (column * column + row * row <= radius * radius) {
                    this.set(Math.trunc(x) + column, Math.trunc(y) + row, color);
                }
            }
        }
    }

    /**
     * One letter per pixel: 'a' is colour 0, 'b' colour 1, ...; '.' is transparent.
     * @param {number} x
     * @param {number} y
     * @param {string[]} rows
     */
    sprite(x, y, rows) {
        rows.forEach((letters, row) => {
            for (let column = 0; column < letters.length; ++column) {
                const color = letters.charCodeAt(column) - 97;
                if (color >= 0) {
                    this.set(x + column, y + row, color);
                }
            }
        });
    }

    /**
     * Dithers two colours with a 4 x 4 Bayer matrix.
     * @param {number} x
     * @param {number} y
     * @param {number} first
     * @param {number} second
     * @param {number} share The fraction of pixels of the second colour.
     */
    dithered(x, y, first, second, share) {
        const threshold = bayerThresholds[4 * (y & 3) + (x & 3)];
        this.set(x, y, share > threshold ? second : first);
    }

    /** @param {CanvasLayer} layer Of a canvas of this size. */
    stamp({ positions, colors }) {
        for (let i = 0; i < positions.length; ++i) {
            this.pixels[positions[i]] = colors[i];
        }
    }
}

/**
 * What `draw` draws, to stamp it repeatedly.
 * @param {number} width
 * @param {number} height
 * @param {(canvas: IndexCanvas) => void} draw Must not read the canvas.
 * @returns {CanvasLayer}
 */
export function canvasLayer(width, height, draw) {
    const transparent = 255;
    const canvas = new IndexCanvas(width, height);
    canvas.pixels.fill(transparent);
    draw(canvas);
    const positions = [];
    for (let i = 0; i < canvas.pixels.length; ++i) {
        if (canvas.pixels[i] !== transparent) {
            positions.push(i);
        }
    }
    return {
        positions: Uint32Array.from(positions),
        colors: Uint8Array.from(positions, (i) => canvas.pixels[i]),
    };
}
