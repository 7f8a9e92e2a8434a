// The screen of a two-channel oscilloscope: converts two voltages to beam points.
import { chargeOfPoint, tracePoints } from '../points.js';
import { DIVISIONS_UP } from './scope_controls.js';

/**
 * Writes both channels at a sample, after the coupling, in a sweep that started at `start` seconds.
 * @typedef {(sample: number, start: number, volts: Float32Array) => void} VoltsReader
 */

/**
 * Traces over time go from -1 to 1 across 10 divisions.
 * Vertically, and on both axes in xy, a division is 0.25.
 */
export class Scope {
    #rate;
    #sweepSamples;
    #isXy;
    #channels; // of the traces, from 0
    #charge;
    #scale = new Float32Array(2);
    #offset = new Float32Array(2);
    #volts = new Float32Array(2);

    /**
     * @param {import('./scope_controls.js').ScopeControls} controls
     * @param {[boolean, boolean]} isShown channels with a trace
     * @param {number} rate of the input, in samples per second
     */
    constructor(controls, isShown, rate) {
        this.#rate = rate;
        this.#sweepSamples = controls.sweepSeconds * rate;
        this.#isXy = controls.isXy;
        this.#channels = [0, 1].filter((channel) => isShown[channel]);
        this.#charge = chargeOfPoint(rate * this.#traces);
        const isSplit = controls.isSplit && this.#traces === 2;
        const halfHeight = DIVISIONS_UP / 2;
        controls.channels.forEach((channel, i) => {
            let scale = 1 / (channel.voltsPerDivision * halfHeight);
            let offset = channel.offset / halfHeight;
            if (isSplit) {
                scale *= 0.5;
                offset = 0.5 * offset + (i === 0 ? 0.5 : -0.5);
            }
            this.#scale[i] = channel.isInverted ? -scale : scale;
            this.#offset[i] = offset;
        });
    }

    /** Of the input, in samples per second. */
    get rate() {
        return this.#rate;
    }

    /** Samples of the input in a sweep. */
    get sweepSamples() {
        return this.#sweepSamples;
    }

    /**
     * Appends the points of the samples in (start, end], up to sample `count`.
     * @param {number} start in s
     * @param {number} end in s
     * @param {number} count Infinity for an input without an end
     * @param {import('./sweeps.js').ScopeSweeps} sweeps
     * @param {import('../beam.js').Beam} beam
     * @param {VoltsReader} readVolts
     */
    trace(start, end, count, sweeps, beam, readVolts) {
        const traces = this.#traces;
        if (this.#isXy) {
            tracePoints(start, end, this.#rate, beam, this.#xyWriter(readVolts), count);
        } else if (this.#channels.length > 0) {
            const write = this.#sweepWriter(sweeps, readVolts);
            tracePoints(start, end, this.#rate * traces, beam, write, count * traces);
        }
    }

    /** Number of traces that alternate. */
    get #traces() {
        return this.#channels.length === 2 && !this.#isXy ? 2 : 1;
    }

    /**
     * @param {VoltsReader} readVolts
     * @returns {import('../points.js').PointWriter}
     */
    #xyWriter(readVolts) {
        return (sample, points, at) => {
            readVolts(sample, 0, this.#volts);
            points[at] = this.#deflection(0);
            points[at + 1] = this.#deflection(1);
            points[at + 2] = this.#charge;
        };
    }

    /**
     * @param {import('./sweeps.js').ScopeSweeps} sweeps
     * @param {VoltsReader} readVolts
     * @returns {import('../points.js').PointWriter}
     */
    #sweepWriter(sweeps, readVolts) {
        const traces = this.#traces;
        /** @type {import('./sweeps.js').ScopeSweep | null} */
        let sweep = null;
        let sweepEnd = 0;
        return (point, points, at) => {
            const sample = Math.floor(point / traces);
            if (sample >= sweepEnd) {
                sweep = sweeps.latest(sample);
                sweepEnd = sweep ? sweep.end : 0;
            }
            if (sweep && sample < sweepEnd) {
                this.#writeOnSweep(sweep, point, readVolts, points, at);
            } else { // blanked while waiting
                points[at] = -1;
                points[at + 1] = 0;
                points[at + 2] = 0;
            }
        };
    }

    /**
     * A single trace is drawn in real time. Two traces alternate: each stretch of at most 1/60 s is
     * drawn at double speed on one channel, then on the other. Both get the same light.
     * @param {import('./sweeps.js').ScopeSweep} sweep
     * @param {number} point
     * @param {VoltsReader} readVolts
     * @param {Float32Array} points
     * @param {number} at
     */
    #writeOnSweep(sweep, point, readVolts, points, at) {
        const samples = sweep.end - sweep.first;
        let channel = this.#channels[0];
        let sample = point;
        let along = point - sweep.first; // in the stretch
        let length = samples; // of the stretch
        if (this.#traces === 2) {
            const turns = Math.max(Math.ceil(this.#sweepSamples * 60 / this.#rate - 1e-6), 1);
            const whole = Math.ceil(samples / turns);
            const index = point - 2 * sweep.first;
            const begin = Math.trunc(index / (2 * whole)) * whole;
            const within = index - 2 * begin;
            length = Math.min(whole, samples - begin);
            along = within % length;
            sample = sweep.first + begin + along;
            channel = within < length ? 0 : 1;
        }
        readVolts(sample, sweep.start / this.#rate, this.#volts);
        points[at] = Math.min(2 * sweep.across(sample) - 1, 1);
        points[at + 1] = this.#deflection(channel);
        // The move to the first point is blanked. The other points get its light.
        points[at + 2] = along === 0 ? 0 : this.#charge * length / (length - 1);
    }

    /**
     * @param {number} channel
     * @returns {number} of the beam, in half screens
     */
    #deflection(channel) {
        return Math.fround(this.#volts[channel] * this.#scale[channel]) + this.#offset[channel];
    }
}
