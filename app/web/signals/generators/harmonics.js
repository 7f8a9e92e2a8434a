// A sum of sines at integer multiples of a base frequency.
import { numberSetting } from '../signal.js';
import { fractionOf, linearBetween, sineOfTurns } from '../sine.js';
import { makeOneChannel } from './one_channel.js';

const HARMONICS_ENTRIES = 32768;

/**
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {import('../signal.js').Signal}
 */
export function makeHarmonics(settings) {
    const base = numberSetting(settings, 'base'); // periods per 1/60 s
    const table = harmonicsTable(settings);
    return makeOneChannel(settings, (u) => {
        const position = fractionOf(base * u) * HARMONICS_ENTRIES;
        const below = Math.floor(position);
        return linearBetween(table[below], table[below + 1], position - below);
    }, 0.25 / base);
}

/**
 * One period of the sum and its first entry again, with a peak of 1.
 * With 64 harmonics the error of interpolation is at most (2 pi 64 / 32768)^2 / 8 = 2e-5.
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {Float64Array}
 */
function harmonicsTable(settings) {
    const table = new Float64Array(HARMONICS_ENTRIES + 1);
    const count = numberSetting(settings, 'count');
    for (let n = 1; n <= count; n++) {
        const size = harmonicStrength(settings.shape, n, numberSetting(settings, 'falloff'));
        if (size !== 0) {
            for (let i = 0; i < table.length; i++) {
                table[i] += size * sineOfTurns(i * n / HARMONICS_ENTRIES);
            }
        }
    }
    const peak = table.reduce((highest, value) => Math.max(highest, Math.abs(value)), 0);
    return table.map((value) => value / peak);
}

/**
 * Amplitude of the n-th harmonic.
 * A saw has all, a square odd ones only, a triangle odd ones with alternating signs.
 * @param {number | string} shape
 * @param {number} n from 1
 * @param {number} falloff
 * @returns {number}
 */
function harmonicStrength(shape, n, falloff) {
    const size = n ** -falloff;
    if (shape === 'saw') {
        return size;
    }
    if (n % 2 === 0) {
        return 0;
    }
    return shape === 'triangle' && n % 4 === 3 ? -size : size;
}
