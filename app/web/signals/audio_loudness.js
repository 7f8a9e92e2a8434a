// The loudness and beats of a sound, or the deflection of a beam, by time.
import { BeatDetector, BlockMemory } from './audio_beats.js';
import { SoundInput, completePlug } from './audio_input.js';
import { Beam, FLOATS_PER_POINT } from './beam.js';

const STRETCHES_PER_SECOND = 100;
const STRETCHES_IN_BLOCK = 100;
const STRETCHES_REMEMBERED = 4096;
const ENVELOPE_MEMORY = 12; // in time constants: older peaks contribute less than 6e-6
const PEAK_BLOCK = 512; // samples read at once

/**
 * The fraction of the difference that is covered in one stretch.
 * @param {number} timeConstant in s
 * @returns {number}
 */
function envelopePull(timeConstant) {
    return -Math.expm1(-1 / (STRETCHES_PER_SECOND * timeConstant));
}

/** The level after some stretches, for two time constants. */
class EnvelopeState {
    #up;
    #down;
    #before; // stretches of history
    #next = -1; // the stretch to process next
    #level = 0;

    /**
     * @param {number} attack in s
     * @param {number} release in s
     */
    constructor(attack, release) {
        this.attack = attack;
        this.release = release;
        this.#up = envelopePull(attack);
        this.#down = envelopePull(release);
        this.#before = Math.trunc(
            ENVELOPE_MEMORY * Math.max(attack, release) * STRETCHES_PER_SECOND);
    }

    /**
     * @param {number} end number of the stretch after the last one, at least 1
     * @param {BlockMemory} peaks by stretch
     * @returns {number}
     */
    levelAt(end, peaks) {
        const block = Math.floor((end - 1) / STRETCHES_IN_BLOCK);
        const isNear = this.#next > 0 && this.#next <= end
            && Math.floor((this.#next - 1) / STRETCHES_IN_BLOCK) === block;
        if (!isNear) {
            this.#next = Math.max(block * STRETCHES_IN_BLOCK - this.#before, 0);
            this.#level = 0;
        }
        for (; this.#next < end; this.#next++) {
            const way = peaks.at(this.#next) - this.#level;
            this.#level += way * (way > 0 ? this.#up : this.#down);
        }
        return this.#level;
    }
}

/**
 * Envelope followers in stretches of 10 ms. Each second they restart from silence, far enough
 * back. The result depends on previous peaks only, not on the division into frames.
 */
class Envelopes {
    #peaks;
    /** @type {EnvelopeState[]} */
    #states = [];

    /** @param {(stretch: number) => number} peak of the stretch n to n + 1 in 1/100 s */
    constructor(peak) {
        this.#peaks = new BlockMemory(peak, STRETCHES_REMEMBERED);
    }

    /**
     * The level after the last complete stretch.
     * @param {number} seconds
     * @param {number} attack in s
     * @param {number} release in s
     * @returns {number}
     */
    at(seconds, attack, release) {
        const end = Math.floor(seconds * STRETCHES_PER_SECOND + 1e-6);
        if (end <= 0) {
            return 0;
        }
        let state = this.#states.find((one) => one.attack === attack && one.release === release);
        if (!state) {
            state = new EnvelopeState(attack, release);
            this.#states.push(state);
        }
        return state.levelAt(end, this.#peaks);
    }
}

/** The loudness of a sound and its beats. */
export class SoundLoudness {
    #stream;
    #envelopes = new Envelopes((stretch) => this.#peakOf(stretch));
    #block = new Float32Array(2 * PEAK_BLOCK);
    /** @type {Map<number, BeatDetector>} */
    #beats = new Map();

    /** @param {import('./audio_stream.js').SampleStream} stream */
    constructor(stream) {
        this.#stream = stream;
    }

    /**
     * The largest sample of a stretch.
     * @param {number} stretch
     * @returns {number}
     */
    #peakOf(stretch) {
        const { rate } = this.#stream;
        const block = this.#block;
        const end = Math.floor((stretch + 1) / STRETCHES_PER_SECOND * rate + 1e-6);
        let peak = 0;
        for (let first = Math.floor(stretch / STRETCHES_PER_SECOND * rate + 1e-6); first < end;) {
            const count = Math.min(end - first, PEAK_BLOCK);
            this.#stream.read(first, count, block);
            for (let i = 0; i < 2 * count; i++) {
                peak = Math.max(peak, Math.abs(block[i]));
            }
            first += count;
        }
        return peak;
    }

    /**
     * The level that follows the peaks.
     * @param {number} seconds
     * @param {number} attack time constant in s
     * @param {number} release time constant in s
     * @returns {number} 0..1 for full scale
     */
    envelope(seconds, attack, release) {
        return this.#envelopes.at(seconds, attack, release);
    }

    /**
     * @param {number} seconds
     * @param {number} threshold energy of a beat relative to the mean
     * @returns {number | null} in s; null if it was more than 2 s ago
     */
    secondsSinceBeat(seconds, threshold) {
        let detector = this.#beats.get(threshold);
        if (!detector) {
            const plug = completePlug({ channels: 'mean' });
            detector = new BeatDetector(new SoundInput(this.#stream, plug), threshold);
            this.#beats.set(threshold, detector);
        }
        const beat = detector.lastBeat(seconds);
        return beat === null ? null : seconds - beat;
    }
}

/** For signals other than sound: the deflection of the beam. It has no beats. */
export class BeamLoudness {
    #signal;
    #beam = new Beam();
    #envelopes = new Envelopes((stretch) => this.#peakOf(stretch));

    /** @param {import('./signal.js').Signal} signal */
    constructor(signal) {
        this.#signal = signal;
    }

    /**
     * The largest coordinate of visible points in a stretch.
     * @param {number} stretch
     * @returns {number}
     */
    #peakOf(stretch) {
        const beam = this.#beam;
        beam.clear();
        this.#signal.trace(stretch / STRETCHES_PER_SECOND, (stretch + 1) / STRETCHES_PER_SECOND,
            beam);
        const { points } = beam;
        let peak = 0;
        for (let at = 0; at < FLOATS_PER_POINT * beam.count; at += FLOATS_PER_POINT) {
            if (points[at + 2] > 0) {
                peak = Math.max(peak, Math.abs(points[at]), Math.abs(points[at + 1]));
            }
        }
        return peak;
    }

    /**
     * The level that follows the peaks.
     * @param {number} seconds
     * @param {number} attack time constant in s
     * @param {number} release time constant in s
     * @returns {number}
     */
    envelope(seconds, attack, release) {
        return this.#envelopes.at(seconds, attack, release);
    }

    /** @returns {null} */
    secondsSinceBeat() {
        return null;
    }
}
