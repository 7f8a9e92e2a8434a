// Reads PNG files of the program: 8 bits per channel, RGB or RGBA, not interlaced.
import { inflateSync } from 'node:zlib';

// The filters of the PNG specification (third edition), section 9.
function predicted(filter, left, up, upLeft) {
    if (filter < 4) {
        return filter === 0 ? 0 : filter === 1 ? left : filter === 2 ? up : (left + up) >> 1;
    }
    const a = Math.abs(up - upLeft);
    const b = Math.abs(left - upLeft);
    const c = Math.abs(left + up - 2 * upLeft);
    return a <= b && a <= c ? left : b <= c ? up : upLeft;
}

/** {width, height, channels, values}, row 0 at the top. */
export function pngPixels(file) {
    const width = file.readUInt32BE(16);
    const height = file.readUInt32BE(20);
    const channels = { 2: 3, 6: 4 }[file[25]];
    const isKnown = channels && file[24] === 8 && file[28] === 0;
    if (!isKnown) {
        throw new Error('expected a PNG with 8 bits per channel');
    }
    const parts = [];
    for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
        if (file.toString('latin1', at + 4, at + 8) === 'IDAT') {
            parts.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
        }
    }
    const rows = inflateSync(Buffer.concat(parts));
    const length = width * channels;
    const values = new Uint8Array(height * length);
    for (let y = 0; y < height; ++y) {
        const start = y * (length + 1);
        for (let x = 0; x < length; ++x) {
            const at = y * length + x;
            const left = x < channels ? 0 : values[at - channels];
            const up = y === 0 ? 0 : values[at - length];
            const upLeft = x < channels || y === 0 ? 0 : values[at - length - channels];
            values[at] = rows[start + 1 + x] + predicted(rows[start], left, up, upLeft);
        }
    }
    return { width, height, channels, values };
}
