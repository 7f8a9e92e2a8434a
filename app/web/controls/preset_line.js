// Presets as the program shares them: one line of text, JSON, or a chunk in a PNG.

import { defaultSignal } from './edit_history.js';
import { defaultNumbers, isAdjustable, isFileParameter, readValue } from './parameter_text.js';
import { valueInJson, withFloatDigits } from './parameter_text.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} PresetPlayer */
/** @typedef {import('./edit_history.js').HistorySignal} PresetSignal */
/**
 * A preset in JSON, see docs/presets.md.
 * @typedef {object} SharedPreset
 * @property {string} format
 * @property {number} version
 * @property {string} look
 * @property {Record<string, unknown>} [signal]
 * @property {string} [source]
 * @property {Record<string, unknown>} [values]
 * @property {unknown} [modulation]
 * @property {unknown} [bypass]
 */

const presetScheme = 'afterglow:1:';
const largestPreset = 4 << 20;
const damagedPreset = 'The shared preset is damaged or incomplete. Copy the whole line.';

/**
 * All bytes of a stream. Throws an Error beyond `largestPreset`.
 * @param {ReadableStream<Uint8Array>} stream
 * @returns {Promise<Uint8Array>}
 */
async function readAllBytes(stream) {
    /** @type {Uint8Array[]} */
    const parts = [];
    const reader = stream.getReader();
    let size = 0;
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
        size += part.value.length;
        parts.push(part.value);
        if (size > largestPreset) throw new Error(damagedPreset);
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/**
 * @param {Uint8Array} bytes
 * @param {'CompressionStream' | 'DecompressionStream'} kind zlib streams (RFC 1950)
 * @returns {Promise<Uint8Array>}
 */
function throughZlib(bytes, kind) {
    const Stream = /** @type {any} */ (globalThis)[kind];
    if (!Stream) throw new Error('This browser can\'t read presets. Update the browser.');
    return readAllBytes(new Blob([bytes]).stream().pipeThrough(new Stream('deflate')));
}

/**
 * @param {Uint8Array} stream
 * @returns {Promise<string>}
 */
async function inflatedText(stream) {
    const bytes = await throughZlib(stream, 'DecompressionStream').catch(() => null);
    if (!bytes) throw new Error(damagedPreset);
    return new TextDecoder().decode(bytes);
}

/**
 * The share line of a preset.
 * @param {object} preset
 * @returns {Promise<string>}
 */
export async function presetLine(preset) {
    const json = new TextEncoder().encode(JSON.stringify(preset));
    const stream = await throughZlib(json, 'CompressionStream');
    let letters = '';
    for (const byte of stream) letters += String.fromCharCode(byte);
    return presetScheme +
        btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/**
 * @param {string} text
 * @returns {SharedPreset}
 */
function presetFromJson(text) {
    /** @type {any} */
    let preset;
    try {
        preset = JSON.parse(text);
    } catch {
        throw new Error(damagedPreset);
    }
    if (!preset || preset.format !== 'afterglow-preset')
        throw new Error('This text isn\'t an Afterglow preset. Copy a preset and paste it.');
    if (preset.version !== 1)
        throw new Error('The preset needs a newer version of Afterglow. Export the page again.');
    return preset;
}

/**
 * Reads a share line or the JSON of a preset file. Throws an Error with a message for the user.
 * @param {string} text
 * @returns {Promise<SharedPreset>}
 */
export async function readPreset(text) {
    if (text.length > 2 * largestPreset)
        throw new Error('The preset is too large. The limit is 8 MiB.');
    if (text.trim().startsWith('{')) return presetFromJson(text);
    const line = text.replace(/\s+/g, '');
    if (/^afterglow:([2-9]|\d\d)/.test(line))
        throw new Error('The preset needs a newer version of Afterglow. Export the page again.');
    if (!line.startsWith(presetScheme))
        throw new Error('This text isn\'t a preset. Copy a line that starts with "afterglow:1:".');
    let letters = '';
    try {
        letters = atob(line.slice(presetScheme.length).replace(/-/g, '+').replace(/_/g, '/'));
    } catch {
        throw new Error(damagedPreset);
    }
    return presetFromJson(await inflatedText(Uint8Array.from(letters, (c) => c.charCodeAt(0))));
}

/**
 * The preset in a PNG that was saved by the program: an iTXt chunk. Null without one.
 * @param {Blob} file
 * @returns {Promise<SharedPreset | null>}
 */
export async function presetFromPng(file) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const view = new DataView(bytes.buffer);
    const keyword = 'afterglow-preset\0';
    for (let at = 8; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) {
        const size = view.getUint32(at);
        const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8 + keyword.length));
        if (name !== `iTXt${keyword}`) continue;
        let start = at + 8 + keyword.length + 2;
        for (let skipped = 0; skipped < 2; ++skipped) start = bytes.indexOf(0, start) + 1;
        const data = bytes.subarray(start, at + 8 + size);
        const isCompressed = bytes[at + 8 + keyword.length] === 1;
        return presetFromJson(isCompressed ? await inflatedText(data)
            : new TextDecoder().decode(data));
    }
    return null;
}

