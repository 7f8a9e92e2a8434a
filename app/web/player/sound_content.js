// The sound of a page: a file that it plays, or a microphone.

import { openMicrophone } from '../sound/live_sound.js';
import { SoundPlayer } from '../sound/sound_player.js';
import { soundPart } from '../signals/audio_signal.js';
import { liveStream, soundStream } from '../signals/audio_stream.js';

/**
 * @typedef {import('../sound/sound.js').Sound} ContentSound
 * @typedef {import('../signals/signal.js').SignalSettings} SoundSettings
 */

/** All settings of a sound that the user opens, as the program's defaults. */
const openedSoundSettings = {
    loop: 'on', start: 0, end: 0, mode: 'xy', level: 1, auto_gain: 'off', upsample: 4,
    channel: 'mean', fit: 'look', v1: 0.25, o1: 0, coupling1: 'dc', invert1: 'off', v2: 0.25, o2: 0,
    coupling2: 'dc', invert2: 'off', swap: 'off', sdiv: 0.002, layout: 'split', trigger: 'auto',
    trigger_source: 'shown', trigger_level: 0, slope: 'rising', holdoff: 0, x: 1, y: 2,
    intensity: 0, r: 0, g: 0, b: 0, fft: '2048', smoothing: 0.08, floor: -80, ceiling: 0, low: 20,
    high: 20000, radius: 0.4, pulse: 0.3, beat_threshold: 2, beat_decay: 0.2,
};

/**
 * The settings of an opened sound. One channel would be a diagonal in XY mode.
 * @param {number} channels
 * @returns {SoundSettings}
 */
export function settingsOfOpenedSound(channels) {
    return channels > 1 ? { ...openedSoundSettings, fit: 'whole' }
        : { ...openedSoundSettings, mode: 'waveform' };
}

/** At most one sound at a time. */
export class SoundContent {
    /** @type {ContentSound|null} */
    #sound = null;
    /** The part of the sound that plays. */
    #part = { first: 0, end: 0, loops: true };
    /** @type {SoundPlayer|null} */
    #player = null;
    /** @type {import('../sound/live_sound.js').Microphone|null} */
    #microphone = null;
    #isPaused = false;
    #isMuted = false;  // another signal is drawn
    #hasStarted = false;

    /** What a signal reads. */
    get media() {
        return { sound: this.#sound || undefined,
            live: this.#microphone ? this.#microphone.sound : undefined };
    }

    /**
     * Its samples by number, for sound textures and loudness. Null without a sound.
     * @returns {import('../signals/audio_stream.js').SampleStream|null}
     */
    stream() {
        if (this.#microphone)
            return liveStream(this.#microphone.sound);
        return this.#sound && !this.#isMuted
            ? soundStream(this.#sound, this.#part) : null;
    }

    /**
     * Replaces the sound. It plays from start() on.
     * @param {ContentSound} sound
     * @param {SoundSettings} settings
     */
    use(sound, settings) {
        this.close();
        this.#sound = sound;
        this.#part = soundPart(settings, sound);
        this.#player = new SoundPlayer(sound, settings);
        this.#player.setPaused(this.#isPaused);
    }

    /**
     * Replaces the sound by a microphone. Call it in the handler of a click.
     * @param {number} seconds time of the picture
     * @returns {Promise<{name: string, channels: number}>}
     */
    async openMicrophone(seconds) {
        const microphone = await openMicrophone();
        this.close();
        this.#microphone = microphone;
        microphone.startAt(seconds);
        return { name: microphone.name || 'Microphone', channels: microphone.deviceChannels };
    }

    close() {
        if (this.#player)
            this.#player.close();
        if (this.#microphone)
            this.#microphone.close();
        this.#player = null;
        this.#microphone = null;
        this.#sound = null;
        this.#isMuted = false;
        this.#hasStarted = false;
    }

    /**
     * Starts the sound where the browser allows it. A file that has not played starts at 0.
     * @param {number} seconds time of the picture
     */
    start(seconds) {
        if (this.#microphone) {
            this.#microphone.resume();
            this.#microphone.startAt(seconds);
        }
        // A promise that may never be kept: the browser can refuse sound before a click.
        if (this.#player)
            this.#player.start(this.#hasStarted ? seconds : 0).catch(() => undefined);
    }

    /**
     * @param {boolean} isPaused
     * @param {number} seconds time of the picture
     */
    setPaused(isPaused, seconds) {
        if (this.#isPaused === isPaused)
            return;
        this.#isPaused = isPaused;
        if (this.#player && !this.#isMuted)
            this.#player.setPaused(isPaused);
        if (!isPaused && !this.#hasStarted)
            this.start(seconds);
        else if (this.#microphone && !isPaused)
            this.#microphone.startAt(seconds);
    }

    /**
     * Stops the sound while the look draws another signal.
     * @param {boolean} isMuted
     */
    setMuted(isMuted) {
        if (this.#isMuted === isMuted)
            return;
        this.#isMuted = isMuted;
        if (this.#player)
            this.#player.setPaused(isMuted || this.#isPaused);
        if (this.#microphone && isMuted)
            this.close();
    }

    /** Starts again at time 0. */
    restart() {
        if (this.#player)
            this.#player.restart();
        if (this.#microphone)
            this.#microphone.startAt(0);
    }

    get hasSound() {
        return !this.#isMuted && (this.#player !== null || this.#microphone !== null);
    }

    /** Whether the browser waits for a click. */
    get needsClick() {
        if (this.#isMuted || this.#isPaused)
            return false;
        return (this.#player !== null && this.#player.needsClick)
            || (this.#microphone !== null && this.#microphone.needsClick);
    }

    /** A message about a device that stopped, or ''. */
    get problem() {
        return this.#microphone && this.#microphone.hasEnded
            ? 'The microphone stopped. Connect it, then open it again.' : '';
    }

    /** Whether it is a file that has not been heard yet. */
    get isNew() {
        return this.#player !== null && !this.#hasStarted;
    }

    /**
     * The time of the sound, which the picture follows. Null without a playing sound.
     * @returns {number|null} s
     */
    seconds() {
        if (this.#isMuted)
            return null;
        if (this.#microphone)
            return this.#microphone.needsClick ? null : this.#microphone.seconds();
        if (!this.#player || !(this.#player.isPlaying || this.#player.isStarting))
            return null;
        this.#hasStarted = this.#hasStarted || this.#player.isPlaying;
        return this.#player.seconds();
    }
}
