// Sine, fraction and interpolation that give the same numbers on every machine.

const NO_FRACTION_BITS = 6755399441055744; // 1.5 * 2^52 leaves no bits for a fraction

/**
 * The nearest whole number, for |x| below 2^51.
 * @param {number} x
 * @returns {number}
 */
export function nearestWhole(x) {
    return (x + NO_FRACTION_BITS) - NO_FRACTION_BITS;
}

/**
 * x - floor(x): 0 <= result < 1.
 * @param {number} x
 * @returns {number}
 */
export function fractionOf(x) {
    const rest = x - Math.trunc(x);
    return rest < 0 ? rest + 1 : rest;
}

/**
 * sin(2 pi turns): Taylor series over a quarter turn, error below 1e-11.
 * @param {number} turns
 * @returns {number}
 */
export function sineOfTurns(turns) {
    let rest = turns - nearestWhole(turns);
    if (rest > 0.25) {
        rest = 0.5 - rest;
    } else if (rest < -0.25) {
        rest = -0.5 - rest;
    }
    const a = 6.283185307179586 * rest;
    const b = a * a;
    let sum = -1 / 1307674368000; // 15!
    sum = sum * b + 1 / 6227020800; // 13!
    sum = sum * b - 1 / 39916800;
    sum = sum * b + 1 / 362880;
    sum = sum * b - 1 / 5040;
    sum = sum * b + 1 / 120;
    sum = sum * b - 1 / 6;
    return a + a * b * sum;
}

/**
 * cos(2 pi turns).
 * @param {number} turns
 * @returns {number}
 */
export function cosineOfTurns(turns) {
    return sineOfTurns(turns + 0.25);
}

/**
 * From a at share 0 to b at share 1, with the roundings of std::lerp for shares up to 1.
 * @param {number} a
 * @param {number} b
 * @param {number} share 0..1
 * @returns {number}
 */
export function linearBetween(a, b, share) {
    if ((a <= 0 && b >= 0) || (a >= 0 && b <= 0)) {
        return share * b + (1 - share) * a;
    }
    if (share === 1) {
        return b;
    }
    const x = a + share * (b - a);
    return b > a ? Math.min(x, b) : Math.max(x, b);
}
