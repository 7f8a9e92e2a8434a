// Automatic gain: scales the peak of the last second of a sound to full scale.
import { linearBetween } from './sine.js';

const GAIN_BLOCKS_PER_SECOND = 10;
const MIN_GAIN_PEAK = Math.fround(0.01); // at most 40 dB of gain
const LIVE_GAIN_DELAY = 2; // blocks, so that all blocks read are complete
const PEAKS_REMEMBERED = 64;
const GAIN_READ_SIZE = 256; // samples

/** The gain at each position of a stream. It depends on the sound and the position only. */
export class AutoGain {
    #stream;
    #block; // samples
    #count; // number of blocks
    #peakBlocks = new Float64Array(PEAKS_REMEMBERED).fill(-1);
    #peaks = new Float32Array(PEAKS_REMEMBERED);
    #below = -1; // the block of these gains
    #gains = [0, 0]; // at its start and end
    #samples = new Float32Array(2 * GAIN_READ_SIZE);

    /** @param {import('./audio_stream.js').SampleStream} stream */
    constructor(stream) {
        this.#stream = stream;
        this.#block = Math.max(Math.trunc(stream.rate / GAIN_BLOCKS_PER_SECOND), 1);
        this.#count = Math.floor((stream.length + this.#block - 1) / this.#block);
    }

    /**
     * @param {number} position in samples of the stream
     * @returns {number}
     */
    at(position) {
        const delay = this.#stream.isLive ? LIVE_GAIN_DELAY : 0;
        const blocks = Math.max(position / this.#block - delay, 0);
        const below = Math.min(Math.trunc(blocks), this.#count - 1);
        if (below !== this.#below) {
            this.#gains = [this.#gainAt(below), this.#gainAt(below + 1)];
            this.#below = below;
        }
        const between = Math.fround(Math.min(blocks - below, 1));
        return Math.fround(linearBetween(this.#gains[0], this.#gains[1], between));
    }

    /**
     * The gain at the start of a block. It includes the peak of that block.
     * @param {number} block
     * @returns {number}
     */
    #gainAt(block) {
        let peak = MIN_GAIN_PEAK;
        for (let i = block - GAIN_BLOCKS_PER_SECOND; i <= block; i++) {
            const wrapped = ((i % this.#count) + this.#count) % this.#count;
            if (this.#stream.loops || wrapped === i) {
                peak = Math.max(peak, this.#peakOf(wrapped));
            }
        }
        return Math.fround(1 / peak);
    }

    /**
     * @param {number} block
     * @returns {number}
     */
    #peakOf(block) {
        const place = block % PEAKS_REMEMBERED;
        if (this.#peakBlocks[place] === block) {
            return this.#peaks[place];
        }
        const end = Math.min((block + 1) * this.#block, this.#stream.length);
        let peak = MIN_GAIN_PEAK;
        for (let first = block * this.#block; first < end; first += GAIN_READ_SIZE) {
            const count = Math.min(end - first, GAIN_READ_SIZE);
            this.#stream.read(first, count, this.#samples);
            for (let i = 0; i < 2 * count; i++) {
                peak = Math.max(peak, Math.abs(this.#samples[i]));
            }
        }
        this.#peakBlocks[place] = block;
        this.#peaks[place] = peak;
        return peak;
    }
}
