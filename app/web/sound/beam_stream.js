// A beam as sound, for sound textures of signals without sound.
import { ENDLESS_SAMPLES } from '../signals/audio_stream.js';
import { Beam } from '../signals/beam.js';
import { linearBetween } from '../signals/sine.js';

const BEAM_STREAM_RATE = 48000; // samples per second
const STREAM_BLOCKS_PER_SECOND = 60;
const SAMPLES_PER_STREAM_BLOCK = BEAM_STREAM_RATE / STREAM_BLOCKS_PER_SECOND;
const STREAM_BLOCKS_KEPT = 32;
const BEAM_INSTANT_SLACK = 1e-10; // s, for instants computed in two ways

/**
 * Samples the position of the beam in a block, with linear interpolation between points.
 * The beam comes from the block before and goes to the block after it.
 * @param {import('../signals/signal.js').Signal} signal
 * @param {number} number of the block
 * @param {Beam} beam is overwritten
 * @returns {Float32Array} x and y pairs
 */
function sampledBlock(signal, number, beam) {
    const step = 1 / BEAM_STREAM_RATE;
    const samples = new Float32Array(3 * 2 * SAMPLES_PER_STREAM_BLOCK);
    let sampled = (number - 1) / STREAM_BLOCKS_PER_SECOND - step;
    let lastTime = sampled;
    let [lastX, lastY, at] = [0, 0, 0];
    for (let near = number - 1; near <= number + 1; near++) {
        const end = (near + 1) / STREAM_BLOCKS_PER_SECOND;
        beam.clear();
        signal.trace(near / STREAM_BLOCKS_PER_SECOND, end, beam);
        for (let i = 0; i < 4 * beam.count; i += 4) {
            const [x, y, time] = [beam.points[i], beam.points[i + 1], end - beam.points[i + 3]];
            const span = time - lastTime;
            for (; sampled + step <= time + BEAM_INSTANT_SLACK; at += 2) {
                sampled += step;
                const share = span > 0 ? (sampled - lastTime) / span : 1;
                samples[at] = linearBetween(lastX, x, share);
                samples[at + 1] = linearBetween(lastY, y, share);
            }
            [lastTime, lastX, lastY] = [time, x, y];
        }
    }
    for (; at < samples.length; at += 2) { // the beam rests
        samples[at] = lastX;
        samples[at + 1] = lastY;
    }
    return samples.slice(2 * SAMPLES_PER_STREAM_BLOCK, 4 * SAMPLES_PER_STREAM_BLOCK);
}

/**
 * A signal as a stream: left is x and right is y, at 48 kHz.
 * @param {import('../signals/signal.js').Signal} signal
 * @returns {import('../signals/audio_stream.js').SampleStream}
 */
export function beamStream(signal) {
    const beam = new Beam();
    /** @type {Map<number, Float32Array>} */
    const blocks = new Map();
    const blockAt = (/** @type {number} */ number) => {
        let block = blocks.get(number);
        if (!block) {
            if (blocks.size >= STREAM_BLOCKS_KEPT) {
                blocks.clear();
            }
            block = sampledBlock(signal, number, beam);
            blocks.set(number, block);
        }
        return block;
    };
    /** @type {import('../signals/audio_stream.js').SampleStream['read']} */
    const read = (first, count, target) => {
        for (let i = 0; i < count; i++) {
            const sample = first + i;
            const number = Math.floor(sample / SAMPLES_PER_STREAM_BLOCK);
            const at = 2 * (sample - number * SAMPLES_PER_STREAM_BLOCK);
            const block = sample >= 0 ? blockAt(number) : null;
            target[2 * i] = block ? block[at] : 0;
            target[2 * i + 1] = block ? block[at + 1] : 0;
        }
    };
    return { rate: BEAM_STREAM_RATE, length: ENDLESS_SAMPLES, loops: false, isLive: false, read };
}
