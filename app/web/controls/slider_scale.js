// The positions of values on a slider, with the formulas of app/model/tuning/slider_range.cpp.

import { factorLeaving, halfLife, shownFactor } from './parameter_text.js';

/**
 * The range of one component in shown units. `from` is the origin of the steps.
 * @typedef {{low: number, high: number, step: number, from: number, scale: string}} SliderScale
 */

/**
 * @param {import('./parameter_text.js').LookParameter} parameter
 * @param {number} component
 * @returns {SliderScale}
 */
export function sliderScale(parameter, component) {
    const range = (parameter.axes || [])[component] || parameter;
    const factor = shownFactor(parameter);
    const isWhole = /^[iu](nt|vec)/.test(parameter.type);
    const step = isWhole ? Math.max(1, Math.round(parameter.step)) : parameter.step * factor;
    return {
        low: range.min * factor,
        high: range.max * factor,
        step: step || 0,
        from: parameter.min * factor,
        scale: parameter.scale,
    };
}

/**
 * @param {number} value
 * @param {number} low
 * @param {number} high
 * @returns {number}
 */
function withinEnds(value, low, high) {
    return Math.min(Math.max(value, low), high);
}

/**
 * Half-lives at the ends of a slider in seconds, limited to 1 ms .. 100 s.
 * @param {number} factor
 * @returns {number}
 */
function limitedHalfLife(factor) {
    return withinEnds(halfLife(factor), 0.001, 100);
}

/**
 * The position of a value, 0 low .. 1 high.
 * @param {SliderScale} slider
 * @param {number} value
 * @returns {number}
 */
export function ratioOfValue(slider, value) {
    const { low, high, scale } = slider;
    const span = high - low;
    if (!(span > 0)) return 0;
    const inside = withinEnds(value, low, high);
    if (scale === 'half-life') {
        if (inside <= low || inside >= high) return inside > low ? 1 : 0;
        const shortest = limitedHalfLife(low);
        const ends = Math.log(limitedHalfLife(high) / shortest);
        return withinEnds(Math.log(limitedHalfLife(inside) / shortest) / ends, 0, 1);
    }
    if (scale !== 'log') return (inside - low) / span;
    return low > 0 ? Math.log(inside / low) / Math.log(high / low)
        : Math.cbrt((inside - low) / span);
}

/**
 * The value at a position, before rounding.
 * @param {SliderScale} slider
 * @param {number} ratio
 * @returns {number}
 */
export function valueAtRatio(slider, ratio) {
    const { low, high, scale } = slider;
    const t = withinEnds(ratio, 0, 1);
    if (scale === 'half-life') {
        if (t <= 0 || t >= 1) return t > 0 ? high : low;
        const shortest = limitedHalfLife(low);
        const seconds = shortest * Math.pow(limitedHalfLife(high) / shortest, t);
        return withinEnds(factorLeaving(0.5, seconds), low, high);
    }
    if (scale !== 'log') return low + t * (high - low);
    return low > 0 ? low * Math.pow(high / low, t) : low + (high - low) * t * t * t;
}

/**
 * The value at a position, rounded to a step or to a short decimal.
 * @param {SliderScale} slider
 * @param {number} ratio
 * @param {number} [coarseness] 0.1 rounds ten times finer
 * @returns {number}
 */
export function draggedValue(slider, ratio, coarseness = 1) {
    const { low, high, step, from, scale } = slider;
    const value = valueAtRatio(slider, ratio);
    const slack = 1e-6;
    const first = step > 0 ? Math.ceil((low - from) / step - slack) : NaN;
    const last = step > 0 ? Math.floor((high - from) / step + slack) : NaN;
    if (last >= first)
        return from + step * withinEnds(Math.round((value - from) / step), first, last);
    const size = scale === 'log' ? Math.abs(value) : scale === 'half-life' ? 1 - value : high - low;
    if (!(size > 0)) return value;
    // A power of ten below 1 has no exact double, so the division keeps decimals short.
    const power = Math.floor(Math.log10(size / 500));
    const unit = Math.pow(10, power) * coarseness;
    const shortValue = Number((Math.round(value / unit) * unit).toPrecision(12));
    return withinEnds(shortValue, low, high);
}

/**
 * The next value for an arrow key: a step, or a hundredth of the slider. `isFine`: a tenth of that.
 * @param {SliderScale} slider
 * @param {number} value
 * @param {number} sign
 * @param {boolean} isFine
 * @returns {number}
 */
export function nextValue(slider, value, sign, isFine) {
    if (slider.step > 0)
        return draggedValue(slider, ratioOfValue(slider, value + sign * slider.step));
    const ratio = ratioOfValue(slider, value) + sign * (isFine ? 0.001 : 0.01);
    return draggedValue(slider, ratio, isFine ? 0.1 : 1);
}
