// Signals that draw a sound file or live sound.
import { SoundInput, SoundReader, completePlug } from './audio_input.js';
import { MappedSound, channelMap, checkChannels } from './audio_channels.js';
import { SoundSpectrum } from './audio_spectrum_signal.js';
import { liveStream, soundStream, wholeSamples } from './audio_stream.js';
import { TriggeredSweeps } from './audio_triggers.js';
import { samplesIn } from './clock.js';
import { Scope } from './scope/scope.js';
import { scopeControls } from './scope/scope_controls.js';
import { PeriodicSweeps } from './scope/sweeps.js';
import { numberSetting } from './signal.js';

/**
 * Opens two channels of the sound, from 1; 0 is silence.
 * @typedef {(left: number, right: number) => import('./audio_stream.js').SampleStream} OpenSound
 */

/**
 * @typedef {{
 *   sound?: import('../sound/sound.js').Sound,
 *   live?: import('./audio_stream.js').LiveSound
 * }} AudioMedia
 */

/**
 * The scope channels with a trace.
 * @param {import('./audio_input.js').SoundPlug} plug
 * @returns {[boolean, boolean]}
 */
function shownChannels(plug) {
    const isLeftShown = plug.channels !== 'right';
    const isRightShown = plug.channels === 'right' || plug.channels === 'both';
    return plug.isSwapped ? [isRightShown, isLeftShown] : [isLeftShown, isRightShown];
}

/**
 * A sound on a scope: traces over time, or one channel against the other.
 * Each sample is drawn once.
 */
class SoundScope {
    #input;
    #reader;
    #scope;
    #sweeps;

    /**
     * @param {import('./audio_stream.js').SampleStream} stream
     * @param {import('./audio_input.js').SoundPlug} plug
     * @param {import('./scope/scope_controls.js').ScopeControls} controls
     */
    constructor(stream, plug, controls) {
        const isShown = shownChannels(plug);
        this.#input = new SoundInput(stream, plug);
        this.#reader = new SoundReader(this.#input);
        this.#scope = new Scope(controls, isShown, this.#input.rate);
        const length = this.#scope.sweepSamples;
        const trigger = controls.trigger;
        const shown = isShown[0] ? 0 : 1;
        const channel = trigger.source === 0 ? shown : trigger.source - 1;
        this.#sweeps = trigger.mode === 'off' || controls.isXy
            ? new PeriodicSweeps(0, length, length)
            : new TriggeredSweeps(this.#input, trigger, channel,
                controls.channels[channel].isInverted, length);
    }

    /** Duration in s. */
    get seconds() {
        return this.#input.seconds;
    }

