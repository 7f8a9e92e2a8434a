// Decoding of sound files.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { decodeSound } from '../../app/web/sound/sound.js';
import { bufferOf, wavFile } from './sound_files.mjs';

const words = [-32768, -1, 0, 1, 16384, 32767];
const wordBytes = Buffer.from(Int16Array.from(words).buffer);
const wordLevels = words.map((word) => word / 32768);

async function channelsOf(bytes) {
    return (await decodeSound(bufferOf(bytes))).channels.map((samples) => [...samples]);
}

test('PCM of each size is divided by full scale, and floats are kept', async () => {
    const cases = [
        [1, 8, Buffer.from([0, 127, 128, 255]), [-1, -1 / 128, 0, 127 / 128]],
        [1, 16, wordBytes, wordLevels],
        [1, 24, Buffer.from('000080ffffff010000ffff7f', 'hex'),
            [-1, -(2 ** -23), 2 ** -23, 1 - 2 ** -23]],
        [1, 32, Buffer.from(Int32Array.from([-(2 ** 31), 2 ** 30, 257]).buffer),
            [-1, 0.5, 257 / 2 ** 31]],
        [3, 32, Buffer.from(Float32Array.from([1.5, -0.1, NaN, 1e9]).buffer),
            [1.5, Math.fround(-0.1), 0, 1000]],
        [3, 64, Buffer.from(Float64Array.from([0.1, -2, -Infinity]).buffer),
            [Math.fround(0.1), -2, -1000]],
    ];
    for (const [tag, bits, samples, levels] of cases) {
        for (const isExtensible of [false, true]) {
            const bytes = wavFile({ tag, bits, samples, isExtensible });
            assert.deepEqual(await channelsOf(bytes), [levels], `${tag} ${bits}`);
        }
    }
});

test('channels, rate and length are those of the header; other chunks are skipped', async () => {
    const samples = Buffer.from(Int16Array.from({ length: 96 }, (_, i) => i * 100).buffer);
    const other = Buffer.concat([Buffer.from('LIST\x05\x00\x00\x00', 'latin1'), Buffer.alloc(6)]);
    const sound = await decodeSound(bufferOf(wavFile({ bits: 16, rate: 6000, channels: 32, samples,
        before: other, after: other })));
    assert.equal(sound.rate, 6000);
    assert.equal(sound.seconds, 3 / 6000);
    assert.equal(sound.channels.length, 32);
    sound.channels.forEach((levels, channel) => assert.deepEqual([...levels],
        [0, 1, 2].map((frame) => (frame * 32 + channel) * 100 / 32768)));
});

test('a truncated file is read as far as it goes', async () => {
    const whole = wavFile({ bits: 16, channels: 2, samples: wordBytes });
    const cut = whole.subarray(0, whole.length - 3);
    assert.deepEqual(await channelsOf(cut), [[-1, 0], [-1 / 32768, 1 / 32768]]);
});

test('a recording without a length in its header is read to the end', async () => {
    for (const length of [0, 0xffffffff]) {
        const bytes = wavFile({ bits: 16, samples: wordBytes });
        bytes.writeUInt32LE(length, bytes.length - wordBytes.length - 4);
        assert.deepEqual(await channelsOf(bytes), [wordLevels]);
    }
});

test('an empty, broken or silent file is an error that says what to do', async () => {
    const refusal = (bytes) =>
        decodeSound(bufferOf(bytes)).then(() => '', (error) => error.message);
    const whole = wavFile({ bits: 16, samples: wordBytes });
    assert.match(await refusal(Buffer.alloc(0)), /is empty\. Use/);
    for (const length of [12, 20, 36, 43]) {
        assert.match(await refusal(whole.subarray(0, length)), /damaged.*\. Use/, `${length}`);
    }
    assert.match(await refusal(wavFile({ bits: 16, samples: Buffer.alloc(0) })), /no sound data/);
    assert.match(await refusal(wavFile({ bits: 16, channels: 33, samples: wordBytes })),
        /between 1 and 32, got 33\. Convert/);
    assert.match(await refusal(wavFile({ bits: 16, rate: 1000000, samples: wordBytes })),
        /got 1000000 Hz\. Convert/);
});

// Headers of other formats, as their specifications define them.
function flacStart(rate) {
    const bytes = Buffer.alloc(42);
    bytes.write('fLaC\x00\x00\x00\x22', 'latin1');
    bytes.writeUInt32BE(rate * 4096 + 0x1f0, 18); // rate, 2 channels of 16 bits
    return bytes;
}

function oggPage(packet) {
    const head = Buffer.alloc(28);
    head.write('OggS');
    head[26] = 1;
    head[27] = packet.length;
    return Buffer.concat([head, packet]);
}

function vorbisPacket(rate) {
    const packet = Buffer.alloc(30);
    packet.write('\x01vorbis', 'latin1');
    packet.writeUInt32LE(rate, 12);
    return packet;
}

test('compressed sound is decoded at the rate of its header', async (t) => {
    const rates = [];
    globalThis.OfflineAudioContext = class {
        constructor(channels, frames, rate) {
            if (rate > 192000) {
                throw new RangeError('not supported');
            }
            this.rate = rate;
        }

        async decodeAudioData(bytes) {
            if (new Uint8Array(bytes)[0] === 0x6e) {
                throw new DOMException('unable to decode', 'EncodingError');
            }
            rates.push(this.rate);
            return { numberOfChannels: 1, sampleRate: this.rate, duration: 2 / this.rate,
                getChannelData: () => new Float32Array([0.5, -0.5]) };
        }
    };
    t.after(() => delete globalThis.OfflineAudioContext);
    const id3 = Buffer.from('ID3\x04\x00\x00\x00\x00\x01\x02', 'latin1'); // 130 bytes
    const tagged = Buffer.concat([id3, Buffer.alloc(130, 255), Buffer.from('fffbe000', 'hex')]);
    const files = [
        [flacStart(96000), 96000], [flacStart(11025), 11025], [flacStart(384000), 48000],
        [oggPage(vorbisPacket(22050)), 22050], [oggPage(Buffer.from('OpusHead')), 48000],
        [oggPage(Buffer.concat([Buffer.from('\x7fFLAC\x01\x00\x00\x01', 'latin1'),
            flacStart(88200)])), 88200],
        [Buffer.from('fffb9000', 'hex'), 44100], [Buffer.from('fff39800', 'hex'), 16000],
        [Buffer.from('ffe39400', 'hex'), 12000], [tagged, 44100],
        [Buffer.from('0000001c6674797069736f6d', 'hex'), 48000],
    ];
    for (const [bytes] of files) {
        const sound = await decodeSound(bufferOf(bytes));
        assert.deepEqual([...sound.channels[0]], [0.5, -0.5]);
    }
    assert.deepEqual(rates, files.map(([, rate]) => rate));
    await assert.rejects(decodeSound(bufferOf(Buffer.from('not a sound'))),
        /can't read the sound\. Use a WAV/);
});
