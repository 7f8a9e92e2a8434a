// The amplitude spectrum of a sound, 60 times per second.
import { RealTransform } from './audio_transform.js';
import { cosineOfTurns } from './sine.js';

/** Spectra per second. */
export const HOPS_PER_SECOND = 60;

/**
 * Window functions as sums of cosines: the mean, and the coefficients of one and two periods.
 * Blackman has alpha = 0.16, as in Web Audio.
 * @type {{[name: string]: [number, number, number]}}
 */
const WINDOW_COSINES = { hann: [0.5, 0.5, 0], blackman: [0.42, 0.5, 0.08] };

/**
 * @param {number} amplitude
 * @returns {number} dB relative to full scale, at least -200
 */
export function decibelsOf(amplitude) {
    return 20 * Math.log10(Math.max(amplitude, 1e-10));
}

/** Spectra of the left input. A full-scale sine at the centre of a bin has amplitude 1. */
export class Spectrum {
    #input;
    #rate;
    #window;
    #transform;
    #kept; // weight of the amplitude of the last hop
    #memory; // hops to read after a jump in time
    #fullScale; // a real signal has half its energy at negative frequencies
    #hop = -Infinity;
    #volts;
    #samples;
    #magnitudes;
    #amplitudes;

    /**
     * @param {import('./audio_input.js').SoundInput} input
     * @param {number} size samples per transform, a power of two
     * @param {number} smoothingSeconds time constant of each amplitude
     * @param {'hann' | 'blackman'} windowName
     */
    constructor(input, size, smoothingSeconds, windowName = 'hann') {
        const [mean, once, twice] = WINDOW_COSINES[windowName];
        this.#input = input;
        this.#rate = input.rate / input.factor;
        this.#window = Float32Array.from({ length: size }, (_, i) =>
            mean - once * cosineOfTurns(i / size) + twice * cosineOfTurns(2 * i / size));
        this.#transform = new RealTransform(size);
        this.#kept = smoothingSeconds > 0
            ? Math.exp(-1 / (HOPS_PER_SECOND * smoothingSeconds)) : 0;
        // Older hops contribute less than e^-10.
        this.#memory = Math.ceil(10 * smoothingSeconds * HOPS_PER_SECOND);
        this.#fullScale = 2 / (mean * size);
        this.#volts = new Float32Array(2 * size);
        this.#samples = new Float32Array(size);
        this.#magnitudes = new Float64Array(size / 2 + 1);
        this.#amplitudes = new Float32Array(size / 2 + 1);
        this.hertzPerBin = this.#rate / size;
    }

    /**
     * The spectrum of the samples up to hop / 60 s.
     * @param {number} hop
     * @returns {Float32Array} size / 2 + 1 bins from 0 Hz on, valid until the next call
     */
    amplitudes(hop) {
        if (hop < this.#hop || hop > this.#hop + this.#memory + 1) {
            this.#amplitudes.fill(0);
            this.#hop = hop - this.#memory - 1;
        }
        while (this.#hop < hop) {
            this.#hop++;
            this.#smooth();
        }
        return this.#amplitudes;
    }

    #smooth() {
        const size = this.#samples.length;
        const end = Math.floor(this.#hop / HOPS_PER_SECOND * this.#rate + 1e-6);
        this.#input.readOriginals(end - size, size, this.#volts);
        for (let i = 0; i < size; i++) {
            this.#samples[i] = this.#volts[2 * i] * this.#window[i];
        }
        this.#transform.run(this.#samples, this.#magnitudes);
        for (let i = 0; i < this.#amplitudes.length; i++) {
            const now = this.#fullScale * this.#magnitudes[i];
            this.#amplitudes[i] = now + this.#kept * (this.#amplitudes[i] - now);
        }
    }
}
