// When the constants of shaders have changed, so that the passes must be compiled again.

import { exportedNumbers } from '../controls/parameter_text.js';
import { shaderConstants } from '../graph/shader_constants.js';

const restSeconds = 0.2;  // without a change: the slider was released or is held

/** Compares values of constants with those in the compiled passes. */
export class ConstantChanges {
    #names;
    #compiled;
    #latest;
    #changed = 0;  // s, when

    /** @param {import('../look/types.js').LookDescription} look with the values in its texts */
    constructor(look) {
        this.#names = shaderConstants(look);
        this.#compiled = this.#latest = look.parameters.filter((one) =>
            this.#names.includes(one.name)).map((one) => String(exportedNumbers(one))).join(' ');
    }

    /**
     * Whether the passes must be compiled now. The next call assumes that they were.
     * @param {Map<string, number[]>} values
     * @param {number} now s
     * @param {boolean} isPatient waits for a slider that is dragged
     */
    isDue(values, now, isPatient) {
        if (this.#names.length === 0)
            return false;
        const wanted = this.#names.map((name) => String(values.get(name))).join(' ');
        if (wanted !== this.#latest)
            this.#changed = now;
        this.#latest = wanted;
        if (wanted === this.#compiled || (isPatient && now - this.#changed < restSeconds))
            return false;
        this.#compiled = wanted;
        return true;
    }
}
