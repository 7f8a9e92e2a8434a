// Pseudo-random levels: the finaliser of SplitMix64 (Steele et al. 2014) in 32-bit halves.

/**
 * An unsigned 64-bit number that is hashed in place.
 * Two 32-bit halves need no memory per hash, unlike BigInt.
 */
class HashedBits {
    high = 0;
    low = 0;

    /** @param {number} index a whole number below 2^53 */
    set(index) {
        this.high = Math.floor(index / 4294967296) >>> 0;
        this.low = index >>> 0;
    }

    /** @param {HashedBits} other */
    add(other) {
        const low = this.low + other.low;
        this.high = (this.high + other.high + (low > 0xffffffff ? 1 : 0)) >>> 0;
        this.low = low >>> 0;
    }

    /**
     * bits ^= bits >> places.
     * @param {number} places 1..31
     */
    mix(places) {
        const low = (this.low >>> places) | (this.high << (32 - places));
        this.low = (this.low ^ low) >>> 0;
        this.high = (this.high ^ (this.high >>> places)) >>> 0;
    }

    /**
     * Multiplies modulo 2^64.
     * @param {number} high of the factor
     * @param {number} low
     */
    multiply(high, low) {
        const a1 = this.low >>> 16;
        const a0 = this.low & 0xffff;
        const b1 = low >>> 16;
        const b0 = low & 0xffff;
        const middle = a1 * b0 + (a0 * b0 >>> 16); // below 2^32
        const carried = (middle & 0xffff) + a0 * b1; // below 2^32
        const highOfLow = a1 * b1 + (middle >>> 16) + Math.floor(carried / 65536);
        const cross = Math.imul(this.high, low) + Math.imul(this.low, high);
        this.low = Math.imul(this.low, low) >>> 0;
        this.high = (highOfLow + cross) >>> 0;
    }
}

/** Random numbers by index, for a seed. */
export class RandomLevels {
    #bits = new HashedBits();
    #offset = new HashedBits();

    /** @param {number} seed a whole number from 0 */
    constructor(seed) {
        this.#offset.set(seed);
        this.#offset.multiply(0x9e3779b9, 0x7f4a7c15);
    }

    /**
     * @param {number} index a whole number
     * @returns {number} -1..1
     */
    at(index) {
        const bits = this.#bits;
        bits.set(index);
        bits.add(this.#offset);
        bits.mix(30);
        bits.multiply(0xbf58476d, 0x1ce4e5b9);
        bits.mix(27);
        bits.multiply(0x94d049bb, 0x133111eb);
        bits.mix(31);
        return (bits.high * 2097152 + (bits.low >>> 11)) * 2 ** -52 - 1;
    }
}
