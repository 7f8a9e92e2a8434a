// Plays a sound. The clock of the audio device is the clock of the picture.
import { soundPart } from '../signals/audio_signal.js';
import { SmoothClock } from './smooth_clock.js';

const START_DELAY = 0.05; // s, so that the sound starts at a known time
const RESUME_SECONDS = 0.5; // time in which an allowed context starts
const PLAYED_CHANNELS = 2;
// Rates that each browser must support (Web Audio API, createBuffer). Others play by their speed.
const MIN_BUFFER_RATE = 8000;
const MAX_BUFFER_RATE = 96000;

/**
 * A context at the rate of the sound, so that the browser does not resample it.
 * @param {number} rate
 * @returns {AudioContext}
 */
function playingContext(rate) {
    try {
        return new AudioContext({ sampleRate: rate });
    } catch {
        return new AudioContext(); // the device lacks this rate
    }
}

/**
 * The time of the context that is heard now.
 * @param {AudioContext} context
 * @returns {number} in s
 */
function heardContextTime(context) {
    const stamp = context.getOutputTimestamp?.();
    if (stamp) {
        const then = stamp.performanceTime || performance.now(); // 0 before the first output
        const since = (performance.now() - then) / 1000;
        const heard = Math.min((stamp.contextTime ?? 0) + since, context.currentTime);
        if (context.currentTime - heard < 1) { // some browsers give wrong numbers
            return heard;
        }
    }
    return context.currentTime - (context.outputLatency || context.baseLatency || 0);
}

/** Plays the part of a sound that the settings of a signal of kind audio name. */
export class SoundPlayer {
    #sound;
    #part;
    #clock = new SmoothClock();
    /** @type {AudioContext | null} */
    #context = null;
    /** @type {AudioBuffer | null} */
    #buffer = null;
    /** @type {AudioBufferSourceNode | null} */
    #node = null;
    #startedAt = 0; // time of the context
    #startSeconds = 0; // time of the signal then
    #resumedAt = -Infinity; // time in ms
    #isPaused = false;

    /**
     * @param {import('./sound.js').Sound} sound
     * @param {import('../signals/signal.js').SignalSettings} settings
     */
    constructor(sound, settings) {
        this.#sound = sound;
        this.#part = soundPart(settings, sound);
    }

    /** Whether the browser waits for a click before it plays sound. */
    get needsClick() {
        return !this.#isPaused && !this.isStarting && this.#context?.state !== 'running';
    }

    /** Whether it was started just now, and the browser may allow it. */
    get isStarting() {
        const isResuming = performance.now() - this.#resumedAt < RESUME_SECONDS * 1000;
        return !this.#isPaused && isResuming && this.#context?.state !== 'running';
    }

    /** Whether the sound is audible, so that `seconds()` advances. */
    get isPlaying() {
        return !this.#isPaused && this.#context?.state === 'running';
    }

    /**
     * Starts the sound. Call it in the handler of a click, or earlier if the browser may allow it.
     * @param {number} [seconds] time of the signal at which the sound starts
     * @returns {Promise<void>} pending until the browser allows sound
     */
    async start(seconds = this.seconds()) {
        this.#context ??= playingContext(this.#sound.rate);
        this.seek(seconds);
        this.#resumedAt = performance.now();
        await (this.#isPaused ? this.#context.suspend() : this.#context.resume());
    }

    /**
     * The time of the signal that is heard now. It never goes back, except by seek() and restart().
     * After the end of a sound that does not loop it continues.
     * @returns {number} in s
     */
    seconds() {
        if (!this.#context || !this.isPlaying) {
            return this.#clock.seconds;
        }
        const played = heardContextTime(this.#context) - this.#startedAt;
        return this.#clock.follow(this.#startSeconds + played, performance.now() / 1000);
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        if (isPaused === this.#isPaused) {
            return;
        }
        this.#isPaused = isPaused;
        if (isPaused) {
            this.#context?.suspend();
        } else if (this.#context) {
            this.start(this.#clock.seconds);
        }
    }

    /** Starts again at time 0. */
    restart() {
        this.seek(0);
    }

    /**
     * Continues at another time of the signal.
     * @param {number} seconds
     */
    seek(seconds) {
        this.#clock.jump(seconds);
        this.#node?.stop();
        this.#node?.disconnect();
        this.#node = null;
        if (!this.#context) {
            return;
        }
        this.#startedAt = this.#context.currentTime + START_DELAY;
        this.#startSeconds = seconds;
        const buffer = this.#buffer ??= this.#makeBuffer();
        const position = seconds * this.#sound.rate / buffer.sampleRate;
        if (!this.#part.loops && position >= buffer.duration) {
            return;
        }
        this.#node = this.#context.createBufferSource();
        this.#node.buffer = buffer;
        this.#node.loop = this.#part.loops;
        this.#node.playbackRate.value = this.#sound.rate / buffer.sampleRate;
        this.#node.connect(this.#context.destination);
        this.#node.start(this.#startedAt, position % buffer.duration);
    }

    /** Ends the sound and frees the audio device. */
    close() {
        this.#node?.stop();
        this.#node = null;
        this.#context?.close();
        this.#context = null;
    }

    /**
     * The first two channels of the part.
     * @returns {AudioBuffer}
     */
    #makeBuffer() {
        const { first, end } = this.#part;
        const channels = this.#sound.channels.slice(0, PLAYED_CHANNELS)
            .map((samples) => samples.subarray(first, end > 0 ? end : samples.length));
        const buffer = new AudioBuffer({
            length: channels[0].length,
            numberOfChannels: channels.length,
            sampleRate: Math.min(Math.max(this.#sound.rate, MIN_BUFFER_RATE), MAX_BUFFER_RATE),
        });
        channels.forEach((samples, channel) => buffer.copyToChannel(samples, channel));
        return buffer;
    }
}