/**
 * The folder name of the look, or 'a+b' of a stack.
 * @param {PresetPlayer} player
 * @returns {string}
 */
export function lookId(player) {
    const { id, name } = player.description;
    return id || name.toLowerCase().replace(/[^a-z0-9+]+/g, '-');
}

/**
 * The complete preset of the player: all values, so that it looks the same in other versions.
 * @param {PresetPlayer} player
 * @returns {SharedPreset}
 */
export function presetOf(player) {
    const { description, signal } = player;
    /** @type {Record<string, unknown>} */
    const values = {};
    /** @type {Record<string, object>} */
    const modulation = {};
    const parameters = [...description.parameters].sort((a, b) => a.name < b.name ? -1 : 1);
    for (const parameter of parameters) {
        const numbers = player.values.get(parameter.name);
        if (numbers && !isFileParameter(parameter))
            values[parameter.name] = valueInJson(parameter, numbers);
        if (parameter.modulation) modulation[parameter.name] = parameter.modulation;
    }
    const { generated, content } = description.source || { generated: '', content: '' };
    const source = generated || (content.startsWith('pattern:') ? content : '');
    return {
        format: 'afterglow-preset', version: 1, look: lookId(player),
        ...(description.digest && { look_digest: description.digest }),
        ...(description.driven_by === 'signal' && signal && { signal: sharedSignal(signal) }),
        ...(source && { source }),
        values,
        ...(Object.keys(modulation).length && { modulation }),
    };
}

/**
 * The signal with file names instead of paths, as in the program's presets.
 * @param {PresetSignal} signal
 * @returns {Record<string, unknown>}
 */
function sharedSignal(signal) {
    /** @type {Record<string, unknown>} */
    const shared = { kind: signal.kind };
    for (const key of Object.keys(signal.settings).sort()) {
        const value = signal.settings[key];
        shared[key] = typeof value === 'number' ? withFloatDigits(value)
            : key === 'file' ? String(value).replace(/.*\//, '') : value;
    }
    return shared;
}

/**
 * Sets the values and the signal of a preset. Throws an Error if it is for another look.
 * @param {PresetPlayer} player
 * @param {SharedPreset} preset
 * @returns {string[]} notes for the user about what the page could not apply
 */
export function applyPreset(player, preset) {
    const { description } = player;
    if (preset.look !== lookId(player))
        throw new Error(`This preset is for the look "${preset.look}". ` +
            `This page shows "${lookId(player)}".`);
    const given = new Map(Object.entries(preset.values || {}));
    /** @type {string[]} */
    const refused = [];
    for (const parameter of description.parameters.filter((one) => !isFileParameter(one))) {
        const key = given.has(parameter.name) ? parameter.name : parameter.was || parameter.name;
        const numbers = given.has(key) ? readValue(parameter, given.get(key))
            : defaultNumbers(parameter);
        const current = JSON.stringify(player.values.get(parameter.name));
        if (!numbers || (!isAdjustable(parameter) && JSON.stringify(numbers) !== current))
            refused.push(parameter.label);
        else if (isAdjustable(parameter))
            player.setValue(parameter.name, numbers);
    }
    const notes = refused.length
        ? [`The page can't set these values: ${refused.slice(0, 5).join(', ')}.`] : [];
    return notes.concat(applySignal(player, preset), notesAboutPreset(player, preset));
}

/**
 * @param {PresetPlayer} player
 * @param {SharedPreset} preset
 * @returns {string[]} notes
 */
function applySignal(player, preset) {
    const { signal } = player;
    if (!preset.signal || !signal || player.description.driven_by !== 'signal') return [];
    const { kind, ...settings } = preset.signal;
    const generator = (player.description.generators || []).find((one) => one.kind === kind);
    const base = generator ? defaultSignal(generator) : kind === signal.kind ? signal : null;
    /** @type {PresetSignal} */
    const complete = { kind: String(kind), settings: { ...(base && base.settings), ...settings } };
    if (JSON.stringify(sharedSignal(complete)) === JSON.stringify(sharedSignal(signal))) return [];
    try {
        player.setSignal(complete);
        return [];
    } catch (error) {
        return [`The page keeps its signal. ${/** @type {Error} */ (error).message}`];
    }
}

/**
 * @param {PresetPlayer} player
 * @param {SharedPreset} preset
 * @returns {string[]} notes about what only the program can apply
 */
function notesAboutPreset(player, preset) {
    const own = presetOf(player);
    const notes = [];
    const isPicture = player.description.driven_by === 'picture';
    if (isPicture && preset.source && preset.source !== own.source)
        notes.push('The page keeps its picture. Open the picture of the preset yourself.');
    if (JSON.stringify(preset.modulation) !== JSON.stringify(own.modulation))
        notes.push('The page can\'t change modulation. Export the preset as a page.');
    if (preset.bypass) notes.push('The page can\'t bypass looks. Export the preset as a page.');
    return notes;
}
