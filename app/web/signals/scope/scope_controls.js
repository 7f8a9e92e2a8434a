// The settings of a two-channel oscilloscope with 10 x 8 divisions.
import { numberSetting } from '../signal.js';

/** Divisions of the screen. */
export const DIVISIONS_ACROSS = 10;
export const DIVISIONS_UP = 8;

/**
 * Full scale of a sound, and an amplitude of 1, are 1 V. The offset is in divisions upwards.
 * In xy, that of channel 1 is to the right.
 * @typedef {{
 *   voltsPerDivision: number,
 *   offset: number,
 *   coupling: 'dc' | 'ac' | 'gnd',
 *   isInverted: boolean
 * }} ScopeChannel
 */

/**
 * When a sweep starts. The source is channel 1 or 2; 0 is the first visible one.
 * @typedef {{
 *   mode: 'auto' | 'normal' | 'single' | 'off',
 *   source: number,
 *   level: number,
 *   isRising: boolean,
 *   holdoffSeconds: number
 * }} ScopeTrigger
 */

/**
 * @typedef {{
 *   channels: [ScopeChannel, ScopeChannel],
 *   isSwapped: boolean,
 *   isXy: boolean,
 *   isSplit: boolean,
 *   sweepSeconds: number,
 *   trigger: ScopeTrigger
 * }} ScopeControls
 */

/**
 * Reads the settings of a signal that has a scope.
 * Its mode 'xy' draws one channel against the other.
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {ScopeControls}
 */
export function scopeControls(settings) {
    const source = settings.trigger_source;
    return {
        channels: [scopeChannel(settings, '1'), scopeChannel(settings, '2')],
        isSwapped: settings.swap === 'on',
        isXy: settings.mode === 'xy',
        isSplit: settings.layout === 'split',
        sweepSeconds: DIVISIONS_ACROSS * numberSetting(settings, 'sdiv'),
        trigger: {
            mode: wordAmong(settings.trigger, ['auto', 'normal', 'single', 'off']),
            source: source === 'shown' ? 0 : Number(source),
            level: numberSetting(settings, 'trigger_level'),
            isRising: settings.slope === 'rising',
            holdoffSeconds: numberSetting(settings, 'holdoff'),
        },
    };
}

/**
 * @param {import('../signal.js').SignalSettings} settings
 * @param {'1' | '2'} number
 * @returns {ScopeChannel}
 */
function scopeChannel(settings, number) {
    return {
        voltsPerDivision: numberSetting(settings, `v${number}`),
        offset: numberSetting(settings, `o${number}`),
        coupling: wordAmong(settings[`coupling${number}`], ['dc', 'ac', 'gnd']),
        isInverted: settings[`invert${number}`] === 'on',
    };
}

/**
 * @template {string} Word
 * @param {number | string} value
 * @param {Word[]} words
 * @returns {Word} the first one if the value is none of them
 */
function wordAmong(value, words) {
    return words.find((word) => word === value) ?? words[0];
}
