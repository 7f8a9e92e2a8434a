// A sound as the two inputs of a scope, in volts after gain and coupling.
import { AutoGain } from './audio_gain.js';
import { LowPass } from './audio_low_pass.js';
import { ENDLESS_SAMPLES } from './audio_stream.js';
import { Upsampler } from './audio_upsampler.js';
import { linearBetween } from './sine.js';

const COUPLING_HERTZ = 5;
const READER_BLOCK = 2048; // up-sampled samples

/**
 * How a sound is connected.
 * `channels` are the sound channels that go to the two inputs, `level` is a factor.
 * @typedef {{
 *   channels: 'both' | 'mean' | 'left' | 'right',
 *   isSwapped: boolean,
 *   coupling: [string, string],
 *   level: number,
 *   hasAutoGain: boolean,
 *   upsample: number
 * }} SoundPlug
 */

/**
 * @param {Partial<SoundPlug>} plug
 * @returns {SoundPlug}
 */
export function completePlug(plug) {
    return {
        channels: 'both', isSwapped: false, coupling: ['dc', 'dc'], level: 1, hasAutoGain: false,
        upsample: 1, ...plug,
    };
}

/**
 * @param {Float32Array} buffer
 * @param {number} length
 * @returns {Float32Array} the buffer, or a longer one if it is too short
 */
function atLeast(buffer, length) {
    return buffer.length < length ? new Float32Array(2 * length) : buffer;
}

/**
 * @param {string} coupling
 * @param {number} volts
 * @param {number} slow the part below 5 Hz
 * @returns {number}
 */
function coupledVolts(coupling, volts, slow) {
    if (coupling === 'gnd') {
        return 0;
    }
    return coupling === 'ac' ? Math.fround(volts - slow) : volts;
}

/** The inputs of a scope. */
export class SoundInput {
    #plug;
    #samples;
    #level;
    #gain;
    #isAlternating;
    #slow; // separate filters, because both keep a position
    #slowOriginals;
    #scratch = new Float32Array(0);

    /**
     * @param {import('./audio_stream.js').SampleStream} stream
     * @param {SoundPlug} plug
     */
    constructor(stream, plug) {
        this.stream = stream;
        this.factor = plug.upsample;
        /** Up-sampled samples per second. */
        this.rate = stream.rate * plug.upsample;
        this.#plug = plug;
        this.#samples = new Upsampler(stream, plug.upsample);
        this.#level = Math.fround(plug.level);
        this.#gain = plug.hasAutoGain ? new AutoGain(stream) : null;
        this.#isAlternating = plug.coupling.includes('ac');
        /** @type {import('./audio_low_pass.js').ReadSamples} */
        const read = (first, count, target) => this.#readRouted(first, count, target);
        this.#slow = new LowPass(stream.rate, COUPLING_HERTZ, read);
        this.#slowOriginals = new LowPass(stream.rate, COUPLING_HERTZ, read);
    }

    /** Number of up-sampled samples. */
    get count() {
        return (this.stream.loops ? ENDLESS_SAMPLES : this.stream.length) * this.factor;
    }

    /** Duration in s; Infinity for looping and live sound. */
    get seconds() {
        const isEndless = this.stream.loops || this.stream.isLive;
        return isEndless ? Infinity : this.stream.length / this.stream.rate;
    }

    /**
     * Reads up-sampled samples.
     * @param {number} first at least 0
     * @param {number} count
     * @param {Float32Array} target left and right pairs
     */
    read(first, count, target) {
        const factor = this.factor;
        const firstOriginal = Math.floor(first / factor);
        this.#samples.read(first, count, target);
        if (this.#isAlternating) {
            const slows = Math.floor((first + count) / factor) + 2 - firstOriginal;
            this.#scratch = atLeast(this.#scratch, 2 * slows);
            this.#slow.read(firstOriginal, slows, this.#scratch);
        }
        for (let i = 0; i < count; i++) {
            const original = Math.floor((first + i) / factor);
            const between = (first + i - original * factor) / factor;
            const at = 2 * (original - firstOriginal);
            this.#route(target, 2 * i);
            this.#couple(target, 2 * i, this.#slowAt(at, between), this.#slowAt(at + 1, between));
            this.#amplify(target, 2 * i, original % this.stream.length + between);
        }
    }

    /**
     * Reads at the sound's own rate.
     * @param {number} first any number
     * @param {number} count
     * @param {Float32Array} target left and right pairs
     */
    readOriginals(first, count, target) {
        const length = this.stream.length;
        if (this.#isAlternating) {
            this.#scratch = atLeast(this.#scratch, 2 * count);
            this.#slowOriginals.read(first, count, this.#scratch);
        }
        this.#readRouted(first, count, target);
        for (let i = 0; i < count; i++) {
            this.#couple(target, 2 * i, this.#scratch[2 * i], this.#scratch[2 * i + 1]);
            this.#amplify(target, 2 * i, (((first + i) % length) + length) % length);
        }
    }

    /**
     * @param {number} at index in the scratch buffer
     * @param {number} between position between this sample and the next one, 0..1
     * @returns {number} the part below 5 Hz
     */
    #slowAt(at, between) {
        if (!this.#isAlternating) {
            return 0;
        }
        const share = Math.fround(between);
        return Math.fround(linearBetween(this.#scratch[at], this.#scratch[at + 2], share));
    }

    /**
     * @param {number} first
     * @param {number} count
     * @param {Float32Array} target
     */
    #readRouted(first, count, target) {
        this.stream.read(first, count, target);
        for (let i = 0; i < count; i++) {
            this.#route(target, 2 * i);
        }
    }

    /**
     * @param {Float32Array} samples
     * @param {number} at
     */
    #route(samples, at) {
        if (this.#plug.channels === 'mean') {
            samples[at] = 0.5 * (samples[at] + samples[at + 1]);
        }
        if (this.#plug.isSwapped) {
            const left = samples[at];
            samples[at] = samples[at + 1];
            samples[at + 1] = left;
        }
    }

    /**
     * @param {Float32Array} samples
     * @param {number} at
     * @param {number} slowLeft
     * @param {number} slowRight
     */
    #couple(samples, at, slowLeft, slowRight) {
        const coupling = this.#plug.coupling;
        samples[at] = coupledVolts(coupling[0], samples[at], slowLeft);
        samples[at + 1] = coupledVolts(coupling[1], samples[at + 1], slowRight);
    }

    /**
     * @param {Float32Array} samples
     * @param {number} at
     * @param {number} position in samples of the sound
     */
    #amplify(samples, at, position) {
        const gain = this.#gain
            ? Math.fround(this.#level * this.#gain.at(position)) : this.#level;
        samples[at] *= gain;
        samples[at + 1] *= gain;
    }
}

/** Reads an input ahead in blocks, for mostly sequential access. */
export class SoundReader {
    #input;
    #first = 0;
    #filled = 0; // one past the last sample of the block

    /** Left and right pairs of the current block. */
    block = new Float32Array(2 * READER_BLOCK);

    /** @param {SoundInput} input */
    constructor(input) {
        this.#input = input;
    }

    /**
     * @param {number} sample
     * @param {number} end samples from here on are not needed
     * @returns {number} index of its left value in `block`
     */
    seek(sample, end) {
        if (sample < this.#first || sample >= this.#filled) {
            const count = Math.min(end - sample, READER_BLOCK);
            this.#input.read(sample, count, this.block);
            this.#first = sample;
            this.#filled = sample + count;
        }
        return 2 * (sample - this.#first);
    }

    /** Forgets the block. For live sound, whose samples can arrive after they were read. */
    forget() {
        this.#filled = this.#first;
    }
}
