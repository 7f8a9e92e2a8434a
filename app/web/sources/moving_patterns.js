// The moving test pictures by name, with their size and interlacing.

import { GlyphRainPainter } from './glyph_rain.js';
import { HarbourPainter } from './harbour.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/**
 * Draws a moving test picture.
 * @typedef {object} PatternPainter
 * @property {number} width px
 * @property {number} height px
 * @property {(seconds: number) => number} numberAt Pictures with the same number are equal.
 * @property {(seconds: number) => SourcePicture} pictureAt The next call reuses its pixels.
 */

const largestPatternSide = 8192;
const fieldsPerSecond = 60;

/** Interleaves the rows of the latest field and of the previous field. Upper field first. */
class InterlacedPainter {
    /** @param {PatternPainter} painter */
    constructor(painter) {
        this.painter = painter;
        this.width = painter.width;
        this.height = painter.height;
        this.field = -1;  // the latest one in `woven`
        /** @type {Float32Array | Uint8ClampedArray | null} */
        this.woven = null;
    }

    /**
     * The number of the field.
     * @param {number} seconds
     * @returns {number}
     */
    numberAt(seconds) {
        return Math.max(Math.floor(seconds * fieldsPerSecond + 1e-6), 0);
    }

    /**
     * @param {number} seconds
     * @returns {SourcePicture}
     */
    pictureAt(seconds) {
        const field = this.numberAt(seconds);
        // Rows of the previous field are still there if it was the latest one.
        if (field > 0 && this.field !== field - 1 && this.field !== field) {
            this.weave(field - 1, 2, (field + 1) % 2);
        }
        const picture = field > 0 ? this.weave(field, 2, field % 2) : this.weave(0, 1, 0);
        return { ...picture, pixels: /** @type {Float32Array} */ (this.woven) };
    }

    /**
     * Copies every `step`-th row of a field, from `first` on.
     * @param {number} field
     * @param {number} step
     * @param {number} first
     * @returns {SourcePicture} The field.
     */
    weave(field, step, first) {
        const picture = this.painter.pictureAt(field / fieldsPerSecond);
        const pixels = /** @type {Float32Array | Uint8ClampedArray} */ (picture.pixels);
        const woven = this.woven ?? pixels.slice();
        const length = picture.width * picture.channels;
        for (let y = first; y < picture.height; y += step) {
            woven.set(pixels.subarray(y * length, (y + 1) * length), y * length);
        }
        this.woven = woven;
        this.field = field;
        return picture;
    }
}

/**
 * @param {string} text Such as '640x480' or '640x480i'.
 * @returns {{width: number, height: number, isInterlaced: boolean}}
 */
function parsedPatternSize(text) {
    const parts = /^\+?(\d+)x\+?(\d+)(i?)$/.exec(text);
    const width = parts ? Number(parts[1]) : 0;
    const height = parts ? Number(parts[2]) : 0;
    if (!parts || width < 1 || height < 1 || width > largestPatternSide ||
        height > largestPatternSide) {
        throw new Error(`expected size=640x480 or size=640x480i, got 'size=${text}'`);
    }
    return { width, height, isInterlaced: parts[3] === 'i' };
}

/**
 * The painter of a moving pattern such as 'harbour' or 'glyph-rain,size=640x480i'. Null: the name
 * is not that of a moving pattern. Throws an Error with a message for the user.
 * @param {string} text
 * @returns {PatternPainter | null}
 */
export function makePatternPainter(text) {
    const comma = text.indexOf(',');
    const name = comma < 0 ? text : text.slice(0, comma);
    const Painter = name === 'harbour' ? HarbourPainter :
        name === 'glyph-rain' ? GlyphRainPainter : null;
    if (!Painter || comma < 0) {
        return Painter ? new Painter() : null;
    }
    const setting = text.slice(comma + 1);
    if (!setting.startsWith('size=')) {
        throw new Error(`unknown pattern setting '${setting}'; use size=WxH`);
    }
    const { width, height, isInterlaced } = parsedPatternSize(setting.slice(5));
    const painter = new Painter(width, height);
    return isInterlaced ? new InterlacedPainter(painter) : painter;
}
