// The numbers and texts of parameters, as the program reads and writes them.

/**
 * @typedef {{value: any, label: string, note?: string, color?: number[]}} ParameterItem
 * `value` is a number. `color` is linear light.
 * @typedef {{min: number, max: number}} ValueRange
 */
/**
 * A parameter as portable.json describes it. `default` is the look's, `value` the exported one.
 * @typedef {object} LookParameter
 * @property {string} name
 * @property {string} type
 * @property {unknown} default
 * @property {unknown} [value]
 * @property {number} min
 * @property {number} max
 * @property {number} step
 * @property {string} scale 'linear', 'log' or 'half-life'
 * @property {string} label
 * @property {string} unit
 * @property {string} group
 * @property {string} help
 * @property {ParameterItem[]} items
 * @property {string[]} [passes]
 * @property {string} [when]
 * @property {ValueRange[]} [axes] one range per axis of a point
 * @property {ValueRange} [limit] hard limits
 * @property {string[]} [parts] labels of components
 * @property {boolean} [angle] radians, shown in degrees
 * @property {boolean} [hidden] no control
 * @property {boolean} [constant] part of the shader's text, cannot be changed
 * @property {string} [was] previous name
 * @property {string} [orbit] part of an orbit: turn, azimuth, elevation or distance
 * @property {import('../look/modulation.js').ModulationDescription} [modulation]
 */

/**
 * Whether its value is the path of a file.
 * @param {LookParameter} parameter
 * @returns {boolean}
 */
export function isFileParameter(parameter) {
    return parameter.type === 'image' || parameter.type === 'sound';
}

/**
 * Whether it has numbers that the page can change.
 * @param {LookParameter} parameter
 * @returns {boolean}
 */
export function isAdjustable(parameter) {
    return !parameter.constant && !isFileParameter(parameter);
}

/**
 * Whether each component is on or off.
 * @param {LookParameter} parameter
 * @returns {boolean}
 */
export function isSwitch(parameter) {
    return /^b(ool|vec)/.test(parameter.type);
}

/**
 * Whether it is a factor per 1/60 s of light that decays (app/model/look/decay.h).
 * @param {LookParameter} parameter
 * @returns {boolean}
 */
export function isDecayFactor(parameter) {
    return parameter.type === 'float' && parameter.min >= 0 && parameter.max <= 1 &&
        (parameter.unit === 'per 1/60 s' || parameter.scale === 'half-life');
}

/**
 * Seconds until half of the light is left.
 * @param {number} factor per 1/60 s
 * @returns {number}
 */
export function halfLife(factor) {
    if (factor <= 0) return 0;
    return factor >= 1 ? Infinity : Math.log(0.5) / (60 * Math.log(factor));
}

/**
 * The factor per 1/60 s that leaves `share` after `seconds`.
 * @param {number} share 0..1, exclusive
 * @param {number} seconds above 0
 * @returns {number}
 */
export function factorLeaving(share, seconds) {
    return Math.pow(share, 1 / (60 * seconds));
}

/**
 * The factor for a half-life '120 ms' or a share and its time '10% 0.4 s'. NaN for other text.
 * @param {string} text
 * @returns {number}
 */
export function parseDecay(text) {
    const found = /^(?:([\d.,]+)\s*%)?\s*([\d.,]+)\s*(ms|s)$/.exec(text.trim());
    if (!found) return NaN;
    const share = found[1] ? plainNumber(found[1].replace(',', '.')) / 100 : 0.5;
    const seconds = plainNumber(found[2].replace(',', '.')) * (found[3] === 'ms' ? 0.001 : 1);
    return share > 0 && share < 1 && seconds > 0 ? factorLeaving(share, seconds) : NaN;
}

/**
 * '139 ms', '1.4 s' or 'forever'.
 * @param {number} seconds
 * @returns {string}
 */
export function durationText(seconds) {
    if (!Number.isFinite(seconds)) return 'forever';
    const isShort = seconds < 0.9995;
    const number = isShort ? seconds * 1000 : seconds;
    const digits = number.toFixed(number < 9.995 ? 2 : number < 99.95 ? 1 : 0);
    return `${Number(digits)} ${isShort ? 'ms' : 's'}`;
}

/**
 * At most about five digits, without trailing zeros.
 * @param {number} value
 * @returns {string}
 */
export function shortNumber(value) {
    const size = Math.abs(value);
    if (size !== 0 && (size >= 1e7 || size < 1e-4))
        return value.toExponential(2).replace(/\.?0*e/, 'e');
    const decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4;
    return String(Number(value.toFixed(decimals)) + 0);
}

/**
 * The number with the fewest digits that gives the same 32-bit float.
 * @param {number} value
 * @returns {number}
 */
export function withFloatDigits(value) {
    if (Number.isInteger(value) || !Number.isFinite(Math.fround(value))) return value;
    for (let digits = 1; digits < 10; ++digits) {
        const short = Number(value.toPrecision(digits));
        if (Math.fround(short) === Math.fround(value)) return short;
    }
    return value;
}

/**
 * NaN unless the whole text is one finite decimal number.
 * @param {string} text
 * @returns {number}
 */
function plainNumber(text) {
    const number = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
    return Number.isFinite(number) ? number : NaN;
}

/**
 * Display-encodes a linear component (IEC 61966-2-1).
 * @param {number} linear
 * @returns {number}
 */
