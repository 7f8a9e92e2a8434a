// A signal of one wave, drawn over time or against itself a quarter period earlier.
import { chargeOfPoint, sweepPoint, tracePoints } from '../points.js';
import { numberSetting } from '../signal.js';

/**
 * @param {import('../signal.js').SignalSettings} settings
 * @param {(sweeps: number) => number} wave level at a time in sweeps of 1/60 s
 * @param {number} quarterPeriod in sweeps
 * @returns {import('../signal.js').Signal}
 */
export function makeOneChannel(settings, wave, quarterPeriod) {
    const amplitude = numberSetting(settings, 'amplitude');
    const scroll = numberSetting(settings, 'speed') / 60; // sweeps per sweep
    const length = Math.trunc(numberSetting(settings, 'points'));
    const rate = length * 60;
    const charge = chargeOfPoint(rate);

    /** @type {import('../points.js').PointWriter} */
    const writeAgainstItself = (k, points, at) => {
        const u = (k + 1) / length;
        points[at] = amplitude * wave(u);
        points[at + 1] = amplitude * wave(u - quarterPeriod);
        points[at + 2] = charge;
    };
    /** @type {import('../points.js').PointWriter} */
    const writeSwept = (k, points, at) => {
        const sweep = Math.floor(k / length);
        const across = sweepPoint(k % length, length, charge, points, at);
        points[at + 1] = amplitude * wave(across + scroll * sweep);
    };
    const writePoint = settings.mode === 'xy' ? writeAgainstItself : writeSwept;
    return {
        seconds: Infinity,
        trace: (start, end, beam) => tracePoints(start, end, rate, beam, writePoint),
    };
}
