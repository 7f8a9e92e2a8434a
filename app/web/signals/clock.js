// The times of frames and the samples in a time span.

/**
 * Frame n (from 1) of a fixed clock covers (start, end].
 * @param {number} frame
 * @param {number} framesPerSecond
 * @returns {{start: number, end: number}} in s
 */
export function frameSpan(frame, framesPerSecond) {
    return { start: (frame - 1) / framesPerSecond, end: frame / framesPerSecond };
}

/**
 * Number of instants at or before a time.
 * An end such as n / 60 times a rate can be a few rounding units below the whole number.
 * @param {number} seconds
 * @param {number} rate
 * @returns {number}
 */
function instantsUntil(seconds, rate) {
    const exact = seconds * rate;
    if (!(exact > 0)) {
        return 0;
    }
    const bounded = Math.min(exact, 9e15); // doubles above 2^53 skip whole numbers
    return Math.floor(bounded + Math.max(1e-6, bounded * 8 * Number.EPSILON));
}

/**
 * The samples of a stream in (start, end]. Sample k has the instant (k + 1) / rate.
 * Adjoining spans share no sample and skip none.
 * @param {number} start in s
 * @param {number} end in s
 * @param {number} rate samples per second
 * @returns {{first: number, end: number}} sample numbers from 0: first to end - 1
 */
export function samplesIn(start, end, rate) {
    const first = instantsUntil(start, rate);
    return { first, end: Math.max(first, instantsUntil(end, rate)) };
}
