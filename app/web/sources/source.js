// The interface of all source pictures.

/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */

/**
 * A picture. An array has interleaved channels, and bytes mean n/255. It is valid until the next
 * call of the source.
 * @typedef {object} SourcePicture
 * @property {number} width px
 * @property {number} height px
 * @property {number} channels 1 grey, 3 RGB, 4 RGBA (unassociated alpha).
 * @property {'display' | 'linear'} encoding sRGB values or linear light.
 * @property {Float32Array | Uint8Array | Uint8ClampedArray | ImageBitmap | HTMLVideoElement} pixels
 * @property {true} isTopFirst Row 0 is at the top.
 */

/** The source picture of a look. Other classes extend it. */
export class Source {
    /**
     * @param {string} name Shown to the user.
     * @param {SourceSettings} settings
     */
    constructor(name, settings) {
        this.name = name;
        this.settings = settings;
        /** Whether its pictures come from a device, so that no two runs are equal. */
        this.isLive = false;
        /** Whether it plays by itself, so that an earlier time can't be shown again. */
        this.hasOwnClock = false;
        /** A message about a picture that could not be shown, or ''. */
        this.problem = '';
    }

    /**
     * The picture at the end time of a frame. Null: unchanged since the last call, or not ready.
     * @param {number} seconds
     * @returns {SourcePicture | null}
     */
    pictureAt(seconds) {
        return null;
    }

    /**
     * The size of its pictures without prescale, px.
     * @returns {{width: number, height: number}}
     */
    naturalSize() {
        return { width: 0, height: 0 };
    }

    /**
     * Waits until pictureAt() can return exactly the picture of this time.
     * @param {number} seconds
     * @returns {Promise<void>}
     */
    prepare(seconds) {
        return Promise.resolve();
    }

    /** Makes the next pictureAt() return a picture, for a new WebGL context. */
    refresh() {}

    /**
     * Stops or continues a video.
     * @param {boolean} isPaused
     */
    setPaused(isPaused) {}

    /** Frees its pictures and devices. */
    dispose() {}
}
