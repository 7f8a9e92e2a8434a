// Decodes the pictures of sources.

import { foundPrescale, withoutPrescale } from './prescaled.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/**
 * A picture that the exporter stored without a file format.
 * @typedef {object} RawPicture
 * @property {number} width px
 * @property {number} height px
 * @property {number} channels
 * @property {'display' | 'linear'} encoding
 * @property {string} halfs Base64 of gzip of little-endian binary16. Row 0 at the top.
 */

const largestHalf = 65504;

/**
 * The value of a binary16 number (IEEE 754-2019, 3.6). NaN becomes 0 and infinities become ±65504,
 * because both would spread to all passes that read them.
 * @param {number} bits
 * @returns {number}
 */
export function numberOfHalf(bits) {
    const sign = bits & 0x8000 ? -1 : 1;
    const exponent = (bits >> 10) & 31;
    const fraction = bits & 1023;
    if (exponent === 31) {
        return fraction === 0 ? sign * largestHalf : 0;
    }
    return exponent === 0 ? sign * fraction * 2 ** -24 :
        sign * (1024 + fraction) * 2 ** (exponent - 25);
}

/**
 * @param {string} base64
 * @returns {Uint8Array}
 */
function bytesOfBase64(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) {
        bytes[i] = text.charCodeAt(i);
    }
    return bytes;
}

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<Uint8Array>} Empty if they are damaged.
 */
async function gunzippedBytes(bytes) {
    const Decompressor = /** @type {any} */ (globalThis).DecompressionStream;
    if (!Decompressor) {
        throw new Error("This browser can't unpack the pictures of this page. Update it.");
    }
    const stream = new Blob([bytes]).stream().pipeThrough(new Decompressor('gzip'));
    const unpacked = await new Response(stream).arrayBuffer().catch(() => new ArrayBuffer(0));
    return new Uint8Array(unpacked);
}

/**
 * @param {string} name For messages.
 * @param {RawPicture} raw
 * @returns {Promise<SourcePicture>} With floats.
 */
export async function decodedRawPicture(name, raw) {
    const { width, height, channels, encoding } = raw;
    const bytes = await gunzippedBytes(bytesOfBase64(raw.halfs));
    const count = width * height * channels;
    if (bytes.length !== 2 * count) {
        throw new Error(`Can't read '${name}': its data is damaged. Export the page again.`);
    }
    const pixels = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
        pixels[i] = numberOfHalf(bytes[2 * i] | bytes[2 * i + 1] << 8);
    }
    return { width, height, channels, encoding, pixels, isTopFirst: true };
}

/**
 * @param {string} name For messages.
 * @param {Blob} blob
 * @returns {Promise<SourcePicture>} With an ImageBitmap.
 */
async function decodedPictureFile(name, blob) {
    const exact = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };
    /** @param {object} options */
    const decode = (options) => createImageBitmap(blob, options);
    /** @type {ImageBitmap} */
    let image;
    try {
        // A browser that does not know 'from-image' throws a TypeError, and does so by default.
        image = await decode({ ...exact, imageOrientation: 'from-image' }).catch((error) => {
            if (error instanceof TypeError) {
                return decode(exact);
            }
            throw error;
        });
    } catch {
        throw new Error(`Can't read '${name}': this browser does not know its format. ` +
            'Use a PNG, JPEG or WebP file.');
    }
    const { width, height } = image;
    return { width, height, channels: 4, encoding: 'display', pixels: image, isTopFirst: true };
}

/**
 * Decodes a picture file or a raw picture. Throws an Error with a message for the user.
 * @param {string} name For messages.
 * @param {Blob | RawPicture} content
 * @returns {Promise<SourcePicture>}
 */
export function decodedPicture(name, content) {
    return content instanceof Blob ? decodedPictureFile(name, content) :
        decodedRawPicture(name, content);
}

/**
 * Frees a picture that is no longer shown.
 * @param {SourcePicture | null} picture
 */
export function closePicture(picture) {
    if (picture && 'close' in picture.pixels) {
        picture.pixels.close();
    }
}

/**
 * The values of a picture. Those of an image or video are RGBA bytes, as a canvas reads them.
 * @param {SourcePicture} picture
 * @returns {{pixels: Float32Array | Uint8Array | Uint8ClampedArray, channels: number}}
 */
function readablePixels({ width, height, channels, pixels }) {
    if (ArrayBuffer.isView(pixels)) {
        return { pixels, channels };
    }
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context) {
        throw new Error('This browser cannot read pictures. Close other pages and try again.');
    }
    context.drawImage(pixels, 0, 0, width, height);
    return { pixels: context.getImageData(0, 0, width, height).data, channels: 4 };
}

/**
 * Pixels per original pixel in each direction, as set or detected.
 * @param {SourcePicture} picture
 * @param {number} prescaled As in SourceSettings. 0: detected.
 * @returns {number}
 */
export function prescaleOf(picture, prescaled) {
    return prescaled > 0 ? prescaled :
        foundPrescale({ ...picture, ...readablePixels(picture) });
}

/**
 * The original of a picture that shows each pixel as `times` x `times` pixels.
 * @param {SourcePicture} picture
 * @param {number} times 1: the picture itself.
 * @returns {SourcePicture}
 */
export function pictureWithoutPrescale(picture, times) {
    if (times === 1) {
        return picture;
    }
    const original = withoutPrescale({ ...picture, ...readablePixels(picture) }, times);
    return { ...picture, ...original };
}
