// When the sweeps of an oscilloscope start.

const SAMPLE_ROUNDING = 1e-3; // samples; rounding error of instants far from time 0

/**
 * The start times of a scope's sweeps; a pure function of the input.
 *
 * `latest` returns the last sweep that starts at or before a sample. It may have ended.
 * @typedef {{latest: (sample: number) => ScopeSweep | null}} ScopeSweeps
 */

/** @type {ScopeSweeps} */
export const NO_SWEEPS = { latest: () => null };

/**
 * A sweep of the beam over input samples, counted in samples. Sample k has the instant k + 1.
 * The sweep covers the instants (start, start + length].
 */
export class ScopeSweep {
    /**
     * @param {number} start
     * @param {number} length
     * @param {number} [cut] no samples from here on
     */
    constructor(start, length, cut = Infinity) {
        this.start = start;
        this.length = length;
        /** The first sample. */
        this.first = sampleAfter(start);
        /** One after the last sample. */
        this.end = Math.min(sampleAfter(start + length), cut);
    }

    /**
     * @param {number} sample
     * @returns {number} position across, 0 left to 1 right
     */
    across(sample) {
        return (sample + 1 - this.start) / this.length;
    }
}

/**
 * The first sample with an instant after this one, apart from rounding errors.
 * @param {number} instant
 * @returns {number}
 */
export function sampleAfter(instant) {
    return Math.floor(instant + SAMPLE_ROUNDING);
}

/** Sweeps with a constant period. */
export class PeriodicSweeps {
    #start;
    #period;
    #length;
    /** @type {ScopeSweep | null} */
    #latest = null;

    /**
     * @param {number} start in samples, as all three
     * @param {number} period 0: a single sweep
     * @param {number} length
     */
    constructor(start, period, length) {
        this.#start = start;
        this.#period = period;
        this.#length = length;
    }

    /**
     * @param {number} sample
     * @returns {ScopeSweep | null}
     */
    latest(sample) {
        const before = sample + 1 - SAMPLE_ROUNDING - this.#start;
        if (before <= 0) {
            return null;
        }
        const number = this.#period > 0 ? Math.ceil(before / this.#period) - 1 : 0;
        const start = this.#start + number * this.#period;
        if (this.#latest?.start !== start) {
            this.#latest = new ScopeSweep(start, this.#length);
        }
        return this.#latest;
    }
}
