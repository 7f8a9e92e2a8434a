// How many samples the accumulating passes of a look have taken.

import { countOf, readPass } from './plan.js';

/** @typedef {import('../look/types.js').LookDescription} SampledLook */

/**
 * The passes that a change of these passes affects within a frame, including these.
 * @param {SampledLook} look
 * @param {boolean[]} changed
 * @returns {boolean[]}
 */
function affectedPasses(look, changed) {
    const affected = [...changed];
    look.passes.forEach((pass, i) => {
        for (const input of pass.inputs) {
            const read = readPass(look, i, input);
            if (input.from === 'pass' && read.framesAgo === 0 && affected[read.pass])
                affected[i] = true;
        }
    });
    return affected;
}

/** Counts the samples by pass. */
export class AccumulatedSamples {
    /** @param {SampledLook} look */
    constructor(look) {
        this.look = look;
        /** @type {number[]} */
        this.held = look.passes.map(() => 0);
    }

    /** Discards all samples. */
    restart() {
        this.held.fill(0);
    }

    /**
     * Discards the samples that depend on parameters.
     * @param {string[]} names
     */
    restartAfter(names) {
        this.restartPasses(this.look.passes.map((pass) =>
            Object.values(pass.parameters).some((one) => names.includes(one))));
    }

    /** Discards the samples that depend on the pointer. */
    restartAfterPointer() {
        this.restartPasses(this.look.passes.map((pass) =>
            pass.built_ins.some((one) => one.value === 'mouse' || one.value === 'press')));
    }

    /** @param {boolean[]} changed */
    restartPasses(changed) {
        affectedPasses(this.look, changed).forEach((isAffected, i) => {
            if (isAffected)
                this.held[i] = 0;
        });
    }

    /**
     * The draws of an accumulating pass in this frame.
     * @param {number} pass
     * @param {Map<string, number[]>} values
     */
    beginFrame(pass, values) {
        const { repeat, converge } = this.look.passes[pass];
        const draws = repeatsOf(repeat, values);
        if (converge === undefined)
            return draws;
        const enough = Math.max(0, Math.floor(countOf(converge, values, 0)));
        if (enough === 0) {
            this.held[pass] = 0;
            return draws;
        }
        return Math.min(draws, Math.max(0, enough - this.held[pass]));
    }

    /**
     * Samples of the last accumulating pass before this one.
     * @param {number} pass
     */
    before(pass) {
        for (let i = pass - 1; i >= 0; i--)
            if (this.look.passes[i].accumulate)
                return this.held[i];
        return 0;
    }
}

/**
 * Draws of a pass in a frame.
 * @param {number|string|undefined} repeat
 * @param {Map<string, number[]>} values
 */
export function repeatsOf(repeat, values) {
    return Math.floor(Math.min(Math.max(countOf(repeat, values, 1), 1), 4096));
}
