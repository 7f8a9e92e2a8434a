// Decodes sound files.
import { soundFileRate } from './sound_rate.js';
import { isWav, readWav } from './wav.js';

/**
 * A sound in memory. `rate` is in samples per second and `seconds` is its duration.
 * Each channel has the same number of samples, nominally -1 to 1.
 * @typedef {{rate: number, channels: Float32Array[], seconds: number}} Sound
 */

const FALLBACK_RATE = 48000; // samples per second
const LARGEST_SAMPLE = 1000; // a float file can contain any value

/**
 * Replaces NaN by 0, and limits samples far beyond full scale.
 * @param {Float32Array} samples
 */
function limitSamples(samples) {
    for (let i = 0; i < samples.length; i++) {
        if (!(Math.abs(samples[i]) <= LARGEST_SAMPLE)) {
            samples[i] = Math.min(Math.max(samples[i] || 0, -LARGEST_SAMPLE), LARGEST_SAMPLE);
        }
    }
}

/**
 * A context at the sound's own rate, so that the browser does not resample it.
 * @param {number} rate
 * @returns {OfflineAudioContext}
 */
function decodingContext(rate) {
    try {
        return new OfflineAudioContext(1, 1, rate);
    } catch {
        return new OfflineAudioContext(1, 1, FALLBACK_RATE); // the browser lacks this rate
    }
}

/**
 * Decodes a compressed file by the browser.
 * @param {ArrayBuffer} bytes
 * @returns {Promise<Sound>}
 */
async function decodeInBrowser(bytes) {
    const context = decodingContext(soundFileRate(new Uint8Array(bytes)) ?? FALLBACK_RATE);
    let decoded;
    try {
        decoded = await context.decodeAudioData(bytes.slice(0)); // it detaches its argument
    } catch {
        throw new Error('This browser can\'t read the sound. Use a WAV, FLAC, OGG or MP3 file.');
    }
    const channels = [];
    for (let channel = 0; channel < decoded.numberOfChannels; channel++) {
        channels.push(decoded.getChannelData(channel));
    }
    return { rate: decoded.sampleRate, channels, seconds: decoded.duration };
}

/**
 * Decodes a sound file without mixing. Only compressed sound at a rate that the browser lacks is
 * resampled. A truncated file gives what it has.
 * @param {ArrayBuffer} bytes
 * @returns {Promise<Sound>}
 */
export async function decodeSound(bytes) {
    if (bytes.byteLength === 0) {
        throw new Error('The sound file is empty. Use another file.');
    }
    try {
        const wav = isWav(bytes) ? readWav(bytes) : null;
        const sound = wav ?? await decodeInBrowser(bytes);
        if (sound.channels.length === 0 || sound.channels[0].length === 0) {
            throw new Error('The file has a header but no sound data. Use another file.');
        }
        sound.channels.forEach(limitSamples);
        return sound;
    } catch (error) {
        if (error instanceof RangeError) {
            throw new Error('There is not enough memory for this sound. Use a shorter one.');
        }
        throw error;
    }
}
