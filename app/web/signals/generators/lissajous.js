// Lissajous figures: two sines, one horizontal and one vertical.
import { chargeOfPoint, tracePoints } from '../points.js';
import { numberSetting } from '../signal.js';
import { cosineOfTurns, sineOfTurns } from '../sine.js';

/**
 * x = A sin(2 pi (x u + phase + speed t)), y = A sin(2 pi y u), u = 60 t.
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {import('../signal.js').Signal}
 */
export function makeLissajous(settings) {
    const drift = numberSetting(settings, 'speed') / 60; // turns per 1/60 s
    const x = numberSetting(settings, 'x') + drift;
    const y = numberSetting(settings, 'y');
    const phase = numberSetting(settings, 'phase');
    const amplitude = numberSetting(settings, 'amplitude');
    const pointsPerFrame = numberSetting(settings, 'points');
    const isWeighted = settings.weighting === 'speed';
    const fastest = Math.hypot(x, y);
    const rate = pointsPerFrame * 60;
    const charge = chargeOfPoint(rate);

    // Relative to both deflections at their maximum speed.
    const speedAt = (/** @type {number} */ across, /** @type {number} */ up) => {
        const vx = x * cosineOfTurns(across);
        const vy = y * cosineOfTurns(up);
        return fastest === 0 ? 0 : Math.sqrt(vx * vx + vy * vy) / fastest;
    };
    /** @type {import('../points.js').PointWriter} */
    const writePoint = (k, points, at) => {
        const u = (k + 1) / pointsPerFrame;
        const across = x * u + phase;
        const up = y * u;
        points[at] = amplitude * sineOfTurns(across);
        points[at + 1] = amplitude * sineOfTurns(up);
        points[at + 2] = isWeighted ? charge * currentAtSpeed(speedAt(across, up)) : charge;
    };
    return {
        seconds: Infinity,
        trace: (start, end, beam) => tracePoints(start, end, rate, beam, writePoint),
    };
}

/**
 * Current 0.3 + 0.7 q, q = 0.05 / (s + 0.05). q is 1 for a stationary beam, 1/21 at full speed.
 * @param {number} speed s, 0..1
 * @returns {number}
 */
function currentAtSpeed(speed) {
    return 0.3 + (1 - 0.3) * 0.05 / (speed + 0.05);
}
