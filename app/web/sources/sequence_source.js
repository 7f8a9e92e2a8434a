// A source that is a sequence of numbered pictures.

import { closePicture, decodedPicture, pictureWithoutPrescale, prescaleOf } from './decoding.js';
import { filmNumberAt, filmNumberWithin, usualFilmRate } from './film_time.js';
import { sizeWithoutPrescale } from './prescaled.js';
import { Source } from './source.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */
/** @typedef {import('./decoding.js').RawPicture} RawPicture */

/**
 * A picture of a sequence.
 * @typedef {object} SequencePicture
 * @property {string} name
 * @property {Blob | RawPicture} content
 */

const picturesAhead = 4;

/**
 * The text before and after the number of a name such as 'frame_%04d.png', and the minimum number
 * of digits. Null: not the name of a sequence.
 * @param {string} name
 * @returns {{before: string, after: string, digits: number} | null}
 */
function sequenceNameParts(name) {
    const parts = /^([^%]*)%(\d*)d([^%]*)$/.exec(name);
    const digits = parts ? Number(parts[2] || 1) : 0;
    if (!parts || digits < 1 || digits > 9 || parts[3].includes('/')) {
        return null;
    }
    return { before: parts[1], after: parts[3], digits };
}

/**
 * The pictures of a name such as 'media/frame_%04d.png', from the lowest number to the highest.
 * Undefined entries are missing. Null: not the name of a sequence.
 * @template Content
 * @param {string} name
 * @param {Map<string, Content>} media
 * @returns {(({name: string, content: Content}) | undefined)[] | null}
 */
export function picturesOfSequence(name, media) {
    const parts = sequenceNameParts(name);
    if (!parts) {
        return null;
    }
    const { before, after, digits } = parts;
    const found = new Map();
    for (const [file, content] of media) {
        const number = file.slice(before.length, file.length - after.length);
        const isNumber = file.startsWith(before) && file.endsWith(after) &&
            /^\d{1,9}$/.test(number) &&
            (number.length === digits || (number.length > digits && !number.startsWith('0')));
        if (isNumber) {
            found.set(Number(number), { name: file, content });
        }
    }
    const numbers = [...found.keys()];
    const first = numbers.reduce((a, b) => Math.min(a, b), Infinity);
    const last = numbers.reduce((a, b) => Math.max(a, b), -Infinity);
    return numbers.length === 0 ? [] :
        Array.from({ length: last - first + 1 }, (_, i) => found.get(first + i));
}

/** Decodes the requested picture and a few after it. */
export class SequenceSource extends Source {
    /**
     * Use openSequence(), which decodes the first picture.
     * @param {string} name
     * @param {SourceSettings} settings
     * @param {(SequencePicture | undefined)[]} pictures Undefined entries show the previous one.
     * @param {SourcePicture} first
     */
    constructor(name, settings, pictures, first) {
        super(name, settings);
        this.pictures = pictures;
        this.rate = settings.rate > 0 ? settings.rate : usualFilmRate;
        this.prescale = prescaleOf(first, settings.prescaled);
        this.fileSize = { width: first.width, height: first.height };
        this.size = sizeWithoutPrescale(first, this.prescale);
        /** @type {Map<number, Promise<void>>} Pictures that are decoded or being decoded. */
        this.requests = new Map([[0, Promise.resolve()]]);
        /** @type {Map<number, SourcePicture | null>} Null: not readable. */
        this.decoded = new Map([[0, this.original(first)]]);
        this.shown = -1;
        this.isDisposed = false;
    }

    /**
     * Null until the picture is decoded.
     * @param {number} seconds
     * @returns {SourcePicture | null}
     */
    pictureAt(seconds) {
        const number = this.numberAt(seconds);
        this.request(number);
        const picture = this.decoded.get(number);
        if (!picture || number === this.shown) {
            return null;
        }
        this.shown = number;
        return picture;
    }

    naturalSize() {
        return this.size;
    }

    /**
     * @param {number} seconds
     * @returns {Promise<void>}
     */
    async prepare(seconds) {
        const number = this.numberAt(seconds);
        this.request(number);
        await this.requests.get(number);
    }

    refresh() {
        this.shown = -1;
    }

    dispose() {
        this.isDisposed = true;
        this.decoded.forEach(closePicture);
        this.decoded.clear();
    }

    /**
     * @param {number} seconds
     * @returns {number}
     */
    numberAt(seconds) {
        const number = filmNumberAt(seconds, this.rate);
        return filmNumberWithin(number, this.pictures.length, this.settings.loops);
    }

    /**
     * Decodes a picture and the next ones, and frees all others but the shown one.
     * @param {number} number
     */
    request(number) {
        const near = new Set();
        for (let ahead = 0; ahead < picturesAhead; ++ahead) {
            near.add(filmNumberWithin(
                number + ahead, this.pictures.length, this.settings.loops));
        }
        for (const old of this.requests.keys()) {
            if (!near.has(old) && old !== this.shown) {
                closePicture(this.decoded.get(old) ?? null);
                this.decoded.delete(old);
                this.requests.delete(old);
            }
        }
        for (const wanted of near) {
            if (!this.requests.has(wanted)) {
                this.requests.set(wanted, this.decode(wanted));
            }
        }
    }

    /**
     * @param {number} number
     * @returns {Promise<void>}
     */
    async decode(number) {
        const picture = await this.decodedOrNull(this.pictures[number]);
        if (this.isDisposed || !this.requests.has(number)) {
            closePicture(picture);
        } else {
            this.decoded.set(number, picture);
        }
    }

    /**
     * @param {SourcePicture} picture As decoded. It is freed if the original is another one.
     * @returns {SourcePicture}
     */
    original(picture) {
        const original = pictureWithoutPrescale(picture, this.prescale);
        if (original !== picture) {
            closePicture(picture);
        }
        return original;
    }

    /**
     * @param {SequencePicture | undefined} entry
     * @returns {Promise<SourcePicture | null>}
     */
    async decodedOrNull(entry) {
        try {
            if (!entry) {
                throw new Error(`Pictures of '${this.name}' are missing. Export the page again.`);
            }
            const picture = await decodedPicture(entry.name, entry.content);
            const { width, height } = this.fileSize;
            if (picture.width !== width || picture.height !== height) {
                closePicture(picture);
                throw new Error(`'${entry.name}' is ${picture.width} x ${picture.height} px. ` +
                    `Use pictures of ${width} x ${height} px like the first one.`);
            }
            return this.original(picture);
        } catch (error) {
            this.problem = /** @type {Error} */ (error).message;
            return null;
        }
    }
}

/**
 * @param {string} name
 * @param {SourceSettings} settings
 * @param {(SequencePicture | undefined)[]} pictures In playback order. The first one exists.
 * @returns {Promise<SequenceSource>}
 */
export async function openSequence(name, settings, pictures) {
    const entry = pictures[0];
    if (!entry) {
        throw new Error(`Can't open '${name}': no numbered pictures match this name.`);
    }
    const first = await decodedPicture(entry.name, entry.content);
    return new SequenceSource(name, settings, pictures, first);
}
