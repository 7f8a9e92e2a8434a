// The changed values in the address of the page: #beam_color=1,0.5,0.2&decay=0.9

import { defaultSignal } from './edit_history.js';
import { exportedNumbers, isAdjustable, parseValueText, readValue } from './parameter_text.js';
import { valueInJson } from './parameter_text.js';
import { applyPreset, readPreset } from './preset_line.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} LinkedPlayer */
/**
 * What an address asks for. `entries` are untrusted texts of the fragment by name.
 * @typedef {object} SharedSettings
 * @property {Map<string, string>} entries
 * @property {string} preset line of `?preset=`
 * @property {boolean} isBare only the picture
 * @property {boolean} isTransparent
 */

const mostEntries = 4096;

/**
 * Reads the address of the page.
 * @param {string} search '?bare&preset=afterglow:1:...&transparent'
 * @param {string} hash '#decay=0.9&preset=afterglow:1:...'
 * @returns {SharedSettings}
 */
export function readShared(search, hash) {
    const query = new URLSearchParams(search);
    const entries = [...new URLSearchParams(hash.replace(/^#/, ''))].slice(0, mostEntries);
    return {
        entries: new Map(entries),
        preset: query.get('preset') || '',
        isBare: query.has('bare'),
        isTransparent: query.has('transparent'),
    };
}

/**
 * Applies the presets and then the values of an address. Call it before the first frame.
 * @param {LinkedPlayer} player
 * @param {SharedSettings} shared
 * @returns {Promise<string[]>} notes for the user about ignored parts
 */
export async function applyShared(player, shared) {
    const { parameters } = player.description;
    const byName = new Map(parameters.map((parameter) => [parameter.name, parameter]));
    const isOwn = (/** @type {string} */ name) => shared.entries.has(name) && !byName.has(name);
    const lines = [shared.preset, isOwn('preset') ? shared.entries.get('preset') : ''];
    /** @type {string[]} */
    const notes = [];
    for (const line of lines)
        if (line)
            try {
                notes.push(...applyPreset(player, await readPreset(line)));
            } catch (error) {
                notes.push(/** @type {Error} */ (error).message);
            }
    if (isOwn('signal')) notes.push(...applySignalText(player, shared.entries.get('signal') || ''));
    /** @type {string[]} */
    const ignored = [];
    for (const [name, text] of shared.entries) {
        const parameter = byName.get(name);
        const numbers = parameter && isAdjustable(parameter) && parseValueText(parameter, text);
        if (numbers) player.setValue(name, numbers);
        else if (parameter || !/^(preset|signal)$/.test(name)) ignored.push(name.slice(0, 40));
    }
    if (ignored.length) {
        const more = ignored.length > 4 ? ` and ${ignored.length - 4} more` : '';
        notes.push(`Ignored from the link: ${ignored.slice(0, 4).join(', ')}${more}.`);
    }
    return notes;
}

/**
 * The fragment without '#': changed values, and a changed signal. Empty without changes.
 * @param {LinkedPlayer} player
 * @returns {string}
 */
export function linkFragment(player) {
    const { description, signal } = player;
    const parts = [];
    for (const parameter of description.parameters) {
        const numbers = player.values.get(parameter.name);
        const isShared = isAdjustable(parameter) && parameter.type !== 'event';
        if (numbers && isShared && String(numbers) !== String(exportedNumbers(parameter)))
            parts.push([parameter.name, String(valueInJson(parameter, numbers))]);
    }
    const generator = signal &&
        (description.generators || []).find((one) => one.kind === signal.kind);
    if (signal && generator && JSON.stringify(signal) !== JSON.stringify(description.signal)) {
        const settings = generator.settings
            .filter((one) => signal.settings[one.name] !== one.default)
            .map((one) => `${one.name}=${signal.settings[one.name]}`);
        parts.push(['signal', [signal.kind, settings.join(',')].filter(Boolean).join(':')]);
    }
    return parts.map((pair) => pair.map(readableComponent).join('=')).join('&');
}

/**
 * Percent-encodes only what a fragment needs. Spaces become '+'.
 * @param {string} text
 * @returns {string}
 */
function readableComponent(text) {
    return encodeURIComponent(text)
        .replace(/%(2C|2F|3A|3D)/g, (code) => decodeURIComponent(code)).replace(/%20/g, '+');
}

/**
 * Sets a generated signal, such as 'lissajous:x=5,y=4'.
 * @param {LinkedPlayer} player
 * @param {string} text
 * @returns {string[]} notes
 */
function applySignalText(player, text) {
    const [, kind, list] = /^([a-z]+)(?::(.*))?$/.exec(text) || [];
    const generator = (player.description.generators || []).find((one) => one.kind === kind);
    if (!generator) return ['The signal in the link is unknown and ignored.'];
    const signal = defaultSignal(generator);
    for (const pair of (list || '').split(',').filter(Boolean)) {
        const [name, value] = pair.split('=');
        const setting = generator.settings.find((one) => one.name === name);
        const numbers = setting && readValue(setting, value);
        if (!numbers) return ['The signal in the link is invalid and ignored.'];
        signal.settings[name] = valueInJson(setting, numbers);
    }
    try {
        player.setSignal(signal);
        return [];
    } catch (error) {
        return [/** @type {Error} */ (error).message];
    }
}
