// The section of the signal or the picture: opening media, and the settings of a generated signal.

import { chooseFile, makeElement, makeTextButton } from './element.js';
import { lookId, presetFromPng, readPreset } from './preset_line.js';
import { makeSignalSettings } from './signal_settings.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} MediaPlayer */
/** @typedef {import('./edit_history.js').EditHistory} MediaHistory */
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
        ['Open sound', used.sound,
            async () => player.openFile('sound', await chooseFile(soundTypes))],
        ['Use microphone', used.sound && hasCapture, () => player.openDevice('microphone')],
        ['Open picture', used.picture,
            async () => player.openFile('picture', await chooseFile('image/*'))],
        ['Open video', used.picture,
            async () => player.openFile('video', await chooseFile('video/*'))],
        ['Use camera', used.picture && hasCapture, () => player.openDevice('camera')],
        ['Share screen', used.picture && !!devices && !!devices.getDisplayMedia,
            () => player.openDevice('screen')],
    ];
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
    const buttons = mediaActions(player).filter(([, isUsable]) => isUsable)
        .map(([label, , act]) => makeTextButton(label, () => actions.attempt(act)));
    const restore = makeTextButton('Restore original',
        () => actions.attempt(() => player.resetSource()));
    const start = makeTextButton('Start sound',
        () => actions.attempt(() => player.startSound()));
    start.className = 'strong';
    const name = makeElement('span', { className: 'count' });
    const signal = isSignal && generators ? makeSignalSettings(player, history, actions) : null;
    const update = () => {
        name.textContent = isSignal ? player.state.signalName : player.state.sourceName;
        start.hidden = !player.state.needsClick;
        restore.hidden = !player.state.isMediaChanged;
        if (signal) signal.update();
    };
    const element = makeElement('details', { className: 'group media', open: true },
        makeElement('summary', {}, isSignal ? 'Signal' : used.picture ? 'Picture' : 'Sound', name),
        makeElement('div', { className: 'buttons' }, start, ...buttons, restore),
        ...(signal ? signal.elements : []));
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
        const isOther = used.picture && preset && preset.look !== lookId(player);
        if (preset && !isOther) return openPreset(preset);
    }
    if (used.picture && file.type.startsWith('image/')) return player.openFile('picture', file);
    if (used.picture && file.type.startsWith('video/')) return player.openFile('video', file);
    const isSound = /^(audio|video)\//.test(file.type) ||
        /\.(wav|flac|ogg|mp3|aiff?)$/i.test(file.name);
    if (used.sound && isSound) return player.openFile('sound', file);
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
