// The values of parameters as numbers.

/** @typedef {import('./types.js').ParameterDescription} ValueParameter */

/**
 * The numbers as the program accepts them: finite, whole where the type is whole.
 * @param {number[]} initial default numbers
 * @param {string} type of the parameter
 * @param {number[]} numbers
 * @returns {number[]}
 */
export function usableNumbers(initial, type, numbers) {
    const isWhole = /^(int|uint|ivec|uvec)/.test(type);
    const isSwitch = /^b(ool|vec)/.test(type);
    return initial.map((fallback, i) => {
        const number = Number.isFinite(numbers[i]) ? numbers[i] : fallback;
        if (isSwitch)
            return number !== 0 ? 1 : 0;
        return isWhole ? Math.round(number) : number;
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
