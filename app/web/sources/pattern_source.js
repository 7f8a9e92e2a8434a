// A source that is a moving test picture.

import { pictureWithoutPrescale } from './decoding.js';
import { makePatternPainter } from './moving_patterns.js';
import { sizeWithoutPrescale } from './prescaled.js';
import { Source } from './source.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */
/** @typedef {import('./moving_patterns.js').PatternPainter} PatternPainter */

/**
 * 'Glyph rain' for 'pattern:glyph-rain,size=320x240'.
 * @param {string} content
 */
function patternTitle(content) {
    const words = content.replace(/^pattern:|,.*$/g, '').replace(/-/g, ' ');
    return words.charAt(0).toUpperCase() + words.slice(1);
}

const shortestInterval = 0.03;  // s between pictures
const paintingShare = 1 / 3;  // of the time

/** The pattern 'harbour' or 'glyph-rain'. Live, pictures that are painted slowly are left out. */
export class PatternSource extends Source {
    #shown = NaN;  // number of the latest picture
    #paintedAt = NaN;  // s
    #interval = shortestInterval;
    #isExact = false;

    /**
     * @param {SourceSettings} settings
     * @param {PatternPainter} painter
     */
    constructor(settings, painter) {
        super(patternTitle(settings.content), settings);
        this.painter = painter;
        this.prescale = Math.max(settings.prescaled, 1);  // patterns are not searched for it
    }

    /** Afterwards each frame has exactly its own picture. */
    prepare() {
        this.#isExact = true;
        return Promise.resolve();
    }

    /**
     * @param {number} seconds
     * @returns {SourcePicture | null}
     */
    pictureAt(seconds) {
        const number = this.painter.numberAt(seconds);
        const since = Math.abs(seconds - this.#paintedAt);
        if (number === this.#shown || (!this.#isExact && since < this.#interval)) {
            return null;
        }
        const begin = performance.now();
        this.#shown = number;
        this.#paintedAt = seconds;
        const picture = this.painter.pictureAt(seconds);
        const painting = (performance.now() - begin) / 1000;
        this.#interval = Math.max(shortestInterval, painting / paintingShare);
        return pictureWithoutPrescale(picture, this.prescale);
    }

    naturalSize() {
        return sizeWithoutPrescale(this.painter, this.prescale);
    }

    refresh() {
        this.#shown = NaN;
        this.#paintedAt = NaN;
    }
}

/**
 * The source of a text such as 'pattern:harbour,size=320x240i'. Null: not a moving pattern.
 * @param {SourceSettings} settings
 * @returns {PatternSource | null}
 */
export function makePatternSource(settings) {
    const isPattern = settings.content.startsWith('pattern:');
    const painter = isPattern ? makePatternPainter(settings.content.slice(8)) : null;
    return painter ? new PatternSource(settings, painter) : null;
}
