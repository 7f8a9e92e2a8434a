// Live sound of a microphone or another audio input.
import { SmoothClock } from './smooth_clock.js';

const SECONDS_KEPT = 16;
const LOOK_AHEAD = 0.025; // s; a trigger looks ahead, and two traces alternate every 1/60 s
const INPUT_CUSHION = 0.02; // s; devices deliver samples in bursts
const PROCESSOR_SIZE = 1024; // samples, of the fallback
// Posts the samples of each block, one array per channel. A blob: URL is refused on file: pages.
const CAPTURE_WORKLET = `registerProcessor('live-sound', class extends AudioWorkletProcessor {
    process([input]) {
        const channels = input.length > 0 ? input : [new Float32Array(128)];
        this.port.postMessage(channels.map((samples) => samples.slice()));
        return true;
    }
});`;

/** The latest seconds of a live sound: the LiveSound that signals draw. */
export class SoundRing {
    /** Number of samples received. */
    count = 0;
    /** Number of the sample at time 0 of the signal. */
    first = 0;
    #samples;

    /**
     * @param {number} rate samples per second
     * @param {number} channels
     */
    constructor(rate, channels) {
        this.rate = rate;
        this.channels = channels;
        this.#samples = Array.from({ length: channels }, () =>
            new Float32Array(SECONDS_KEPT * rate));
    }

    /**
     * Appends samples. Missing channels repeat the last one.
     * @param {Float32Array[]} channels
     */
    write(channels) {
        const size = this.#samples[0].length;
        const length = channels[0].length;
        this.#samples.forEach((ring, index) => {
            const samples = channels[Math.min(index, channels.length - 1)];
            for (let i = 0; i < length; i++) {
                ring[(this.count + i) % size] = samples[i];
            }
        });
        this.count += length;
    }

    /**
     * Writes samples first to end - 1 of a channel. Those that are not kept are 0.
     * @param {number} first
     * @param {number} end
     * @param {number} channel from 0
     * @param {Float32Array} target
     */
    read(first, end, channel, target) {
        const ring = this.#samples[channel];
        const oldest = Math.max(this.count - ring.length, 0);
        for (let i = first; i < end; i++) {
            const isKept = i >= oldest && i < this.count;
            target[i - first] = isKept ? ring[i % ring.length] : 0;
        }
    }
}

/** An open audio input. */
export class Microphone {
    #context;
    #stream;
    #clock = new SmoothClock();
    #received = 0; // time in s

    /**
     * Use openMicrophone().
     * @param {AudioContext} context
     * @param {MediaStream} stream
     * @param {number} channels
     */
    constructor(context, stream, channels) {
        this.#context = context;
        this.#stream = stream;
        this.sound = new SoundRing(context.sampleRate, channels);
    }

    /** The name of the device. */
    get name() {
        return this.#stream.getAudioTracks()[0]?.label ?? '';
    }

    /** The number of channels of the device, where the browser reports it. */
    get deviceChannels() {
        /** @type {MediaTrackSettings & {channelCount?: number}} */
        const settings = this.#stream.getAudioTracks()[0]?.getSettings() ?? {};
        return settings.channelCount ?? 2;
    }

    /** Whether the device was disconnected or the permission was withdrawn. */
    get hasEnded() {
        return this.#stream.getAudioTracks().every((track) => track.readyState === 'ended');
    }

    /** Whether the browser waits for a click before it opens the input. */
    get needsClick() {
        return this.#context.state !== 'running';
    }

    /** Continues in the handler of a click. */
    resume() {
        this.#context.resume();
    }

    /**
     * Adds samples from the device.
     * @param {Float32Array[]} channels
     */
    receive(channels) {
        this.sound.write(channels);
        this.#received = performance.now() / 1000;
    }

    /**
     * The time of the signal up to which the sound can be drawn. It never goes back.
     * @returns {number} in s
     */
    seconds() {
        const now = performance.now() / 1000;
        const complete = this.sound.count / this.sound.rate - LOOK_AHEAD;
        const position = complete - INPUT_CUSHION + now - this.#received;
        const smooth = this.#clock.follow(Math.min(position, complete), now);
        return Math.min(smooth, complete) - this.sound.first / this.sound.rate;
    }

    /**
     * Maps the present sound to a time of the signal. Make the signal again after this.
     * @param {number} seconds
     */
    startAt(seconds) {
        this.sound.first += Math.round((this.seconds() - seconds) * this.sound.rate);
    }

    /** Closes the device. */
    close() {
        this.#stream.getTracks().forEach((track) => track.stop());
        this.#context.close();
    }

    /** @returns {Promise<void>} */
    async connect() {
        const source = this.#context.createMediaStreamSource(this.#stream);
        const node = await this.#captureNode();
        source.connect(node);
        node.connect(this.#context.destination); // silent, but unconnected nodes may not run
        this.#context.resume();
    }

    /** @returns {Promise<AudioNode>} */
    async #captureNode() {
        try {
            const url = `data:text/javascript,${encodeURIComponent(CAPTURE_WORKLET)}`;
            await this.#context.audioWorklet.addModule(url);
            const node = new AudioWorkletNode(this.#context, 'live-sound');
            node.port.onmessage = (event) => this.receive(event.data);
            return node;
        } catch {
            const channels = this.sound.channels;
            const node = this.#context.createScriptProcessor(PROCESSOR_SIZE, channels, 1);
            node.onaudioprocess = (event) => this.receive(Array.from({ length: channels },
                (_, channel) => event.inputBuffer.getChannelData(channel)));
            return node;
        }
    }
}

/**
 * What to do about a refused input.
 * @param {unknown} error of getUserMedia()
 * @returns {string}
 */
function microphoneMessage(error) {
    const name = error instanceof Error ? error.name : '';
    if (name === 'NotAllowedError' || name === 'SecurityError') {
        return 'The browser refused the microphone. Allow it in the site settings, then try again.';
    }
    if (name === 'NotFoundError' || name === 'OverconstrainedError') {
        return 'No microphone was found. Connect one, then try again.';
    }
    if (name === 'NotReadableError' || name === 'AbortError') {
        return 'The microphone can\'t be opened. Close other programs that use it, then try again.';
    }
    return `The microphone can't be opened: ${error}. Try another browser.`;
}

/**
 * Opens the audio input of the user's choice, without processing.
 * Call it in the handler of a click.
 * @param {number} [channels]
 * @returns {Promise<Microphone>}
 */
export async function openMicrophone(channels = 2) {
    if (!navigator.mediaDevices?.getUserMedia) {
        throw new Error('This page can\'t use the microphone. Open it from a file or by https.');
    }
    const context = new AudioContext();
    /** @type {MediaStream | null} */
    let stream = null;
    try {
        stream = await navigator.mediaDevices.getUserMedia({ audio: {
            channelCount: { ideal: channels },
            echoCancellation: false,
            noiseSuppression: false,
            autoGainControl: false,
        } });
        const microphone = new Microphone(context, stream, Math.max(channels, 2));
        await microphone.connect();
        return microphone;
    } catch (error) {
        stream?.getTracks().forEach((track) => track.stop());
        context.close();
        throw new Error(microphoneMessage(error));
    }
}
