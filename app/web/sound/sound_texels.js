// The rows of sound textures: inputs of a look that are `from: "sound"`.
import { SoundInput, completePlug } from '../signals/audio_input.js';
import { HOPS_PER_SECOND, Spectrum, decibelsOf } from '../signals/audio_spectrum.js';
import { soundStream } from '../signals/audio_stream.js';

const TEXELS_FFT_SIZE = 2048; // samples
const PEAK_SAMPLES = 512; // a wave of one column is their largest
// AnalyserNode of the Web Audio API: smoothingTimeConstant and the ends of its decibel range.
const ANALYSER_KEEPS = 0.8;
const ANALYSER_FLOOR = -100;
const ANALYSER_CEILING = -30;
// The magnitude of a full-scale sine: half of it, times the mean of the Blackman window.
const ANALYSER_FULL_SCALE = 0.5 * 0.42;

/**
 * `holds` is wave, spectrum or analyser, see docs/portable.md. The texture has two rows.
 * @typedef {{holds: string, columns: number}} SoundTexture
 */

/**
 * Row by row, one float per texel.
 * @typedef {{width: number, height: number, values: Float32Array}} SoundRows
 */

/**
 * @param {number} sample
 * @returns {number}
 */
function waveLevel(sample) {
    return 0.5 + 0.5 * sample;
}

/**
 * @param {number} amplitude
 * @returns {number}
 */
function analyserLevel(amplitude) {
    const above = decibelsOf(ANALYSER_FULL_SCALE * amplitude) - ANALYSER_FLOOR;
    return Math.min(Math.max(above / (ANALYSER_CEILING - ANALYSER_FLOOR), 0), 1);
}

/**
 * Writes the largest of each column's bins. With fewer bins than columns, bins repeat.
 * @param {Float32Array} amplitudes
 * @param {Float32Array} row
 */
function writeSpectrumRow(amplitudes, row) {
    const bins = TEXELS_FFT_SIZE / 2;
    for (let i = 0; i < row.length; i++) {
        const first = Math.floor(i * bins / row.length);
        const end = Math.max(Math.floor((i + 1) * bins / row.length), first + 1);
        row[i] = 0;
        for (let bin = first; bin < end; bin++) {
            row[i] = Math.max(row[i], amplitudes[bin]);
        }
    }
}

/**
 * The rows of silence, for a look without a sound.
 * @param {SoundTexture} texture
 * @returns {SoundRows}
 */
export function silentTexels(texture) {
    const width = texture.columns;
    const values = new Float32Array(2 * width);
    values.fill(texture.holds === 'wave' ? 0.5 : 0, 0, width);
    values.fill(texture.holds === 'spectrum' ? 0 : 0.5, width);
    return { width, height: 2, values };
}

/** Fills sound textures from a stream: pure functions of the time. */
export class SoundTexels {
    #stream;
    #left;
    #right;
    #analyser;
    #samples = new Float32Array(0);

    /** @param {import('../signals/audio_stream.js').SampleStream} stream */
    constructor(stream) {
        const left = new SoundInput(stream, completePlug({ channels: 'left' }));
        const right = new SoundInput(stream, completePlug({ isSwapped: true }));
        const mean = new SoundInput(stream, completePlug({ channels: 'mean' }));
        const smoothing = -1 / (HOPS_PER_SECOND * Math.log(ANALYSER_KEEPS));
        this.#stream = stream;
        this.#left = new Spectrum(left, TEXELS_FFT_SIZE, 0);
        this.#right = new Spectrum(right, TEXELS_FFT_SIZE, 0);
        this.#analyser = new Spectrum(mean, TEXELS_FFT_SIZE, smoothing, 'blackman');
    }

    /**
     * The sound up to a time.
     * @param {SoundTexture} texture
     * @param {number} seconds
     * @returns {SoundRows}
     */
    rows(texture, seconds) {
        const width = texture.columns;
        const values = new Float32Array(2 * width);
        const end = Math.floor(seconds * this.#stream.rate + 1e-6);
        const hop = Math.floor(seconds * HOPS_PER_SECOND + 1e-6);
        if (texture.holds === 'wave') {
            this.#writeWave(end, values);
        } else if (texture.holds === 'spectrum') {
            writeSpectrumRow(this.#left.amplitudes(hop), values.subarray(0, width));
            writeSpectrumRow(this.#right.amplitudes(hop), values.subarray(width));
        } else {
            this.#writeAnalyser(hop, end, values);
        }
        return { width, height: 2, values };
    }

    /**
     * @param {number} end number of the first sample that is not read
     * @param {number} count
     * @returns {Float32Array} left and right pairs, valid until the next call
     */
    #samplesBefore(end, count) {
        if (this.#samples.length < 2 * count) {
            this.#samples = new Float32Array(2 * count);
        }
        this.#stream.read(end - count, count, this.#samples);
        return this.#samples;
    }

    /**
     * @param {number} end
     * @param {Float32Array} values
     */
    #writeWave(end, values) {
        const columns = values.length / 2;
        if (columns === 1) {
            const samples = this.#samplesBefore(end, PEAK_SAMPLES);
            values.fill(0.5);
            for (let i = 0; i < 2 * PEAK_SAMPLES; i++) {
                values[i % 2] = Math.max(values[i % 2], waveLevel(Math.abs(samples[i])));
            }
            return;
        }
        const samples = this.#samplesBefore(end, columns);
        for (let i = 0; i < columns; i++) {
            values[i] = waveLevel(samples[2 * i]);
            values[columns + i] = waveLevel(samples[2 * i + 1]);
        }
    }

    /**
     * @param {number} hop
     * @param {number} end
     * @param {Float32Array} values
     */
    #writeAnalyser(hop, end, values) {
        const columns = values.length / 2;
        const amplitudes = this.#analyser.amplitudes(hop);
        const samples = this.#samplesBefore(end, Math.max(columns, TEXELS_FFT_SIZE));
        for (let i = 0; i < columns; i++) {
            values[i] = analyserLevel(i < amplitudes.length ? amplitudes[i] : 0);
            values[columns + i] = waveLevel(0.5 * (samples[2 * i] + samples[2 * i + 1]));
        }
    }
}

/**
 * The rows of one sound texture. To draw frame after frame, keep a SoundTexels instead.
 * @param {import('./sound.js').Sound} sound
 * @param {number} seconds
 * @param {SoundTexture} texture
 * @param {boolean} [loops]
 * @returns {SoundRows}
 */
export function soundTexels(sound, seconds, texture, loops = false) {
    const stream = soundStream(sound, { first: 0, end: 0, loops });
    return new SoundTexels(stream).rows(texture, seconds);
}
