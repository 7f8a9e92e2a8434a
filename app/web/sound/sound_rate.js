// Finds the sample rate in the header of FLAC, OGG and MP3 files.

const ID3_HEADER_SIZE = 10;
const OPUS_RATE = 48000; // Opus always decodes at this rate
// ISO/IEC 11172-3: rates of MPEG-1. MPEG-2 has half and MPEG-2.5 a quarter of them.
const MPEG_RATES = [44100, 48000, 32000];

/**
 * @param {Uint8Array} bytes
 * @param {number} at
 * @param {string} text in ASCII
 * @returns {boolean} whether the bytes at this place are the text
 */
export function hasText(bytes, at, text) {
    for (let i = 0; i < text.length; i++) {
        if (bytes[at + i] !== text.charCodeAt(i)) {
            return false;
        }
    }
    return true;
}

/**
 * The number of bytes before the sound: tags of ID3 version 2 (id3.org, "ID3 tag version 2.4.0").
 * @param {Uint8Array} bytes
 * @returns {number}
 */
function afterId3(bytes) {
    let at = 0;
    while (hasText(bytes, at, 'ID3') && at + ID3_HEADER_SIZE <= bytes.length) {
        const [a, b, c, d] = bytes.subarray(at + 6, at + ID3_HEADER_SIZE);
        at += ID3_HEADER_SIZE + ((a & 127) << 21 | (b & 127) << 14 | (c & 127) << 7 | (d & 127));
    }
    return at;
}

/**
 * The rate of a FLAC stream: 20 bits of its first block, STREAMINFO (RFC 9639).
 * @param {Uint8Array} bytes
 * @param {number} at place of 'fLaC'
 * @returns {number}
 */
function flacRate(bytes, at) {
    return bytes[at + 18] << 12 | bytes[at + 19] << 4 | bytes[at + 20] >> 4;
}

/**
 * The rate of the first packet of an OGG file (RFC 3533) with Vorbis, Opus or FLAC.
 * @param {Uint8Array} bytes
 * @returns {number | null}
 */
function oggRate(bytes) {
    const packet = 27 + bytes[26];
    if (hasText(bytes, packet, '\x01vorbis')) {
        return new DataView(bytes.buffer, bytes.byteOffset).getUint32(packet + 12, true);
    }
    if (hasText(bytes, packet, 'OpusHead')) {
        return OPUS_RATE;
    }
    return hasText(bytes, packet, '\x7fFLAC') ? flacRate(bytes, packet + 9) : null;
}

/**
 * The rate of an MPEG frame.
 * @param {Uint8Array} bytes
 * @param {number} at
 * @returns {number | null} null without a valid frame header
 */
function mpegRate(bytes, at) {
    const version = bytes[at + 1] >> 3 & 3; // 0: 2.5, 2: 2, 3: 1
    const layer = bytes[at + 1] >> 1 & 3;
    const bitRate = bytes[at + 2] >> 4;
    const rate = MPEG_RATES[bytes[at + 2] >> 2 & 3];
    const isFrame = bytes[at] === 255 && bytes[at + 1] >= 224 && version !== 1 && layer !== 0 &&
        bitRate !== 15 && rate !== undefined;
    return isFrame ? rate / (version === 3 ? 1 : version === 2 ? 2 : 4) : null;
}

/**
 * The sample rate that the header of a sound file states.
 * @param {Uint8Array} bytes
 * @returns {number | null} null for other files
 */
export function soundFileRate(bytes) {
    const start = afterId3(bytes);
    let rate = null;
    if (hasText(bytes, start, 'fLaC')) {
        rate = flacRate(bytes, start);
    } else if (hasText(bytes, start, 'OggS')) {
        rate = oggRate(bytes);
    } else {
        const frame = bytes.findIndex((byte, at) => at >= start && byte !== 0); // after padding
        rate = mpegRate(bytes, frame);
    }
    return rate || null;
}
