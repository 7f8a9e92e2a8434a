// The test picture 'glyph-rain': falling glyphs with bloom, in linear light.

import { fontWidth, fontHeight, hasFontDot } from './bitmap_font.js';
import { mixedPatternKey, patternHashShare } from './pattern_hash.js';
import { SoftBloom } from './soft_bloom.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/**
 * A run of glyphs that falls down a column repeatedly.
 * @typedef {object} GlyphDrop
 * @property {number} speed Cells per second.
 * @property {number} length Of the trail, cells.
 * @property {number} way Cells between starts: the rows and a pause.
 * @property {number} begin Cells.
 * @property {number} light Brightness factor. Dimmer drops look more distant.
 */

const glyphCellWidth = 8;  // dots
const glyphCellHeight = 10;  // dots
const dropsPerColumn = 2;
const firstGlyph = 33;  // '!': punctuation, digits, capitals
const glyphCount = 60;
const glyphHeadColor = Float32Array.of(0.65, 1, 0.75);
const glyphTrailColor = Float32Array.of(0.1, 0.85, 0.24);

/**
 * @param {number} column
 * @param {number} index
 * @param {number} rows
 * @returns {GlyphDrop}
 */
function glyphDrop(column, index, rows) {
    /** @param {number} which */
    const share = (which) => patternHashShare(column, index, which);
    const length = rows * (0.25 + 0.55 * share(1));
    const way = rows + length + rows * 0.9 * share(2);
    return {
        speed: 5 + 11 * share(0) * share(0),
        length,
        way,
        begin: way * share(3),
        light: share(4) < 0.45 ? 0.35 : 1,
    };
}

/**
 * The dots of a glyph as x, y, x, y, ... Mirrored, so that the glyphs look like an unknown script.
 * @param {number} code
 * @returns {Uint8Array}
 */
function mirroredGlyphDots(code) {
    const dots = [];
    for (let y = 0; y < fontHeight; ++y) {
        for (let x = 0; x < fontWidth; ++x) {
            if (hasFontDot(code, fontWidth - 1 - x, y)) {
                dots.push(x, y);
            }
        }
    }
    return Uint8Array.from(dots);
}

/** Heads are at 1, trails fade, and the bloom raises heads above 1. Unbounded linear light. */
export class GlyphRainPainter {
    /**
     * @param {number} width px
     * @param {number} height px
     */
    constructor(width = 1280, height = 720) {
        this.width = width;
        this.height = height;
        this.dot = Math.max(1, Math.trunc((height + 180) / 360));  // px
        this.columns = Math.trunc(width / (glyphCellWidth * this.dot)) + 1;
        this.rows = Math.trunc(height / (glyphCellHeight * this.dot)) + 1;
        this.drops = Array.from({ length: this.columns }, (_, column) =>
            Array.from({ length: dropsPerColumn }, (_, i) => glyphDrop(column, i, this.rows)));
        this.glyphs = Array.from(
            { length: glyphCount }, (_, i) => mirroredGlyphDots(firstGlyph + i));
        const cells = this.columns * this.rows;
        this.keys = new Float64Array(cells);
        this.paces = new Float64Array(cells);
        this.phases = new Float64Array(cells);
        for (let cell = 0; cell < cells; ++cell) {
            const column = Math.trunc(cell / this.rows);
            const row = cell % this.rows;
            this.keys[cell] = mixedPatternKey(row + mixedPatternKey(column + 0x9e3779b9));
            this.paces[cell] = 0.4 + 1.6 * patternHashShare(column, row, 11);
            this.phases[cell] = patternHashShare(column, row, 12);
        }
        this.trails = new Float32Array(cells);
        this.heads = new Uint8Array(cells);
        this.bloom = new SoftBloom(width, height);
        this.pixels = new Float32Array(width * height * 3);
    }

    /**
     * Pictures with the same number are equal.
     * @param {number} seconds
     * @returns {number}
     */
    numberAt(seconds) {
        return seconds;
    }

    /**
     * RGB floats. The next call reuses them.
     * @param {number} seconds
     * @returns {SourcePicture}
     */
    pictureAt(seconds) {
        this.updateCells(seconds);
        this.bloom.clear();
        this.drawGlyphs(seconds, true);
        this.bloom.blur();
        this.bloom.writeTo(this.pixels);
        this.drawGlyphs(seconds, false);
        return {
            width: this.width,
            height: this.height,
            channels: 3,
            encoding: 'linear',
            pixels: this.pixels,
            isTopFirst: true,
        };
    }

    /**
     * The brightness of the cells: 1 at the head of a drop, decreasing along its trail.
     * @param {number} seconds
     */
    updateCells(seconds) {
        const { rows, trails, heads } = this;
        trails.fill(0);
        heads.fill(0);
        this.drops.forEach((drops, column) => {
            for (const { begin, speed, way, length, light } of drops) {
                const head = Math.floor((begin + speed * seconds) % way);
                for (let row = Math.max(0, Math.ceil(head - length));
                    row <= Math.min(head, rows - 1); ++row) {
                    const cell = column * rows + row;
                    const left = 1 - (head - row) / length;
                    const trail = Math.fround(0.9 * light * left * Math.sqrt(left));
                    trails[cell] = Math.max(trails[cell], trail);
                    heads[cell] |= row === head && light === 1 ? 1 : 0;
                }
            }
        });
    }

    /**
     * The glyph of a cell changes about once per second, at times that differ between cells.
     * @param {number} cell
     * @param {number} seconds
     * @returns {Uint8Array}
     */
    glyphAt(cell, seconds) {
        const turn = Math.floor(seconds * this.paces[cell] + this.phases[cell]);
        return this.glyphs[mixedPatternKey(100 + turn + this.keys[cell]) % glyphCount];
    }

    /**
     * @param {number} seconds
     * @param {boolean} isBloom Whether they are drawn for the bloom or added to the picture.
     */
    drawGlyphs(seconds, isBloom) {
        const { dot, rows, trails, heads } = this;
        const light = new Float32Array(3);
        for (let cell = 0; cell < trails.length; ++cell) {
            const trail = trails[cell];
            if (trail <= 0) {
                continue;
            }
            for (let i = 0; i < 3; ++i) {
                light[i] = Math.max(glyphTrailColor[i] * trail, glyphHeadColor[i] * heads[cell]);
            }
            const left = (Math.trunc(cell / rows) * glyphCellWidth + 1) * dot;
            const top = (cell % rows * glyphCellHeight + 1) * dot;
            const dots = this.glyphAt(cell, seconds);
            for (let i = 0; i < dots.length; i += 2) {
                const x = left + dots[i] * dot;
                const y = top + dots[i + 1] * dot;
                if (isBloom) {
                    this.bloom.addSquare(x, y, dot, light);
                } else {
                    this.addSquare(x, y, light);
                }
            }
        }
    }

    /**
     * Adds a dot to the picture.
     * @param {number} left px
     * @param {number} top px
     * @param {Float32Array} light RGB.
     */
    addSquare(left, top, light) {
        const { pixels, width } = this;
        const right = Math.min(left + this.dot, width);
        const bottom = Math.min(top + this.dot, this.height);
        for (let y = top; y < bottom; ++y) {
            for (let x = left; x < right; ++x) {
                const at = (y * width + x) * 3;
                pixels[at] += light[0];
                pixels[at + 1] += light[1];
                pixels[at + 2] += light[2];
            }
        }
    }
}
