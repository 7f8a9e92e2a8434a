// Pseudo-random numbers that depend only on their keys, for the test patterns.

/**
 * The finaliser of MurmurHash3 (A. Appleby).
 * @param {number} key
 * @returns {number} From 0 to 2^32 - 1.
 */
export function mixedPatternKey(key) {
    key ^= key >>> 16;
    key = Math.imul(key, 0x85ebca6b);
    key ^= key >>> 13;
    key = Math.imul(key, 0xc2b2ae35);
    return (key ^ (key >>> 16)) >>> 0;
}

/**
 * Applies mixedPatternKey() to each key in turn.
 * @param {number} a
 * @param {number} [b]
 * @param {number} [c]
 * @returns {number} From 0 to 2^32 - 1.
 */
export function patternHash(a, b = 0, c = 0) {
    return mixedPatternKey(c + mixedPatternKey(b + mixedPatternKey(a + 0x9e3779b9)));
}

/**
 * patternHash() scaled to 0 <= n < 1.
 * @param {number} a
 * @param {number} [b]
 * @param {number} [c]
 * @returns {number}
 */
export function patternHashShare(a, b = 0, c = 0) {
    return patternHash(a, b, c) / 4294967296;
}
