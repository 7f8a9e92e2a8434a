// The conditions of parameters (`when`), with the rules of app/model/plan/condition.cpp.

import { shownValue } from './parameter_text.js';

/** @typedef {import('./parameter_text.js').LookParameter} ConditionParameter */
/** @typedef {Map<string, number[]>} ParameterNumbers */
/**
 * A name, number, label or symbol. Its text is without quotes.
 * @typedef {object} ConditionToken
 * @property {string} text
 * @property {boolean} [isLabel]
 * @property {ConditionParameter} [parameter] of a name
 */
/** @typedef {{isTrue: (values: ParameterNumbers) => boolean, text: string}} ParameterCondition */

/**
 * The binary operators: precedence, text for the user, and function.
 * @type {Record<string, [number, string, (a: number, b: number) => unknown]>}
 */
const conditionOperators = {
    '||': [1, 'or', (a, b) => a || b],
    '&&': [2, 'and', (a, b) => a && b],
    '==': [3, 'is', (a, b) => a === b],
    '!=': [3, 'is not', (a, b) => a !== b],
    '<=': [3, 'is at most', (a, b) => a <= b],
    '>=': [3, 'is at least', (a, b) => a >= b],
    '<': [3, 'is below', (a, b) => a < b],
    '>': [3, 'is above', (a, b) => a > b],
    '-': [4, '-', (a, b) => a - b],
};

/**
 * @param {string} when
 * @param {(name: string) => ConditionParameter | undefined} find
 * @returns {ConditionToken[]}
 */
function conditionTokens(when, find) {
    const pattern = /\s*(?:"((?:[^"\\]|\\.)*)"|([\w.]+|[=!<>]=|&&|\|\||[<>!()-]))\s*/y;
    const tokens = [];
    while (pattern.lastIndex < when.length) {
        const [, label, text] = /** @type {RegExpExecArray} */ (pattern.exec(when));
        tokens.push(text ? { text, parameter: find(text) }
            : { text: label.replace(/\\(.)/g, '$1'), isLabel: true });
    }
    return tokens;
}

/**
 * @param {ConditionToken | undefined} token
 * @returns {boolean}
 */
function isComparison(token) {
    return !!token && !token.isLabel && (conditionOperators[token.text] || [])[0] === 3;
}

/**
 * The parameter that token `i` is compared with.
 * @param {ConditionToken[]} tokens
 * @param {number} i
 * @returns {ConditionParameter | undefined}
 */
function comparedWith(tokens, i) {
    const before = isComparison(tokens[i - 1]) && tokens[i - 2].parameter;
    return before || (isComparison(tokens[i + 1]) && tokens[i + 2] || {}).parameter;
}

/**
 * The value of a condition, by precedence climbing. Throws an Error for an invalid one.
 * @param {ConditionToken[]} tokens
 * @param {ParameterNumbers} values
 * @returns {number}
 */
function conditionValue(tokens, values) {
    let at = 0;
    const accept = (/** @type {string} */ text) => {
        const isNext = at < tokens.length && !tokens[at].isLabel && tokens[at].text === text;
        at += Number(isNext);
        return isNext;
    };
    /** @returns {number} */
    const factor = () => {
        if (accept('-')) return -factor();
        if (accept('!')) return Number(!factor());
        if (accept('(')) {
            const inner = binary(1);
            if (!accept(')')) throw new Error('missing bracket');
            return inner;
        }
        const { text, parameter, isLabel } = tokens[at];
        const list = isLabel && comparedWith(tokens, at);
        ++at;
        if (parameter) return (values.get(parameter.name) || [0])[0];
        const item = list && list.items.find((other) => other.label === text);
        const number = item ? item.value : isLabel ? NaN : Number(text);
        if (Number.isNaN(number)) throw new Error('unknown name or item');
        return number;
    };
    const binary = (/** @type {number} */ lowest) => {
        let value = factor();
        for (;;) {
            const token = tokens[at];
            const operator = token && !token.isLabel && conditionOperators[token.text];
            if (!operator || operator[0] < lowest) return value;
            ++at;
            value = Number(operator[2](value, binary(operator[0] + 1)));
        }
    };
    const value = binary(1);
    if (at < tokens.length) throw new Error('unexpected text');
    return value;
}

/**
 * The text of token `i`. Empty for a `!` that becomes part of its name's text.
 * @param {ConditionToken[]} tokens
 * @param {number} i
 * @returns {string}
 */
function conditionTokenText(tokens, i) {
    const { text, parameter, isLabel } = tokens[i];
    const isCompared = (/** @type {number} */ at) =>
        isComparison(tokens[at - 1]) || isComparison(tokens[at + 1]);
    const isNegation = (/** @type {number} */ at) => (tokens[at] || {}).text === '!' &&
        (tokens[at + 1] || {}).parameter && !isCompared(at + 1);
    if (parameter && isCompared(i)) return parameter.label;
    if (parameter) {
        const [yes, no] = parameter.type === 'bool' ? ['on', 'off'] : ['not 0', '0'];
        return `${parameter.label} is ${isNegation(i - 1) ? no : yes}`;
    }
    const other = comparedWith(tokens, i);
    if (isLabel) return text;
    if (other && /\d/.test(text)) return shownValue({ ...other, unit: '' }, [Number(text)]);
    if (text === '!') return isNegation(i) ? '' : 'not';
    return (conditionOperators[text] || [0, text])[1];
}

/**
 * The condition of a parameter. An invalid condition is always true.
 * @param {ConditionParameter} parameter
 * @param {ConditionParameter[]} parameters of the same description
 * @returns {ParameterCondition}
 */
export function makeCondition(parameter, parameters) {
    const scope = parameter.name.slice(0, parameter.name.lastIndexOf('/') + 1);
    try {
        const tokens = conditionTokens(parameter.when || '1',
            (name) => parameters.find((other) => other.name === scope + name));
        conditionValue(tokens, new Map());
        const text = tokens.map((_, i) => conditionTokenText(tokens, i)).filter(Boolean).join(' ')
            .replace(/([(-]) /g, '$1').replace(/ \)/g, ')');
        return { isTrue: (values) => conditionValue(tokens, values) !== 0, text };
    } catch {
        return { isTrue: () => true, text: '' };
    }
}
