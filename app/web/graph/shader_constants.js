// Constants in shaders that the page can change: macros that are defined before each text.

/**
 * @typedef {import('../look/types.js').LookDescription} ConstantLook
 * @typedef {import('../look/types.js').ParameterDescription} ConstantParameter
 */

/**
 * @param {ConstantParameter} parameter
 */
function macroOf(parameter) {
    return `SPIRV_CROSS_CONSTANT_ID_${parameter.constant_id}`;
}

/**
 * A number as GLSL.
 * @param {string} type `int`, `uint`, `float` or `bool`
 * @param {number} number
 */
function literalOf(type, number) {
    if (type === 'bool')
        return number !== 0 ? 'true' : 'false';
    const whole = String(Math.round(number));
    if (type === 'uint')
        return `${whole}u`;
    const text = type === 'int' ? whole : String(number);
    return `(${type === 'float' && /^-?\d+$/.test(text) ? `${text}.0` : text})`;
}

/**
 * The names of the parameters that are constants in shaders.
 * @param {ConstantLook} look
 * @returns {string[]}
 */
export function shaderConstants(look) {
    return look.parameters.filter((one) => one.constant_id !== undefined).map((one) => one.name);
}

/**
 * A shader with these values of its constants.
 * @param {ConstantLook} look
 * @param {number} index in `shaders`
 * @param {Map<string, number[]>|null} values null: those in its text
 * @returns {string}
 */
export function shaderText(look, index, values) {
    const text = look.shaders[index];
    if (!values)
        return text;
    const defined = look.parameters.filter((one) => one.constant_id !== undefined
        && new RegExp(`\\b${macroOf(one)}\\b`).test(text)).map((one) => {
        const [number] = values.get(one.name) || [0];
        return `#define ${macroOf(one)} ${literalOf(one.constant_type || '', number)}\n`;
    });
    const start = text.indexOf('\n') + 1;  // after the version
    return text.slice(0, start) + defined.join('') + text.slice(start);
}
