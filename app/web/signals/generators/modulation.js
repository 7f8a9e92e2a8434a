// Amplitude and frequency modulation of a fast sine by a slow one.
import { numberSetting } from '../signal.js';
import { sineOfTurns } from '../sine.js';
import { makeOneChannel } from './one_channel.js';

/**
 * (1 + d sin(2 pi m u)) / (1 + d) * sin(2 pi c u), with depth d, modulator m and carrier c.
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {import('../signal.js').Signal}
 */
export function makeAmplitudeModulation(settings) {
    const carrier = numberSetting(settings, 'carrier'); // periods per 1/60 s
    const modulator = numberSetting(settings, 'modulator');
    const depth = numberSetting(settings, 'depth');
    return makeOneChannel(settings, (u) =>
        (1 + depth * sineOfTurns(modulator * u)) / (1 + depth) * sineOfTurns(carrier * u),
    0.25 / carrier);
}

/**
 * sin(2 pi c u + i sin(2 pi m u)), with index i in rad.
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {import('../signal.js').Signal}
 */
export function makeFrequencyModulation(settings) {
    const carrier = numberSetting(settings, 'carrier'); // periods per 1/60 s
    const modulator = numberSetting(settings, 'modulator');
    const turns = numberSetting(settings, 'index') / (2 * Math.PI);
    return makeOneChannel(settings, (u) =>
        sineOfTurns(carrier * u + turns * sineOfTurns(modulator * u)),
    0.25 / carrier);
}