    /**
     * @param {number} start in s
     * @param {number} end in s
     * @param {import('./beam.js').Beam} beam
     */
    trace(start, end, beam) {
        const reader = this.#reader;
        // A sweep with two traces can extend slightly beyond the span.
        const ahead = Math.trunc(this.#input.rate / 60) + 2;
        const last = samplesIn(start, end, this.#input.rate).end + ahead;
        reader.forget();
        this.#scope.trace(start, end, this.#input.count, this.#sweeps, beam,
            (sample, _, volts) => {
                const at = reader.seek(sample, last);
                volts[0] = reader.block[at];
                volts[1] = reader.block[at + 1];
            });
    }
}

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @returns {import('./audio_input.js').SoundPlug['channels']}
 */
function plugChannels(settings) {
    if (settings.mode === 'xy' || settings.channel === 'both') {
        return 'both';
    }
    return settings.channel === 'left' || settings.channel === 'right' ? settings.channel : 'mean';
}

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @param {import('./scope/scope_controls.js').ScopeControls} controls
 * @returns {import('./audio_input.js').SoundPlug}
 */
function scopePlug(settings, controls) {
    return {
        channels: plugChannels(settings),
        isSwapped: controls.isSwapped,
        coupling: [controls.channels[0].coupling, controls.channels[1].coupling],
        level: numberSetting(settings, 'level'),
        hasAutoGain: settings.auto_gain === 'on',
        upsample: numberSetting(settings, 'upsample'),
    };
}

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @returns {import('./audio_spectrum_signal.js').SpectrumControls}
 */
function spectrumControls(settings) {
    return {
        size: Number(settings.fft),
        smoothingSeconds: numberSetting(settings, 'smoothing'),
        low: numberSetting(settings, 'low'),
        high: numberSetting(settings, 'high'),
        floor: numberSetting(settings, 'floor'),
        ceiling: numberSetting(settings, 'ceiling'),
        isRadial: settings.mode === 'radial',
        radius: numberSetting(settings, 'radius'),
        pulse: numberSetting(settings, 'pulse'),
        beatThreshold: numberSetting(settings, 'beat_threshold'),
        beatDecaySeconds: numberSetting(settings, 'beat_decay'),
    };
}

/**
 * @param {import('./signal.js').SignalSettings} settings
 * @param {import('./audio_stream.js').SampleStream} stream
 * @returns {import('./signal.js').Signal}
 */
function makeSpectrum(settings, stream) {
    const controls = spectrumControls(settings);
    if (controls.low >= controls.high) {
        throw new Error('\'high\' must be above \'low\'');
    }
    if (controls.floor >= controls.ceiling) {
        throw new Error('\'ceiling\' must be above \'floor\'');
    }
    const channels = plugChannels(settings);
    const plug = completePlug({
        channels: channels === 'both' ? 'mean' : channels,
        isSwapped: channels === 'right',
        level: numberSetting(settings, 'level'),
        hasAutoGain: settings.auto_gain === 'on',
    });
    return new SoundSpectrum(stream, plug, controls);
}

/**
 * Only xy mode maps channels to properties of the beam.
 * @param {import('./signal.js').SignalSettings} settings
 * @param {OpenSound} open
 * @param {number} channels of the sound
 * @returns {import('./signal.js').Signal}
 */
function makeMapped(settings, open, channels) {
    const map = channelMap(settings);
    checkChannels(map, channels);
    const controls = scopeControls(settings);
    const plug = scopePlug(settings, controls);
    const scope = new SoundScope(open(map.x, map.y), plug, controls);
    if (map.intensity === 0 && !map.hasTint) {
        return scope;
    }
    const streams = [open(map.intensity, map.r), open(map.g, map.b)];
    return new MappedSound(scope, streams[0], streams[1], map, plug.upsample);
}

/**
 * Opens the part of a sound file that the settings name.
 * @param {import('./signal.js').SignalSettings} settings
 * @param {import('../sound/sound.js').Sound | undefined} sound
 * @returns {{open: OpenSound, channels: number}}
 */
function openSoundFile(settings, sound) {
    if (!sound || sound.channels.length === 0 || sound.channels[0].length === 0) {
        throw new Error('audio: no sound to draw. Open a sound file.');
    }
    const part = soundPart(settings, sound);
    return {
        open: (left, right) => soundStream(sound, part, left, right),
        channels: sound.channels.length,
    };
}

/**
 * The part of a sound that the settings `start`, `end` and `loop` name.
 * @param {import('./signal.js').SignalSettings} settings
 * @param {import('../sound/sound.js').Sound} sound
 * @returns {import('./audio_stream.js').SoundPart}
 */
export function soundPart(settings, sound) {
    const startSeconds = numberSetting(settings, 'start');
    const endSeconds = numberSetting(settings, 'end');
    const first = wholeSamples(startSeconds, sound.rate);
    const end = wholeSamples(endSeconds, sound.rate);
    if (first >= sound.channels[0].length) {
        throw new Error(`audio: 'start' is ${startSeconds} s, but the sound is only ` +
            `${sound.seconds} s long. Use an earlier start.`);
    }
    if (end > 0 && end <= first) {
        throw new Error(`audio: 'end' is ${endSeconds} s, but 'start' is ${startSeconds} s. ` +
            'Use a later end, or 0 for the end of the sound.');
    }
    return { first, end, loops: settings.loop === 'on' };
}

/**
 * Makes a signal of kind audio from a sound, or of kind microphone from live sound.
 * @param {import('./signal.js').SignalSettings} settings complete
 * @param {AudioMedia} media
 * @returns {import('./signal.js').Signal}
 */
export function makeAudioSignal(settings, media) {
    const live = media.live;
    const { open, channels } = live
        ? {
            open: (/** @type {number} */ left, /** @type {number} */ right) =>
                liveStream(live, left, right),
            channels: live.channels,
        }
        : openSoundFile(settings, media.sound);
    if (settings.mode === 'xy') {
        return makeMapped(settings, open, channels);
    }
    if (settings.mode === 'spectrum' || settings.mode === 'radial') {
        return makeSpectrum(settings, open(1, 2));
    }
    const controls = scopeControls(settings);
    return new SoundScope(open(1, 2), scopePlug(settings, controls), controls);
}
