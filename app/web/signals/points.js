// Points of the beam at a constant rate.
import { FLOATS_PER_POINT } from './beam.js';
import { samplesIn } from './clock.js';

/**
 * Writes x, y and intensity of point k to `points[at]`, `points[at + 1]` and `points[at + 2]`.
 * @typedef {(k: number, points: Float32Array, at: number) => void} PointWriter
 */

/**
 * The charge of one point at full current.
 * @param {number} rate points per second
 * @returns {number} 1 is full current for 1/4096 of 1/60 s
 */
export function chargeOfPoint(rate) {
    return 4096 * 60 / rate;
}

/**
 * Appends a point for each instant in (start, end], up to point `count`.
 * @param {number} start in s
 * @param {number} end in s
 * @param {number} rate points per second
 * @param {import('./beam.js').Beam} beam
 * @param {PointWriter} writePoint is called with increasing k
 * @param {number} [count] of points in total
 */
export function tracePoints(start, end, rate, beam, writePoint, count = Infinity) {
    const samples = samplesIn(start, end, rate);
    const last = Math.min(samples.end, count);
    if (last <= samples.first) {
        return;
    }
    let at = FLOATS_PER_POINT * beam.extend(last - samples.first);
    const points = beam.points;
    const secondsPerPoint = 1 / rate;
    for (let k = samples.first; k < last; k++) {
        writePoint(k, points, at);
        points[at + 3] = Math.max(end - (k + 1) * secondsPerPoint, 0);
        at += FLOATS_PER_POINT;
    }
}

/**
 * Writes x and intensity of a point of a trace that is drawn repeatedly from left to right.
 * The intensity is 0 on the first point, because the retrace is blanked.
 * @param {number} index of the point in its sweep, from 0
 * @param {number} length points in a sweep
 * @param {number} charge of a point. A sweep has length * charge in total
 * @param {Float32Array} points
 * @param {number} at
 * @returns {number} position across, 0 left to 1 right
 */
export function sweepPoint(index, length, charge, points, at) {
    const across = (index + 1) / length;
    points[at] = 2 * across - 1;
    points[at + 2] = index === 0 ? 0 : charge * length / (length - 1);
    return across;
}
