// The section of the signal or the picture: opening media, and the settings of a generated signal.

import { defaultSignal } from './edit_history.js';
import { chooseFile, makeElement, makeTextButton } from './element.js';
import { defaultNumbers, readValue, valueInJson } from './parameter_text.js';
import { makeParameterRow } from './parameter_row.js';
import { presetFromPng, readPreset } from './preset_line.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} MediaPlayer */
/** @typedef {import('./edit_history.js').EditHistory} MediaHistory */
/** @typedef {import('./parameter_row.js').ParameterRow} SettingRow */
/** @typedef {import('./preset_line.js').SharedPreset} DroppedPreset */
/** @typedef {import('./actions.js').PageActions} MediaActions */

const soundTypes = 'audio/*,.wav,.flac,.ogg,.mp3,.m4a,.opus,.aiff';

/**
 * Which media the look can use.
 * @param {MediaPlayer} player
 * @returns {{sound: boolean, picture: boolean}}
 */
function usedMedia(player) {
    const { driven_by, passes } = player.description;
    const readsSound = passes.some((pass) => pass.inputs.some((input) => input.from === 'sound'));
    return { sound: driven_by === 'signal' || readsSound, picture: driven_by === 'picture' };
}

/**
 * The label, whether the look and this browser can use it, and what it does.
 * @param {MediaPlayer} player
 * @returns {[string, boolean, () => Promise<void> | void][]}
 */
function mediaActions(player) {
    const used = usedMedia(player);
    const devices = navigator.mediaDevices;
    const hasCapture = !!devices && !!devices.getUserMedia;
    return [
        ['Open sound', used.sound, async () => player.openSound(await chooseFile(soundTypes))],
        ['Use microphone', used.sound && hasCapture, () => player.openMicrophone()],
        ['Open picture', used.picture, async () => player.openPicture(await chooseFile('image/*'))],
        ['Open video', used.picture, async () => player.openVideo(await chooseFile('video/*'))],
        ['Use camera', used.picture && hasCapture, () => player.openCamera()],
        ['Share screen', used.picture && !!devices && !!devices.getDisplayMedia,
            () => player.openScreen()],
        ['Restore original', used.sound || used.picture, () => player.resetSource()],
    ];
}

/**
 * The rows of the current signal's settings. Empty for a kind that the page cannot generate.
 * @param {MediaPlayer} player
 * @param {MediaHistory} history
 * @param {MediaActions} actions
 * @returns {SettingRow[]}
 */
function settingRows(player, history, actions) {
    const { signal } = player;
    const generator = signal &&
        (player.description.generators || []).find((one) => one.kind === signal.kind);
    if (!signal || !generator) return [];
    const { kind } = signal;
    const exported = player.description.signal;
    return generator.settings.filter((setting) => !setting.hidden).map((setting) => {
        const initial = (exported && exported.kind === kind &&
            readValue(setting, exported.settings[setting.name])) || defaultNumbers(setting);
        const get = () => (player.signal && player.signal.kind === kind &&
            readValue(setting, player.signal.settings[setting.name])) || initial;
        const change = (/** @type {number[]} */ numbers) => {
            const settings = { ...(player.signal || signal).settings };
            settings[setting.name] = valueInJson(setting, numbers);
            actions.attempt(() => player.setSignal({ kind, settings }));
        };
        return makeParameterRow(setting, {
            get, initial, say: actions.say, openFile: null,
            set: (numbers) => history.edit(setting.name, () => change(numbers)),
            finish: () => history.finish(),
            reset: () => history.step(setting.name, () => change(initial)),
        });
    });
}

/**
 * @param {MediaPlayer} player
 * @param {MediaHistory} history
 * @param {MediaActions} actions
 * @returns {{element: HTMLElement, update: () => void} | null} null if the look uses no media
 */
export function makeMediaSection(player, history, actions) {
    const used = usedMedia(player);
    if (!used.sound && !used.picture) return null;
    const { driven_by, generators } = player.description;
    const isSignal = driven_by === 'signal';
    const isNarrow = window.matchMedia('(max-width: 700px)').matches;
    const buttons = mediaActions(player).filter(([, isUsable]) => isUsable)
        .map(([label, , act]) => makeTextButton(label, () => actions.attempt(act)));
    const start = makeTextButton('Start sound',
        () => actions.attempt(() => player.startSound()));
    start.className = 'strong';
    const name = makeElement('span', { className: 'count' });
    const kinds = makeElement('select', { 'aria-label': 'Signal' });
    const settings = makeElement('details', { open: !isNarrow });
    /** @type {SettingRow[]} */
    let rows = [];
    let shownKind = '';
    kinds.onchange = () => actions.attempt(() => {
        const generator = (generators || []).find((one) => one.kind === kinds.value);
        if (generator) history.step('Signal', () => player.setSignal(defaultSignal(generator)));
    });
    const updateSignal = () => {
        const kind = player.signal ? player.signal.kind : '';
        if (kind !== shownKind) {
            shownKind = kind;
            const offered = (generators || []).map((one) => makeElement('option',
                { value: one.kind, selected: one.kind === kind }, one.label));
            if (!offered.some((option) => option.value === kind))
                offered.unshift(makeElement('option', { value: kind, selected: true },
                    player.state.signalName || kind));
            kinds.replaceChildren(...offered);
            rows = settingRows(player, history, actions);
            settings.hidden = !rows.length;
            settings.replaceChildren(makeElement('summary', {}, 'Settings'),
                ...rows.map((row) => row.element));
        }
        for (const row of rows) row.update('');
    };
    const update = () => {
        name.textContent = isSignal ? player.state.signalName : player.state.sourceName;
        start.hidden = !player.state.needsClick;
        if (isSignal) updateSignal();
    };
    const element = makeElement('details', { className: 'group media', open: true },
        makeElement('summary', {}, isSignal ? 'Signal' : used.picture ? 'Picture' : 'Sound', name),
        makeElement('div', { className: 'buttons' }, start, ...buttons),
        ...(isSignal && generators ? [kinds, settings] : []));
    return { element, update };
}

/**
 * Opens a dropped or pasted file: a preset, or media that the look can use.
 * @param {MediaPlayer} player
 * @param {File} file
 * @param {(preset: DroppedPreset) => void} openPreset
 * @returns {Promise<void>} rejects with a message for the user
 */
export async function openDroppedFile(player, file, openPreset) {
    const used = usedMedia(player);
    if (/\.(json|txt)$/i.test(file.name)) return openPreset(await readPreset(await file.text()));
    if (file.type === 'image/png') {
        const preset = await presetFromPng(file);
        if (preset) return openPreset(preset);
    }
    if (used.picture && file.type.startsWith('image/')) return player.openPicture(file);
    if (used.picture && file.type.startsWith('video/')) return player.openVideo(file);
    const isSound = /^(audio|video)\//.test(file.type) ||
        /\.(wav|flac|ogg|mp3|aiff?)$/i.test(file.name);
    if (used.sound && isSound) return player.openSound(file);
    throw new Error(`This look can't use "${file.name}". ${dropHint(player)}.`);
}

/**
 * What can be dropped on the page.
 * @param {MediaPlayer} player
 * @returns {string}
 */
export function dropHint(player) {
    const used = usedMedia(player);
    if (used.picture) return 'Drop a picture, a video or a preset';
    return used.sound ? 'Drop a sound or a preset' : 'Drop a preset';
}
