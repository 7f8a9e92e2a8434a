// The values of parameters as numbers.

/** @typedef {import('./types.js').ParameterDescription} ValueParameter */

/**
 * The nearest number of 32 bits. Halves are rounded away from zero.
 * @param {number} number
 * @param {boolean} isUnsigned
 */
function wholeNumber(number, isUnsigned) {
    const rounded = Math.sign(number) * Math.floor(Math.abs(number) + 0.5);
    return isUnsigned ? Math.min(Math.max(rounded, 0), 4294967295)
        : Math.min(Math.max(rounded, -2147483648), 2147483647);
}

/**
 * The numbers as the program accepts them: finite, within the limits, whole where the type is
 * whole.
 * @param {number[]} initial default numbers
 * @param {{type: string, limit?: {min: number, max: number}}} parameter
 * @param {number[]} numbers
 * @returns {number[]}
 */
export function usableNumbers(initial, { type, limit }, numbers) {
    const isWhole = /^(int|uint|ivec|uvec)/.test(type);
    const isSwitch = /^b(ool|vec)/.test(type);
    return initial.map((fallback, i) => {
        const number = Number.isFinite(numbers[i]) ? numbers[i] : fallback;
        if (isSwitch)
            return number !== 0 ? 1 : 0;
        const limited = limit ? Math.min(Math.max(number, limit.min), limit.max) : number;
        return isWhole ? wholeNumber(limited, type[0] === 'u') : limited;
    });
}

/**
 * Linear light to display values, IEC 61966-2-1.
 * @param {number} light
 */
export function srgbEncode(light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
}

/**
 * The numbers as shaders get them: colours are linear unless the look wants display values.
 * @param {ValueParameter} parameter
 * @param {number[]} numbers
 * @returns {number[]}
 */
export function numbersForShaders(parameter, numbers) {
    if (parameter.encoding !== 'display')
        return numbers;
    return numbers.map((number, i) => (i < 3 ? srgbEncode(number) : number));
}
