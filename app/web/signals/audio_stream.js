// Stereo samples by number: the input of everything that draws a sound.

/** The length of a stream without an end, in samples. */
export const ENDLESS_SAMPLES = 2 ** 47;

const LIVE_BLOCK = 1024; // samples read from a live sound at once

/**
 * Stereo samples by number, from 0.
 *
 * `rate` is in samples per second, `length` in samples. A stream that `loops` repeats after its
 * length; otherwise both sides are silent.
 * `read` writes left and right of `count` samples from `first` on. `first` may be any number.
 * @typedef {{
 *   rate: number,
 *   length: number,
 *   loops: boolean,
 *   isLive: boolean,
 *   read: (first: number, count: number, target: Float32Array) => void
 * }} SampleStream
 */

/**
 * The part of a sound to read, in samples. The sample `end` is after the last one.
 * An `end` of 0 is the end of the sound.
 * @typedef {{first: number, end: number, loops: boolean}} SoundPart
 */

/**
 * Sound that arrives in real time.
 *
 * `count` is the number of samples received so far, `first` the number of the sample at time 0.
 * `read` writes samples first to end - 1 of a channel, from 0. Samples that are not there are 0.
 * @typedef {{
 *   rate: number,
 *   channels: number,
 *   count: number,
 *   first: number,
 *   read: (first: number, end: number, channel: number, target: Float32Array) => void
 * }} LiveSound
 */

/**
 * Index of a channel. Numbers above the last channel mean the last one, so mono is on both sides.
 * @param {number} channel from 1; 0 is silence
 * @param {number} count
 * @returns {number} from 0; -1 is silence
 */
function channelIndex(channel, count) {
    return Math.min(channel, count) - 1;
}

/**
 * The number of seconds as a whole number of samples.
 * @param {number} seconds at least 0
 * @param {number} rate
 * @returns {number}
 */
export function wholeSamples(seconds, rate) {
    return Math.floor(seconds * rate + 0.5);
}

/**
 * A sound in memory.
 * @param {import('../sound/sound.js').Sound} sound with a sample from part.first on
 * @param {SoundPart} part
 * @param {number} left channel from 1; 0 is silence
 * @param {number} right
 * @returns {SampleStream}
 */
export function soundStream(sound, part, left = 1, right = 2) {
    const frames = sound.channels[0].length;
    const length = (part.end > 0 ? Math.min(part.end, frames) : frames) - part.first;
    const lefts = sound.channels[channelIndex(left, sound.channels.length)] ?? null;
    const rights = sound.channels[channelIndex(right, sound.channels.length)] ?? null;
    /** @type {SampleStream['read']} */
    const read = (first, count, target) => {
        let index = part.loops ? ((first % length) + length) % length : first;
        for (let at = 0; at < 2 * count; at += 2) {
            const isInside = index >= 0 && index < length;
            target[at] = isInside && lefts ? lefts[part.first + index] : 0;
            target[at + 1] = isInside && rights ? rights[part.first + index] : 0;
            index++;
            if (part.loops && index === length) {
                index = 0;
            }
        }
    };
    return { rate: sound.rate, length, loops: part.loops, isLive: false, read };
}

/**
 * A live sound. Its sample 0 is the one at time 0.
 * @param {LiveSound} sound
 * @param {number} left channel from 1; 0 is silence
 * @param {number} right
 * @returns {SampleStream}
 */
export function liveStream(sound, left = 1, right = 2) {
    const origin = sound.first;
    const block = new Float32Array(LIVE_BLOCK);
    const sides = [channelIndex(left, sound.channels), channelIndex(right, sound.channels)];
    /** @type {SampleStream['read']} */
    const read = (first, count, target) => {
        for (let done = 0; done < count; done += LIVE_BLOCK) {
            const some = Math.min(count - done, LIVE_BLOCK);
            const start = origin + first + done;
            for (let side = 0; side < 2; side++) {
                if (sides[side] < 0) {
                    block.fill(0);
                } else {
                    sound.read(start, start + some, sides[side], block);
                }
                for (let i = 0; i < some; i++) {
                    target[2 * (done + i) + side] = block[i];
                }
            }
        }
    };
    return { rate: sound.rate, length: ENDLESS_SAMPLES, loops: false, isLive: true, read };
}
