// Beats of a sound, after F. Patin, "Beat Detection Algorithms", 2003.
import { LowPass } from './audio_low_pass.js';

const BEAT_BLOCKS_PER_SECOND = 100;
const BLOCKS_IN_MEAN = 100;
const BLOCKS_AT_REST = 20;
const BEAT_BLOCKS_BACK = 200;
const BASS_HERTZ = 150;
const SILENT_ENERGY = 1e-7; // mean square, 70 dB below full scale
const BLOCKS_REMEMBERED = 1024;

/** Values by block number. It keeps the latest ones. */
export class BlockMemory {
    #make;
    #blocks;
    #values;

    /**
     * @param {(block: number) => number} make computes a missing value
     * @param {number} capacity in blocks
     */
    constructor(make, capacity = BLOCKS_REMEMBERED) {
        this.#make = make;
        this.#blocks = new Float64Array(capacity).fill(NaN);
        this.#values = new Float64Array(capacity);
    }

    /**
     * @param {number} block
     * @returns {number}
     */
    at(block) {
        const capacity = this.#blocks.length;
        const place = ((block % capacity) + capacity) % capacity;
        if (this.#blocks[place] !== block) {
            const value = this.#make(block);
            this.#values[place] = value;
            this.#blocks[place] = block;
        }
        return this.#values[place];
    }
}

/**
 * Finds blocks of 10 ms whose bass is louder than the mean of the last second.
 * A beat is the first one after 0.2 s. It depends only on the 1.3 s before it.
 */
export class BeatDetector {
    #rate;
    #threshold;
    #bass;
    #samples;
    #energies = new BlockMemory((block) => this.#energyOf(block));
    #loud = new BlockMemory((block) => this.#isLoud(block) ? 1 : 0);

    /**
     * @param {import('./audio_input.js').SoundInput} input of which the left side is read
     * @param {number} threshold energy relative to the mean
     */
    constructor(input, threshold) {
        this.#rate = input.rate / input.factor;
        this.#threshold = threshold;
        this.#bass = new LowPass(this.#rate, BASS_HERTZ, (first, count, target) =>
            input.readOriginals(first, count, target));
        this.#samples = new Float32Array(2 * Math.ceil(this.#rate / BEAT_BLOCKS_PER_SECOND + 2));
    }

    /**
     * The time of the last beat.
     * @param {number} seconds
     * @returns {number | null} in s; null if it was more than 2 s ago
     */
    lastBeat(seconds) {
        const now = Math.floor(seconds * BEAT_BLOCKS_PER_SECOND + 1e-6);
        for (let block = now - 1; block >= now - BEAT_BLOCKS_BACK; block--) {
            if (this.#isBeat(block)) {
                return (block + 1) / BEAT_BLOCKS_PER_SECOND;
            }
        }
        return null;
    }

    /**
     * @param {number} block
     * @returns {boolean}
     */
    #isBeat(block) {
        if (!this.#loud.at(block)) {
            return false;
        }
        for (let i = block - BLOCKS_AT_REST; i < block; i++) {
            if (this.#loud.at(i)) {
                return false;
            }
        }
        return true;
    }

    /**
     * @param {number} block
     * @returns {boolean}
     */
    #isLoud(block) {
        let sum = 0;
        for (let i = block - BLOCKS_IN_MEAN; i < block; i++) {
            sum += this.#energies.at(i);
        }
        const now = this.#energies.at(block);
        return now > SILENT_ENERGY && now > this.#threshold * sum / BLOCKS_IN_MEAN;
    }

    /**
     * The mean square of the bass.
     * @param {number} block
     * @returns {number}
     */
    #energyOf(block) {
        const first = this.#firstSample(block);
        const count = this.#firstSample(block + 1) - first;
        this.#bass.read(first, count, this.#samples);
        let sum = 0;
        for (let i = 0; i < count; i++) {
            sum += this.#samples[2 * i] * this.#samples[2 * i];
        }
        return count === 0 ? 0 : sum / count;
    }

    /**
     * @param {number} block
     * @returns {number}
     */
    #firstSample(block) {
        return Math.floor(block / BEAT_BLOCKS_PER_SECOND * this.#rate + 1e-6);
    }
}
