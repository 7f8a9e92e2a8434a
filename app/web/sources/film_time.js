// Which picture of a sequence or video a time shows.

/** Pictures per second of a film without a rate of its own. */
export const usualFilmRate = 60;

/**
 * The picture at the end time of a frame. Pictures, like frames, cover the time up to their end. At
 * equal rates frame N therefore shows picture N.
 * @param {number} seconds
 * @param {number} rate Pictures per second.
 * @returns {number} From 0.
 */
export function filmNumberAt(seconds, rate) {
    const rounding = 1e-6;  // of seconds * rate, which should be whole
    return Math.max(Math.ceil(seconds * rate - rounding) - 1, 0);
}

/**
 * After the end a film restarts or holds the last picture.
 * @param {number} number
 * @param {number} count Of all pictures.
 * @param {boolean} loops
 * @returns {number}
 */
export function filmNumberWithin(number, count, loops) {
    return loops ? number % count : Math.min(number, count - 1);
}
