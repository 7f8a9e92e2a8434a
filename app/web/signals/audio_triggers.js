// Sweeps of a scope that are triggered by a sound.
import { ScopeSweep } from './scope/sweeps.js';
import { ENDLESS_SAMPLES } from './audio_stream.js';

const UNTRIGGERED_SECONDS = 0.1; // without a trigger, before `auto` starts a sweep
const MIN_EPOCH_SECONDS = 4;
const SWEEPS_PER_EPOCH = 16;
const TRIGGER_READ_SIZE = 64; // samples

/**
 * Sweeps that are found on demand. Instants are in up-sampled samples, as in ScopeSweep.
 * The scope is re-armed at the start of each epoch, so that jumps in time do not change the sweeps.
 * This cuts off the sweep in progress.
 */
export class TriggeredSweeps {
    #input;
    #trigger;
    #channel;
    #sign; // makes the slope rising
    #level;
    #length;
    #busy; // sweep and hold-off
    #timeout;
    #epochLength = ENDLESS_SAMPLES; // samples of the sound
    #epoch = -1;
    #next = 0; // the next sample of the sound to examine
    #last = 0; // the last sample relative to the trigger level
    #ready = 0; // earliest start of the next sweep
    #event = 0; // the last trigger, whether or not it started a sweep
    /** @type {ScopeSweep[]} */
    #sweeps = [];
    #volts = new Float32Array(2 * TRIGGER_READ_SIZE);

    /**
     * @param {import('./audio_input.js').SoundInput} input
     * @param {import('./scope/scope_controls.js').ScopeTrigger} trigger
     * @param {number} channel 0 or 1
     * @param {boolean} isInverted
     * @param {number} length of a sweep
     */
    constructor(input, trigger, channel, isInverted, length) {
        const slope = trigger.isRising ? 1 : -1;
        this.#input = input;
        this.#trigger = trigger;
        this.#channel = channel;
        this.#sign = isInverted ? -slope : slope;
        this.#level = slope * Math.fround(trigger.level);
        this.#length = length;
        this.#busy = length + trigger.holdoffSeconds * input.rate;
        this.#timeout = UNTRIGGERED_SECONDS * input.rate;
        if (trigger.mode !== 'single') { // that searches once from time 0
            const epoch = Math.max(MIN_EPOCH_SECONDS * input.rate, SWEEPS_PER_EPOCH * this.#busy);
            this.#epochLength = Math.ceil(epoch / input.factor);
        }
    }

    /**
     * The last sweep that starts at or before a sample.
     * @param {number} sample
     * @returns {ScopeSweep | null}
     */
    latest(sample) {
        const epoch = Math.floor(Math.floor(sample / this.#input.factor) / this.#epochLength);
        if (epoch !== this.#epoch) {
            this.#begin(epoch);
        }
        this.#findUpTo(sample);
        let low = 0;
        let high = this.#sweeps.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.#sweeps[middle].first <= sample) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low > 0 ? this.#sweeps[low - 1] : null;
    }

    /**
     * Starts earlier by the timeout, to find out whether the sound fires the trigger at all.
     * @param {number} epoch
     */
    #begin(epoch) {
        const first = epoch * this.#epochLength;
        this.#epoch = epoch;
        this.#next = first - Math.ceil(this.#timeout / this.#input.factor);
        this.#ready = first * this.#input.factor;
        this.#event = -Infinity;
        this.#last = 0;
        this.#sweeps = [];
    }

    /** @param {number} sample */
    #findUpTo(sample) {
        const volts = this.#volts;
        if (this.#ready === Infinity) {
            return; // the single sweep was found
        }
        while ((this.#next - 1) * this.#input.factor <= sample) {
            this.#input.readOriginals(this.#next, TRIGGER_READ_SIZE, volts);
            for (let at = this.#channel; at < 2 * TRIGGER_READ_SIZE; at += 2) {
                this.#follow(Math.fround(this.#sign * volts[at] - this.#level));
            }
        }
    }

    /**
     * The crossing is interpolated linearly between samples.
     * @param {number} level of the next sample, relative to the trigger level
     */
    #follow(level) {
        const factor = this.#input.factor;
        const now = this.#next * factor + 1;
        if (this.#last < 0 && level >= 0) {
            const rise = Math.fround(level - this.#last);
            const crossing = now - factor * level / rise;
            this.#beginUntriggered(crossing);
            this.#event = crossing;
            if (crossing >= this.#ready) {
                this.#sweepFrom(crossing);
            }
        }
        this.#beginUntriggered(now);
        this.#last = level;
        this.#next++;
    }

    /** @param {number} now */
    #beginUntriggered(now) {
        if (this.#trigger.mode !== 'auto') {
            return;
        }
        let start = Math.max(this.#ready, this.#event + this.#timeout);
        while (start <= now) {
            this.#sweepFrom(start);
            start = Math.max(this.#ready, this.#event + this.#timeout);
        }
    }

    /** @param {number} instant */
    #sweepFrom(instant) {
        const cut = (this.#epoch + 1) * this.#epochLength * this.#input.factor;
        this.#sweeps.push(new ScopeSweep(instant, this.#length, cut));
        this.#ready = this.#trigger.mode === 'single' ? Infinity : instant + this.#busy;
    }
}
