// Reads WAV files with PCM or float samples, with the numbers that libsndfile gives.
import { hasText } from './sound_rate.js';

const CHUNK_HEAD_SIZE = 8; // name and length
const WAV_PCM = 1;
const WAV_FLOAT = 3;
const WAV_EXTENSIBLE = 0xfffe;
const UNKNOWN_LENGTH = 0xffffffff; // of a stream, or of RF64
const MAX_CHANNELS = 32;
const MAX_RATE = 768000; // samples per second

/**
 * @typedef {{tag: number, channels: number, rate: number, bytesPerSample: number}} WavFormat
 */

/**
 * Positions in bytes.
 * @typedef {{format: number | null, data: number | null, dataEnd: number}} WavChunks
 */

/**
 * Whether a file is RIFF or RF64 with the type WAVE.
 * @param {ArrayBuffer} bytes
 * @returns {boolean}
 */
export function isWav(bytes) {
    const start = new Uint8Array(bytes, 0, Math.min(bytes.byteLength, 12));
    return (hasText(start, 0, 'RIFF') || hasText(start, 0, 'RF64')) && hasText(start, 8, 'WAVE');
}

/**
 * Finds the format and the data. A file that was not finished has the data length 0 or the
 * largest number, and sound without further chunks follows.
 * @param {DataView} file
 * @returns {WavChunks}
 */
function findChunks(file) {
    const bytes = new Uint8Array(file.buffer);
    /** @type {WavChunks} */
    const chunks = { format: null, data: null, dataEnd: 0 };
    let at = 12;
    while (at + CHUNK_HEAD_SIZE <= bytes.length) {
        const length = file.getUint32(at + 4, true);
        if (chunks.format === null && hasText(bytes, at, 'fmt ')) {
            chunks.format = at + CHUNK_HEAD_SIZE;
        }
        if (chunks.data === null && hasText(bytes, at, 'data')) {
            chunks.data = at + CHUNK_HEAD_SIZE;
            chunks.dataEnd = length === UNKNOWN_LENGTH ? bytes.length : chunks.data + length;
        }
        at += CHUNK_HEAD_SIZE + length + length % 2;
    }
    const isUnfinished = chunks.data === chunks.dataEnd && at !== bytes.length;
    chunks.dataEnd = isUnfinished ? bytes.length : Math.min(chunks.dataEnd, bytes.length);
    return chunks;
}

/**
 * @param {DataView} file
 * @param {number} at place of the format
 * @returns {WavFormat}
 */
function readFormat(file, at) {
    const tag = file.getUint16(at, true);
    const isExtended = tag === WAV_EXTENSIBLE && at + 26 <= file.byteLength;
    const format = {
        // The extensible format has its tag in the first bytes of a GUID.
        tag: isExtended ? file.getUint16(at + 24, true) : tag,
        channels: file.getUint16(at + 2, true),
        rate: file.getUint32(at + 4, true),
        bytesPerSample: Math.ceil(file.getUint16(at + 14, true) / 8),
    };
    if (format.rate < 1 || format.rate > MAX_RATE) {
        throw new Error(`The sample rate must be between 1 and ${MAX_RATE} Hz, ` +
            `got ${format.rate} Hz. Convert the file.`);
    }
    if (format.channels < 1 || format.channels > MAX_CHANNELS) {
        throw new Error(`The number of channels must be between 1 and ${MAX_CHANNELS}, ` +
            `got ${format.channels}. Convert the file.`);
    }
    return format;
}

/**
 * Reads a sample at a position. Full scale is 1.
 * @param {DataView} file
 * @param {WavFormat} format
 * @returns {((at: number) => number) | null} null for other formats
 */
function sampleReader(file, format) {
    const readers = {
        [`${WAV_PCM} 1`]: (/** @type {number} */ at) => (file.getUint8(at) - 128) / 0x80,
        [`${WAV_PCM} 2`]: (/** @type {number} */ at) => file.getInt16(at, true) / 0x8000,
        [`${WAV_PCM} 3`]: (/** @type {number} */ at) =>
            (file.getUint8(at) + 256 * file.getInt16(at + 1, true)) / 0x800000,
        [`${WAV_PCM} 4`]: (/** @type {number} */ at) => file.getInt32(at, true) / 0x80000000,
        [`${WAV_FLOAT} 4`]: (/** @type {number} */ at) => file.getFloat32(at, true),
        [`${WAV_FLOAT} 8`]: (/** @type {number} */ at) => file.getFloat64(at, true),
    };
    return readers[`${format.tag} ${format.bytesPerSample}`] ?? null;
}

/**
 * Reads a WAV file as far as it goes.
 * @param {ArrayBuffer} bytes
 * @returns {import('./sound.js').Sound | null} null for samples that are neither PCM nor floats
 */
export function readWav(bytes) {
    const file = new DataView(bytes);
    const chunks = findChunks(file);
    if (chunks.format === null || chunks.format + 16 > bytes.byteLength || chunks.data === null) {
        throw new Error('The WAV file is damaged: it has no format or no sound. Use another file.');
    }
    const format = readFormat(file, chunks.format);
    const read = sampleReader(file, format);
    if (!read) {
        return null;
    }
    const frameSize = format.channels * format.bytesPerSample;
    const frames = Math.floor((chunks.dataEnd - chunks.data) / frameSize);
    const channels = [];
    for (let channel = 0; channel < format.channels; channel++) {
        const samples = new Float32Array(frames);
        let at = chunks.data + channel * format.bytesPerSample;
        for (let i = 0; i < frames; i++, at += frameSize) {
            samples[i] = read(at);
        }
        channels.push(samples);
    }
    return { rate: format.rate, channels, seconds: frames / format.rate };
}
