// A first-order low-pass filter for a stereo stream.

const LOW_PASS_BLOCK = 512; // samples read at once

/**
 * Writes `count` samples from `first` on as left and right pairs.
 * @typedef {(first: number, count: number, target: Float32Array) => void} ReadSamples
 */

/**
 * A filter like an RC circuit. Each value depends only on the samples before it.
 * The state is recomputed ten times per second, so that the way of reading does not matter.
 */
export class LowPass {
    #read;
    #block; // samples after which the state is recomputed
    #memory; // samples of history for this
    #pull; // fraction by which a sample moves the state
    #next = NaN; // the sample that the state precedes
    #left = 0;
    #right = 0;
    #history = new Float32Array(2 * LOW_PASS_BLOCK);

    /**
     * @param {number} rate samples per second
     * @param {number} hertz -3 dB
     * @param {ReadSamples} read
     */
    constructor(rate, hertz, read) {
        const samples = rate / (2 * Math.PI * hertz);
        this.#read = read;
        this.#block = Math.max(Math.trunc(rate / 10), 1);
        this.#memory = Math.ceil(10 * samples); // older samples contribute less than 5e-5
        this.#pull = Math.fround(1 - Math.exp(-1 / samples));
    }

    /**
     * The filtered samples.
     * @param {number} first
     * @param {number} count
     * @param {Float32Array} target left and right pairs
     */
    read(first, count, target) {
        this.#read(first, count, target);
        for (let at = 0; at < 2 * count; at += 2, first++) {
            if (first !== this.#next || first % this.#block === 0) {
                this.#prime(first);
            }
            this.#follow(target[at], target[at + 1]);
            target[at] = this.#left;
            target[at + 1] = this.#right;
            this.#next = first + 1;
        }
    }

    /**
     * Computes the state before a sample, from the start of its block and the history before that.
     * @param {number} sample
     */
    #prime(sample) {
        const start = Math.floor(sample / this.#block) * this.#block;
        const history = this.#history;
        this.#left = 0;
        this.#right = 0;
        for (let first = start - this.#memory; first < sample; first += LOW_PASS_BLOCK) {
            const count = Math.min(sample - first, LOW_PASS_BLOCK);
            this.#read(first, count, history);
            for (let at = 0; at < 2 * count; at += 2) {
                this.#follow(history[at], history[at + 1]);
            }
        }
    }

    /**
     * @param {number} left
     * @param {number} right
     */
    #follow(left, right) {
        const f = Math.fround;
        this.#left = f(this.#left + f(this.#pull * f(left - this.#left)));
        this.#right = f(this.#right + f(this.#pull * f(right - this.#right)));
    }
}
