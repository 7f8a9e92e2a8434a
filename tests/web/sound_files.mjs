// Sounds for tests, and WAV files with them.

/** A sound whose channels are functions of the sample number. */
export function soundOf(rate, frames, ...channels) {
    return {
        rate,
        channels: channels.map((at) => Float32Array.from({ length: frames }, (_, i) => at(i))),
        seconds: frames / rate,
    };
}

function chunk(name, body) {
    const head = Buffer.alloc(8);
    head.write(name, 'latin1');
    head.writeUInt32LE(body.length, 4);
    return Buffer.concat([head, body, Buffer.alloc(body.length % 2)]);
}

function formatChunk(tag, bits, rate, channels, isExtensible) {
    const body = Buffer.alloc(isExtensible ? 40 : 16);
    const frame = channels * Math.ceil(bits / 8);
    body.writeUInt16LE(isExtensible ? 0xfffe : tag, 0);
    body.writeUInt16LE(channels, 2);
    body.writeUInt32LE(rate, 4);
    body.writeUInt32LE(rate * frame, 8);
    body.writeUInt16LE(frame, 12);
    body.writeUInt16LE(bits, 14);
    if (isExtensible) { // and the GUID of the tag
        body.writeUInt16LE(22, 16);
        body.writeUInt16LE(bits, 18);
        body.writeUInt16LE(tag, 24);
        Buffer.from('000000001000800000aa00389b71', 'hex').copy(body, 26);
    }
    return chunk('fmt ', body);
}

/** A WAV file. `samples` has the bytes of the interleaved samples. */
export function wavFile({ tag = 1, bits, rate = 48000, channels = 1, samples, isExtensible = false,
    before = Buffer.alloc(0), after = Buffer.alloc(0) }) {
    const format = formatChunk(tag, bits, rate, channels, isExtensible);
    return Buffer.concat([Buffer.from('RIFF\xff\xff\xff\xffWAVE', 'latin1'), before, format,
        chunk('data', samples), after]);
}

/** A WAV file of 32-bit floats with this sound. */
export function floatWav(sound) {
    const count = sound.channels.length;
    const frames = sound.channels[0].length;
    const floats = Float32Array.from({ length: frames * count }, (_, i) =>
        sound.channels[i % count][Math.floor(i / count)]);
    return wavFile({ tag: 3, bits: 32, rate: sound.rate, channels: count,
        samples: Buffer.from(floats.buffer) });
}

/** The bytes as an ArrayBuffer of their own. */
export function bufferOf(bytes) {
    return new Uint8Array(bytes).buffer;
}