export function encodeSrgb(linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
}

/**
 * The linear component of a display-encoded one.
 * @param {number} encoded
 * @returns {number}
 */
function decodeSrgb(encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
}

/**
 * '#rrggbb' of linear light. Components beyond 0..1 are limited.
 * @param {number[]} light
 * @returns {string}
 */
export function hexOfLight(light) {
    return '#' + light.slice(0, 3).map((part) => {
        const level = Math.round(encodeSrgb(Math.min(Math.max(part, 0), 1)) * 255);
        return level.toString(16).padStart(2, '0');
    }).join('');
}

/**
 * One number of a typed value: the label of an item, true or false, a decay, or a number.
 * @param {LookParameter} parameter
 * @param {string} text
 * @returns {number} NaN for an invalid text
 */
function componentFromText(parameter, text) {
    const lower = text.toLowerCase();
    const labelled = parameter.items.find((item) => item.label.toLowerCase() === lower);
    if (labelled) return labelled.value;
    if (isSwitch(parameter)) {
        if (/^(true|on|yes)$/.test(text)) return 1;
        if (/^(false|off|no)$/.test(text)) return 0;
    }
    const decay = isDecayFactor(parameter) ? parseDecay(text) : NaN;
    const number = Number.isNaN(decay) ? plainNumber(text) : decay;
    const isItem = !parameter.items.length || parameter.items.some((item) => item.value === number);
    return isItem ? number : NaN;
}

/**
 * The numbers of a typed value or of one in a link. Null for an invalid text.
 * @param {LookParameter} parameter
 * @param {string} text
 * @returns {number[] | null}
 */
export function parseValueText(parameter, text) {
    if (isFileParameter(parameter)) return null;
    const count = defaultNumbers(parameter).length;
    const hex = parameter.type === 'color' && /^#([0-9a-f]{6})$/i.exec(text.trim());
    if (hex) {
        const code = parseInt(hex[1], 16);
        const light = [16, 8, 0].map((shift) => decodeSrgb(((code >> shift) & 255) / 255));
        return count > 3 ? [...light, 1] : light;
    }
    const numbers = text.split(',').map((part) => componentFromText(parameter, part.trim()));
    return numbers.length === count && !numbers.some(Number.isNaN) ? numbers : null;
}

/**
 * The numbers of a value in JSON: a number, a switch, a list of them, or a typed text.
 * @param {LookParameter} parameter
 * @param {unknown} value
 * @returns {number[] | null}
 */
export function readValue(parameter, value) {
    if (typeof value === 'string')
        return parseValueText(parameter, value);
    const list = Array.isArray(value) ? value : [value];
    const isValid = list.every((part) => typeof part === 'number' || typeof part === 'boolean');
    const hasCount = value === parameter.default || !Array.isArray(parameter.default) ||
        list.length === parameter.default.length;
    if (isFileParameter(parameter) || !isValid || !hasCount) return null;
    return Array.isArray(parameter.default) || list.length === 1 ? list.map(Number) : null;
}

/**
 * The default of the look. Empty for files.
 * @param {LookParameter} parameter
 * @returns {number[]}
 */
export function defaultNumbers(parameter) {
    const value = parameter.default;
    if (typeof value !== 'string') return readValue(parameter, value) || [];
    const item = parameter.items.find((other) => other.label === value);
    return item ? [item.value] : [];
}

/**
 * The value that the page was exported with. Empty for files.
 * @param {LookParameter} parameter
 * @returns {number[]}
 */
export function exportedNumbers(parameter) {
    return readValue(parameter, parameter.value) || defaultNumbers(parameter);
}

/**
 * The value in JSON: the label of an item, a switch, a number or a list of them.
 * @param {LookParameter} parameter
 * @param {number[]} numbers
 * @returns {string | number | boolean | (number | boolean)[]}
 */
export function valueInJson(parameter, numbers) {
    const item = parameter.items.find((other) => other.value === numbers[0]);
    if (item && numbers.length === 1) {
        const read = parseValueText(parameter, item.label);
        if (read && read[0] === item.value) return item.label;
    }
    const list = numbers.map((number) =>
        isSwitch(parameter) ? number !== 0 : withFloatDigits(number));
    return list.length === 1 ? list[0] : list;
}

/**
 * The value for a person: with the label of its item, and its unit.
 * @param {LookParameter} parameter
 * @param {number[]} numbers
 * @returns {string}
 */
export function shownValue(parameter, numbers) {
    const item = parameter.items.find((other) => other.value === numbers[0]);
    if (item) return item.label;
    if (parameter.type === 'color') return hexOfLight(numbers);
    if (isSwitch(parameter))
        return numbers.map((number) => number ? 'on' : 'off').join(', ');
    const factor = shownFactor(parameter);
    const text = numbers.map((number) => shortNumber(number * factor)).join(', ');
    return `${text} ${shownUnit(parameter)}`.trim();
}

/**
 * Shown numbers are the value's numbers times this: angles are shown in degrees.
 * @param {LookParameter} parameter
 * @returns {number}
 */
export function shownFactor(parameter) {
    return parameter.angle ? 180 / Math.PI : 1;
}

/**
 * @param {LookParameter} parameter
 * @returns {string}
 */
export function shownUnit(parameter) {
    if (parameter.angle) return '°';
    return /^px (per|a) period$/.test(parameter.unit) ? 'px' : parameter.unit;
}
