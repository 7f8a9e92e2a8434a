// Channels of a sound as position, current and colour of the beam.
import { FLOATS_PER_POINT } from './beam.js';
import { samplesIn } from './clock.js';
import { linearBetween } from './sine.js';
import { numberSetting } from './signal.js';

/**
 * The channels that control the beam, from 1; 0 is unused.
 * @typedef {{
 *   x: number, y: number, intensity: number, r: number, g: number, b: number, hasTint: boolean
 * }} ChannelMap
 */

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @returns {ChannelMap}
 */
export function channelMap(settings) {
    const [x, y, intensity, r, g, b] =
        ['x', 'y', 'intensity', 'r', 'g', 'b'].map((key) => numberSetting(settings, key));
    return { x, y, intensity, r, g, b, hasTint: r > 0 || g > 0 || b > 0 };
}

/**
 * Throws an error if the sound lacks a channel. A mono sound may be both x and y.
 * @param {ChannelMap} map
 * @param {number} count channels of the sound
 */
export function checkChannels(map, count) {
    const y = count === 1 && map.y === 2 ? 1 : map.y;
    for (const [name, channel] of Object.entries({ ...map, y, hasTint: 0 })) {
        if (channel > count) {
            const has = count === 1 ? '1 channel' : `${count} channels`;
            throw new Error(`'${name}' is channel ${channel}, but the sound has only ${has}. ` +
                'Use another channel, or 0 for none.');
        }
    }
}

/**
 * The original samples around a range of up-sampled ones.
 * @param {import('./audio_stream.js').SampleStream} stream
 * @param {number} first original sample
 * @param {number} count
 * @param {Float32Array} target is used if it is long enough
 * @returns {Float32Array} left and right pairs
 */
function samplesAround(stream, first, count, target) {
    const samples = target.length < 2 * count ? new Float32Array(4 * count) : target;
    stream.read(first, count, samples);
    return samples;
}

/**
 * @param {Float32Array} samples left and right pairs
 * @param {number} at
 * @param {number} share 0 at this sample to 1 at the next one
 * @returns {number} not negative
 */
function lightBetween(samples, at, share) {
    return Math.max(linearBetween(samples[at], samples[at + 2], share), 0);
}

/**
 * A sound in xy mode with channels for the current and colour of the beam.
 * These are interpolated linearly, because a blanked beam must not ring.
 */
export class MappedSound {
    #signal;
    #currentAndRed;
    #greenAndBlue;
    #map;
    #factor;
    #reds = new Float32Array(0);
    #blues = new Float32Array(0);

    /**
     * @param {import('./signal.js').Signal} signal draws each sample `factor` times
     * @param {import('./audio_stream.js').SampleStream} currentAndRed
     * @param {import('./audio_stream.js').SampleStream} greenAndBlue
     * @param {ChannelMap} map
     * @param {number} factor
     */
    constructor(signal, currentAndRed, greenAndBlue, map, factor) {
        this.#signal = signal;
        this.#currentAndRed = currentAndRed;
        this.#greenAndBlue = greenAndBlue;
        this.#map = map;
        this.#factor = factor;
    }

    /** Duration in s. */
    get seconds() {
        return this.#signal.seconds;
    }

    /**
     * @param {number} start in s
     * @param {number} end in s
     * @param {import('./beam.js').Beam} beam
     */
    trace(start, end, beam) {
        const begin = beam.count;
        this.#signal.trace(start, end, beam);
        const count = beam.count - begin;
        const first = samplesIn(start, end, this.#currentAndRed.rate * this.#factor).first;
        const firstOriginal = Math.floor(first / this.#factor);
        const originals = Math.floor(count / this.#factor) + 3;
        this.#reds = samplesAround(this.#currentAndRed, firstOriginal, originals, this.#reds);
        this.#blues = samplesAround(this.#greenAndBlue, firstOriginal, originals, this.#blues);
        const tints = this.#map.hasTint ? beam.addTints() : null;
        for (let i = 0; i < count; i++) {
            const original = Math.floor((first + i) / this.#factor);
            const share = Math.fround((first + i - original * this.#factor) / this.#factor);
            const at = 2 * (original - firstOriginal);
            if (this.#map.intensity > 0) {
                beam.points[FLOATS_PER_POINT * (begin + i) + 2] *=
                    Math.fround(lightBetween(this.#reds, at, share));
            }
            if (tints) {
                this.#writeTint(tints, 3 * (begin + i), at, share);
            }
        }
    }

    /**
     * @param {Float32Array} tints
     * @param {number} to
     * @param {number} at
     * @param {number} share
     */
    #writeTint(tints, to, at, share) {
        tints[to] = lightBetween(this.#reds, at + 1, share);
        tints[to + 1] = lightBetween(this.#blues, at, share);
        tints[to + 2] = lightBetween(this.#blues, at + 1, share);
    }
}
