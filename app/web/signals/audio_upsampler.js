// Interpolates a sound with a Kaiser-windowed sinc.

const UPSAMPLER_TAPS = 32;
const TAPS_BEFORE = UPSAMPLER_TAPS / 2 - 1;
const ORIGINALS_PER_BLOCK = 128;
const KAISER_BETA = 8; // attenuates images by 80 dB

/**
 * The modified Bessel function of the first kind, order 0, by its power series.
 * @param {number} x
 * @returns {number}
 */
function besselOfOrderZero(x) {
    let sum = 1;
    let term = 1;
    for (let n = 1; term > 1e-12 * sum; n++) {
        term *= (x / (2 * n)) * (x / (2 * n));
        sum += term;
    }
    return sum;
}

/**
 * sin(pi x) / (pi x) times the Kaiser window (J. F. Kaiser) over all taps.
 * @param {number} x in samples
 * @returns {number}
 */
function windowedSinc(x) {
    const angle = Math.PI * x;
    const across = x / (UPSAMPLER_TAPS / 2);
    if (Math.abs(across) >= 1) {
        return 0;
    }
    const window = besselOfOrderZero(KAISER_BETA * Math.sqrt(1 - across * across));
    return (x === 0 ? 1 : Math.sin(angle) / angle) * (window / besselOfOrderZero(KAISER_BETA));
}

/**
 * The weights of the taps for a position between two samples. Their sum is 1.
 * @param {number} fraction 0..1
 * @returns {Float32Array}
 */
function upsamplerWeights(fraction) {
    const weights = new Float64Array(UPSAMPLER_TAPS);
    let sum = 0;
    for (let tap = 0; tap < UPSAMPLER_TAPS; tap++) {
        weights[tap] = windowedSinc(tap - TAPS_BEFORE - fraction);
        sum += weights[tap];
    }
    return Float32Array.from(weights, (weight) => weight / sum);
}

/**
 * Every fourth product of samples and weights, summed in floats like in the program.
 * @param {Float32Array} window left and right pairs
 * @param {number} at index of the first sample
 * @param {Float32Array} weights
 * @param {number} tap the first one, 0..3
 * @returns {number}
 */
function everyFourthTap(window, at, weights, tap) {
    let sum = 0;
    for (let i = tap; i < UPSAMPLER_TAPS; i += 4) {
        sum = Math.fround(sum + Math.fround(window[at + 2 * i] * weights[i]));
    }
    return sum;
}

/**
 * @param {Float32Array} window left and right pairs
 * @param {number} at index of the first sample
 * @param {Float32Array} weights
 * @returns {number}
 */
function interpolatedSample(window, at, weights) {
    const even = Math.fround(
        everyFourthTap(window, at, weights, 0) + everyFourthTap(window, at, weights, 1));
    const odd = Math.fround(
        everyFourthTap(window, at, weights, 2) + everyFourthTap(window, at, weights, 3));
    return even + odd;
}

/** A stream up-sampled by a whole factor. Sample k * factor is exactly sample k of the stream. */
export class Upsampler {
    #window = new Float32Array(2 * (ORIGINALS_PER_BLOCK + UPSAMPLER_TAPS));
    /** @type {Float32Array[]} */
    #weights = [];

    /**
     * @param {import('./audio_stream.js').SampleStream} stream
     * @param {number} factor 1 to 16
     */
    constructor(stream, factor) {
        this.stream = stream;
        this.factor = factor;
        for (let phase = 0; phase < factor; phase++) {
            this.#weights.push(upsamplerWeights(phase / factor));
        }
    }

    /**
     * @param {number} first up-sampled sample, any number
     * @param {number} count
     * @param {Float32Array} target left and right pairs
     */
    read(first, count, target) {
        const window = this.#window;
        let index = Math.floor(first / this.factor);
        let phase = first - index * this.factor;
        let to = 0;
        while (to < 2 * count) {
            this.stream.read(index - TAPS_BEFORE, window.length / 2, window);
            for (let at = 0; at < 2 * ORIGINALS_PER_BLOCK && to < 2 * count; at += 2) {
                for (; phase < this.factor && to < 2 * count; phase++, to += 2) {
                    this.#write(at, phase, target, to);
                }
                phase = 0;
            }
            index += ORIGINALS_PER_BLOCK;
        }
    }

    /**
     * @param {number} at index of the sample's first tap in the window
     * @param {number} phase
     * @param {Float32Array} target
     * @param {number} to
     */
    #write(at, phase, target, to) {
        const window = this.#window;
        if (phase === 0) {
            target[to] = window[at + 2 * TAPS_BEFORE];
            target[to + 1] = window[at + 2 * TAPS_BEFORE + 1];
            return;
        }
        target[to] = interpolatedSample(window, at, this.#weights[phase]);
        target[to + 1] = interpolatedSample(window, at + 1, this.#weights[phase]);
    }
}
