// Sizes, formats and history of the targets of a look.

import { evaluateExpression } from '../look/expression.js';
import { halfFloatsOf, oneChannelOf } from '../gl/formats.js';

/**
 * @typedef {import('../look/types.js').LookDescription} PlannedLook
 * @typedef {import('../look/types.js').PassDescription} PlannedPass
 * @typedef {{width: number, height: number}} Size in pixels
 * @typedef {{width: number, height: number, format: string, slots: number,
 *     isMipmapped: boolean}} PlannedTarget
 *     `slots`: stored pictures, the current one and previous ones that are read.
 * @typedef {{targets: PlannedTarget[], sourceSlots: number, isSourceMipmapped: boolean}} Plan
 * @typedef {{viewport: Size, source: Size, values: Map<string, number[]>, largestSide: number}}
 *     PlanTerms
 */

/**
 * How many frames ago the picture was drawn that a pass reads. A pass that this frame has not drawn
 * yet is read as of the previous frame.
 * @param {PlannedLook} look
 * @param {number} reader index of the reading pass
 * @param {import('../look/types.js').ReadDescription} read
 * @returns {{pass: number, framesAgo: number}} pass -1: none
 */
export function readPass(look, reader, read) {
    const pass = look.passes.findIndex((one) => one.name === read.name);
    const framesAgo = read.frames_ago || 0;
    return { pass, framesAgo: framesAgo === 0 && pass >= reader ? 1 : framesAgo };
}

/**
 * The value of a name in expressions of a pass: `WIDTH`, a parameter or its component.
 * @param {PlannedPass} pass
 * @param {PlanTerms} terms
 * @returns {(name: string) => number|undefined}
 */
function namesOfPass(pass, terms) {
    return (name) => {
        if (name === 'WIDTH' || name === 'HEIGHT')
            return name === 'WIDTH' ? terms.viewport.width : terms.viewport.height;
        const [parameter, component] = name.split('.');
        const numbers = terms.values.get((pass.scope || '') + parameter);
        return numbers && numbers[component ? 'xyzw'.indexOf(component) : 0];
    };
}

/**
 * The names of parameters in the expressions for targets and spots.
 * @param {PlannedLook} look
 * @returns {Set<string>}
 */
export function plannedNames(look) {
    /** @type {Set<string>} */
    const names = new Set();
    for (const { scope = '', target, spot } of look.passes)
        for (const [, name] of JSON.stringify([target, spot]).matchAll(/\$(\w+)/g))
            names.add(scope + name);
    return names;
}

/**
 * @param {string|undefined} expression
 * @param {PlannedPass} pass
 * @param {PlanTerms} terms
 */
function isAboveZero(expression, pass, terms) {
    return !!expression && evaluateExpression(expression, namesOfPass(pass, terms)) > 0;
}

/**
 * @param {PlannedPass} pass
 * @param {'width'|'height'} side
 * @param {{source: Size, previous: Size}} read
 * @param {PlanTerms} terms
 */
function plannedLength(pass, side, read, terms) {
    const wanted = pass.target[side];
    const factor = wanted.factor === undefined ? 1 : wanted.factor;
    let length = wanted.pixels || 0;
    if (wanted.expression !== undefined)
        length = evaluateExpression(wanted.expression, namesOfPass(pass, terms));
    else if (wanted.of)
        length = factor * { viewport: terms.viewport, source: read.source,
            previous: read.previous }[wanted.of][side];
    if (!(length > 0 && length < terms.largestSide + 0.5))
        throw new Error(`The pass '${pass.name}' would be ${length} pixels in ${side}. This browser `
            + `allows 1 to ${terms.largestSide}. Choose a smaller size.`);
    return Math.max(1, Math.round(length));
}

/**
 * The size of the picture that a pass reads as the source: of a previous look in a stack.
 * @param {PlannedLook} look
 * @param {PlannedPass} pass
 * @param {PlannedTarget[]} targets
 * @param {Size} source
 * @returns {Size}
 */
export function sourceSizeOf(look, pass, targets, source) {
    const index = pass.source ? look.passes.findIndex((one) => one.name === pass.source) : -1;
    return targets[index] || source;
}

/**
 * Adds the history and mip levels that inputs need.
 * @param {PlannedLook} look
 * @param {Plan} plan
 */
function addLifetimes(look, plan) {
    look.passes.forEach((pass, reader) => {
        for (const input of pass.inputs) {
            if (input.from === 'source') {
                plan.sourceSlots = Math.max(plan.sourceSlots, (input.frames_ago || 0) + 1);
                plan.isSourceMipmapped = plan.isSourceMipmapped || input.mipmap;
            }
            const read = readPass(look, reader, input);
            const target = input.from === 'pass' ? plan.targets[read.pass] : undefined;
            if (!target)
                continue;
            target.slots = Math.max(target.slots, read.framesAgo + 1);
            target.isMipmapped = target.isMipmapped || (input.mipmap && !/i$/.test(target.format));
        }
    });
    look.passes.forEach((pass, i) => {
        if (pass.accumulate)
            plan.targets[i].slots = Math.max(plan.targets[i].slots, 2);
    });
}

/**
 * Plans the targets for a picture of `terms.viewport` pixels.
 * @param {PlannedLook} look
 * @param {PlanTerms} terms
 * @returns {Plan}
 */
export function planTargets(look, terms) {
    /** @type {Plan} */
    const plan = { targets: [], sourceSlots: 1, isSourceMipmapped: false };
    look.passes.forEach((pass, i) => {
        const source = sourceSizeOf(look, pass, plan.targets, terms.source);
        const isFirst = i === 0 || (look.passes[i - 1].scope || '') !== (pass.scope || '');
        const read = { source, previous: isFirst ? source : plan.targets[i - 1] };
        let format = pass.target.format;
        if (isAboveZero(pass.target.one_channel, pass, terms))
            format = oneChannelOf(format);
        if (isAboveZero(pass.target.half_floats, pass, terms))
            format = halfFloatsOf(format);
        plan.targets.push({
            width: plannedLength(pass, 'width', read, terms),
            height: plannedLength(pass, 'height', read, terms),
            format,
            slots: 1,
            isMipmapped: false,
        });
    });
    addLifetimes(look, plan);
    return plan;
}

/**
 * The smallest spot of the passes that draw segments: standard deviations, where -1 to 1 is 2 long.
 * Null without such a pass.
 * @param {PlannedLook} look
 * @param {Plan} plan
 * @param {PlanTerms} terms
 * @returns {{across: number, up: number}|null}
 */
export function smallestSpot(look, plan, terms) {
    /** @type {{across: number, up: number}|null} */
    let smallest = null;
    look.passes.forEach((pass, i) => {
        if (pass.draw !== 'segments')
            return;
        const target = plan.targets[i];
        const [across, up] = [target.width, target.height].map((texels, axis) => {
            const written = pass.spot && pass.spot[axis];
            if (!written)
                return 1 / texels;
            return Math.max(evaluateExpression(written, namesOfPass(pass, terms)), 0);
        });
        smallest = smallest ? { across: Math.min(smallest.across, across),
            up: Math.min(smallest.up, up) } : { across, up };
    });
    return smallest;
}

/**
 * A number of draws or samples: written, or the value of a parameter.
 * @param {number|string|undefined} count
 * @param {Map<string, number[]>} values
 * @param {number} initial without a count
 */
export function countOf(count, values, initial) {
    if (count === undefined)
        return initial;
    return typeof count === 'number' ? count : (values.get(count) || [0])[0];
}
