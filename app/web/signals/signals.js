// The kinds of signal that a page can draw.
import { makeAudioSignal } from './audio_signal.js';
import { makeDrawing } from './drawing/drawing.js';
import { makeScene } from './drawing/scene.js';
import { makeHarmonics } from './generators/harmonics.js';
import { makeLissajous } from './generators/lissajous.js';
import { makeAmplitudeModulation, makeFrequencyModulation } from './generators/modulation.js';
import { makeWaveform } from './generators/waveform.js';

/**
 * External data of a signal: the sound of kind audio, the input device of kind microphone.
 * @typedef {import('./audio_signal.js').AudioMedia} SignalMedia
 */

/**
 * `paths` is the geometry of the kinds text, scene and drawing.
 * @typedef {{
 *   kind: string,
 *   settings: import('./signal.js').SignalSettings,
 *   paths?: any
 * }} SignalSpec
 */

/** @typedef {(spec: SignalSpec, media: SignalMedia) => import('./signal.js').Signal} SignalMaker */

/** @type {[string, SignalMaker][]} */
const SIGNAL_KINDS = [
    ['lissajous', (spec) => makeLissajous(spec.settings)],
    ['waveform', (spec) => makeWaveform(spec.settings)],
    ['harmonics', (spec) => makeHarmonics(spec.settings)],
    ['am', (spec) => makeAmplitudeModulation(spec.settings)],
    ['fm', (spec) => makeFrequencyModulation(spec.settings)],
    ['audio', (spec, media) => makeAudioSignal(spec.settings, { sound: media.sound })],
    ['microphone', (spec, media) => makeLiveSignal(spec.settings, media)],
    ['scene', (spec) => makeScene(spec.settings, pathsOfSpec(spec))],
    ['text', (spec) => makeScene(spec.settings, pathsOfSpec(spec))],
    ['drawing', (spec) => makeDrawing(spec.settings, pathsOfSpec(spec))],
];

/**
 * Makes the signal of a spec.
 * @param {SignalSpec} spec with all settings of its kind
 * @param {SignalMedia} [media]
 * @returns {import('./signal.js').Signal}
 */
export function makeSignal(spec, media = {}) {
    const known = SIGNAL_KINDS.find(([kind]) => kind === spec.kind);
    if (!known) {
        throw new Error(unknownSignalMessage(spec.kind));
    }
    return known[1](spec, media);
}

/**
 * @param {string} kind
 * @returns {string}
 */
function unknownSignalMessage(kind) {
    const kinds = SIGNAL_KINDS.map(([name]) => name).join(', ');
    return `A page can't draw the signal '${kind}'. Choose one of: ${kinds}.`;
}

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @param {SignalMedia} media
 * @returns {import('./signal.js').Signal}
 */
function makeLiveSignal(settings, media) {
    if (!media.live) {
        throw new Error('No audio input is open. Open the microphone, and allow its use.');
    }
    return makeAudioSignal(settings, { live: media.live });
}

/**
 * The geometry that the exporter computed.
 * @param {SignalSpec} spec
 * @returns {any}
 */
function pathsOfSpec(spec) {
    if (!spec.paths) {
        throw new Error(`The page has no lines for this ${spec.kind}. Export a page with it.`);
    }
    return spec.paths;
}
