// The Fourier transform of real samples.

/**
 * Reverses the lowest bits of a whole number.
 * @param {number} number
 * @param {number} bits
 * @returns {number}
 */
function reversedBits(number, bits) {
    let reversed = 0;
    for (let bit = 0; bit < bits; bit++) {
        reversed = (reversed << 1) | ((number >> bit) & 1);
    }
    return reversed;
}

/**
 * A radix-2 transform (J. W. Cooley and J. W. Tukey, 1965) of a fixed size.
 * It transforms the even samples as real and the odd samples as imaginary parts of half the size.
 */
export class RealTransform {
    #size;
    #real;
    #imaginary;
    #cosines; // of 2 pi k / size
    #sines;
    #reversed;

    /** @param {number} size samples, a power of two from 4 on */
    constructor(size) {
        const half = size / 2;
        this.#size = size;
        this.#real = new Float64Array(half);
        this.#imaginary = new Float64Array(half);
        this.#cosines = Float64Array.from({ length: half }, (_, k) =>
            Math.cos(2 * Math.PI * k / size));
        this.#sines = Float64Array.from({ length: half }, (_, k) =>
            Math.sin(2 * Math.PI * k / size));
        const bits = Math.log2(half);
        this.#reversed = Uint32Array.from({ length: half }, (_, i) => reversedBits(i, bits));
    }

    /**
     * The magnitudes of frequencies 0 to half the rate. A sine of amplitude 1 has size / 2.
     * @param {Float32Array} samples
     * @param {Float64Array} magnitudes size / 2 + 1 values
     */
    run(samples, magnitudes) {
        const half = this.#size / 2;
        for (let i = 0; i < half; i++) {
            this.#real[this.#reversed[i]] = samples[2 * i];
            this.#imaginary[this.#reversed[i]] = samples[2 * i + 1];
        }
        for (let length = 2; length <= half; length *= 2) {
            this.#combine(length);
        }
        for (let k = 0; k <= half; k++) {
            magnitudes[k] = this.#magnitude(k);
        }
    }

    /**
     * Makes transforms of this length from pairs of half the length.
     * @param {number} length
     */
    #combine(length) {
        const real = this.#real;
        const imaginary = this.#imaginary;
        const step = this.#size / length;
        for (let start = 0; start < real.length; start += length) {
            for (let k = 0; k < length / 2; k++) {
                const low = start + k;
                const high = low + length / 2;
                const c = this.#cosines[k * step];
                const s = this.#sines[k * step];
                const x = real[high] * c + imaginary[high] * s;
                const y = imaginary[high] * c - real[high] * s;
                real[high] = real[low] - x;
                imaginary[high] = imaginary[low] - y;
                real[low] += x;
                imaginary[low] += y;
            }
        }
    }

    /**
     * Separates the transforms of even and odd samples, and combines them.
     * @param {number} k 0 to size / 2
     * @returns {number}
     */
    #magnitude(k) {
        const half = this.#size / 2;
        const at = k % half;
        const mirrored = (half - at) % half;
        const evenX = 0.5 * (this.#real[at] + this.#real[mirrored]);
        const evenY = 0.5 * (this.#imaginary[at] - this.#imaginary[mirrored]);
        const oddX = 0.5 * (this.#imaginary[at] + this.#imaginary[mirrored]);
        const oddY = 0.5 * (this.#real[mirrored] - this.#real[at]);
        const c = k === half ? -1 : this.#cosines[k];
        const s = k === half ? 0 : this.#sines[k];
        const x = evenX + oddX * c + oddY * s;
        const y = evenY + oddY * c - oddX * s;
        return Math.sqrt(x * x + y * y);
    }
}
