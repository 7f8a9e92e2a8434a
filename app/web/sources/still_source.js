// A source that is one picture.

import { closePicture, pictureWithoutPrescale, prescaleOf } from './decoding.js';
import { Source } from './source.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */

/** A decoded picture. */
export class StillSource extends Source {
    /**
     * @param {string} name
     * @param {SourceSettings} settings
     * @param {SourcePicture} picture As decoded.
     */
    constructor(name, settings, picture) {
        super(name, settings);
        this.picture = pictureWithoutPrescale(picture, prescaleOf(picture, settings.prescaled));
        if (this.picture !== picture) {
            closePicture(picture);
        }
        this.isShown = false;
    }

    /** @returns {SourcePicture | null} */
    pictureAt() {
        const picture = this.isShown ? null : this.picture;
        this.isShown = true;
        return picture;
    }

    naturalSize() {
        return { width: this.picture.width, height: this.picture.height };
    }

    refresh() {
        this.isShown = false;
    }

    dispose() {
        closePicture(this.picture);
    }
}
