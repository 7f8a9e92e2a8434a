// The spectrum of a sound as a line or as a ring.
import { BeatDetector } from './audio_beats.js';
import { SoundInput } from './audio_input.js';
import { HOPS_PER_SECOND, Spectrum, decibelsOf } from './audio_spectrum.js';
import { chargeOfPoint, sweepPoint, tracePoints } from './points.js';
import { cosineOfTurns, linearBetween, sineOfTurns } from './sine.js';

const POINTS_PER_HOP = 4096;

/**
 * Levels in dB, frequencies in Hz, times in s. The radius is that of the ring at the floor level.
 * @typedef {{
 *   size: number, smoothingSeconds: number, low: number, high: number, floor: number,
 *   ceiling: number, isRadial: boolean, radius: number, pulse: number, beatThreshold: number,
 *   beatDecaySeconds: number
 * }} SpectrumControls
 */

/**
 * The spectrum at 60 Hz, with a logarithmic frequency scale.
 * Low frequencies are on the left of a line, and at the top of a ring.
 */
export class SoundSpectrum {
    #controls;
    #input;
    #spectrum;
    #beats;
    #charge = chargeOfPoint(POINTS_PER_HOP * HOPS_PER_SECOND);
    #edges = new Float64Array(POINTS_PER_HOP + 1); // of the columns, in bins
    #hop = NaN; // of the levels and the ring
    #levels = new Float32Array(POINTS_PER_HOP); // 0 floor to 1 ceiling
    #ring = 0;

    /**
     * @param {import('./audio_stream.js').SampleStream} stream
     * @param {import('./audio_input.js').SoundPlug} plug
     * @param {SpectrumControls} controls
     */
    constructor(stream, plug, controls) {
        this.#controls = controls;
        this.#input = new SoundInput(stream, plug);
        this.#spectrum = new Spectrum(this.#input, controls.size, controls.smoothingSeconds);
        this.#beats = new BeatDetector(this.#input, controls.beatThreshold);
        const octaves = Math.log2(controls.high / controls.low);
        for (let i = 0; i <= POINTS_PER_HOP; i++) {
            const hertz = controls.low * 2 ** (octaves * i / POINTS_PER_HOP);
            this.#edges[i] = hertz / this.#spectrum.hertzPerBin;
        }
    }

    /** Duration in s. */
    get seconds() {
        return this.#input.seconds;
    }

    /**
     * @param {number} start in s
     * @param {number} end in s
     * @param {import('./beam.js').Beam} beam
     */
    trace(start, end, beam) {
        const rate = POINTS_PER_HOP * HOPS_PER_SECOND;
        tracePoints(start, end, rate, beam, (k, points, at) => {
            const hop = Math.floor(k / POINTS_PER_HOP);
            if (hop !== this.#hop) {
                this.#showHop(hop);
            }
            const index = k - hop * POINTS_PER_HOP;
            if (this.#controls.isRadial) {
                this.#writeRingPoint(index, points, at);
            } else {
                sweepPoint(index, POINTS_PER_HOP, this.#charge, points, at);
                points[at + 1] = 2 * this.#levels[index] - 1;
            }
        }, Math.trunc(this.seconds * rate));
    }

    /** @param {number} hop */
    #showHop(hop) {
        const { ceiling, floor, isRadial, pulse, radius, beatDecaySeconds } = this.#controls;
        const amplitudes = this.#spectrum.amplitudes(hop);
        this.#hop = hop;
        for (let i = 0; i < POINTS_PER_HOP; i++) {
            const level = (this.#decibelsOfColumn(i, amplitudes) - floor) / (ceiling - floor);
            this.#levels[i] = Math.min(Math.max(level, 0), 1);
        }
        if (isRadial) {
            const now = hop / HOPS_PER_SECOND;
            const beat = this.#beats.lastBeat(now);
            const push = beat === null ? 0 : pulse * Math.exp((beat - now) / beatDecaySeconds);
            this.#ring = radius * (1 + push);
        }
    }

    /**
     * The loudest bin of a column. Between two bins it is interpolated linearly in dB.
     * @param {number} column
     * @param {Float32Array} amplitudes
     * @returns {number}
     */
    #decibelsOfColumn(column, amplitudes) {
        const low = this.#edges[column];
        const high = this.#edges[column + 1];
        const last = amplitudes.length - 1;
        if (low >= last) {
            return this.#controls.floor; // above the Nyquist frequency
        }
        const below = Math.trunc(low);
        const end = Math.min(Math.trunc(high), last);
        if (end === below) {
            return linearBetween(decibelsOf(amplitudes[below]), decibelsOf(amplitudes[below + 1]),
                0.5 * (low + high) - below);
        }
        let loudest = 0;
        for (let bin = below + 1; bin <= end; bin++) {
            loudest = Math.max(loudest, amplitudes[bin]);
        }
        return decibelsOf(loudest);
    }

    /**
     * @param {number} index
     * @param {Float32Array} points
     * @param {number} at
     */
    #writeRingPoint(index, points, at) {
        const { pulse, radius } = this.#controls;
        const turns = (index + 1) / POINTS_PER_HOP;
        const along = 1 - Math.abs(2 * turns - 1); // 0 at the top to 1 at the bottom
        const column = Math.trunc(along * (POINTS_PER_HOP - 1));
        const room = Math.max(1 - radius * (1 + pulse), 0);
        const distance = this.#ring + room * this.#levels[column];
        points[at] = distance * sineOfTurns(turns);
        points[at + 1] = distance * cosineOfTurns(turns);
        points[at + 2] = this.#charge;
    }
}
