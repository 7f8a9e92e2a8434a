// The input of a look that is driven by a signal.

/**
 * A pure function of time.
 *
 * `trace` appends the points of (start, end], oldest first, with ages relative to `end`.
 * Each point belongs to exactly one of several adjoining spans. Times are in s from 0.
 * `seconds` is the duration, Infinity for a signal without an end.
 * @typedef {{
 *   trace: (start: number, end: number, beam: import('./beam.js').Beam) => void,
 *   seconds: number
 * }} Signal
 */

/**
 * Settings of a signal: all keys of its kind, as in portable.json.
 * @typedef {{[key: string]: number | string}} SignalSettings
 */

/**
 * A setting that is a number.
 * @param {SignalSettings} settings
 * @param {string} key
 * @returns {number}
 */
export function numberSetting(settings, key) {
    const value = settings[key];
    if (typeof value !== 'number' || !Number.isFinite(value)) {
        throw new Error(`Setting '${key}' of the signal is not a number. Export the page again.`);
    }
    return value;
}
