// A source that is a moving test picture.

import { pictureWithoutPrescale } from './decoding.js';
import { makePatternPainter } from './moving_patterns.js';
import { sizeWithoutPrescale } from './prescaled.js';
import { Source } from './source.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */
/** @typedef {import('./moving_patterns.js').PatternPainter} PatternPainter */

/** The pattern 'harbour' or 'glyph-rain'. */
export class PatternSource extends Source {
    /**
     * @param {SourceSettings} settings
     * @param {PatternPainter} painter
     */
    constructor(settings, painter) {
        super(settings.content.replace(/^pattern:/, ''), settings);
        this.painter = painter;
        this.prescale = Math.max(settings.prescaled, 1);  // patterns are not searched for it
        this.shown = NaN;  // number of the latest picture
    }

    /**
     * @param {number} seconds
     * @returns {SourcePicture | null}
     */
    pictureAt(seconds) {
        const number = this.painter.numberAt(seconds);
        if (number === this.shown) {
            return null;
        }
        this.shown = number;
        return pictureWithoutPrescale(this.painter.pictureAt(seconds), this.prescale);
    }

    naturalSize() {
        return sizeWithoutPrescale(this.painter, this.prescale);
    }

    refresh() {
        this.shown = NaN;
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
