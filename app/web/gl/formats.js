// Pixel formats of targets and textures in WebGL 2.

/**
 * @typedef {{internal: number, format: number, type: number, channels: number, bytes: number,
 *     kind: 'float'|'unsigned'|'signed', bits: number}} PixelFormat
 *     `kind` of the numbers that shaders get. `bits` per channel, of floats only.
 */

const pixelChannels = ['', 'r', 'rg', 'rgb', 'rgba'];

/**
 * Formats of integers: r8ui to rgba32i.
 * @param {WebGL2RenderingContext} gl
 * @param {string} name
 * @returns {PixelFormat|null}
 */
function integerFormat(gl, name) {
    const parts = /^(r|rg|rgba)(8|16|32)(ui|i)$/.exec(name);
    if (!parts)
        return null;
    const channels = pixelChannels.indexOf(parts[1]);
    const isSigned = parts[3] === 'i';
    const types = isSigned ? { 8: gl.BYTE, 16: gl.SHORT, 32: gl.INT }
        : { 8: gl.UNSIGNED_BYTE, 16: gl.UNSIGNED_SHORT, 32: gl.UNSIGNED_INT };
    const bits = /** @type {8|16|32} */ (Number(parts[2]));
    return {
        internal: /** @type {any} */ (gl)[name.toUpperCase()],
        format: [0, gl.RED_INTEGER, gl.RG_INTEGER, 0, gl.RGBA_INTEGER][channels],
        type: types[bits],
        channels,
        bytes: (channels * bits) / 8,
        kind: isSigned ? 'signed' : 'unsigned',
        bits: 0,
    };
}

/**
 * A format by its name in docs/look-format.md. Throws if the name is unknown.
 * @param {WebGL2RenderingContext} gl
 * @param {string} name
 * @returns {PixelFormat}
 */
export function pixelFormat(gl, name) {
    const layout = [0, gl.RED, gl.RG, gl.RGB, gl.RGBA];
    /** @type {(internal: number, channels: number, type: number, bits: number) => PixelFormat} */
    const floats = (internal, channels, type, bits) => ({
        internal, format: layout[channels], type, channels,
        bytes: channels * (bits || 8) / 8, kind: 'float', bits,
    });
    /** @type {Object<string, PixelFormat>} */
    const known = {
        r8: floats(gl.R8, 1, gl.UNSIGNED_BYTE, 0),
        rg8: floats(gl.RG8, 2, gl.UNSIGNED_BYTE, 0),
        rgba8: floats(gl.RGBA8, 4, gl.UNSIGNED_BYTE, 0),
        rgb8: floats(gl.RGB8, 3, gl.UNSIGNED_BYTE, 0),
        srgb8_alpha8: floats(gl.SRGB8_ALPHA8, 4, gl.UNSIGNED_BYTE, 0),
        rgb10_a2: floats(gl.RGB10_A2, 4, gl.UNSIGNED_INT_2_10_10_10_REV, 0),
        r11f_g11f_b10f: floats(gl.R11F_G11F_B10F, 3, gl.HALF_FLOAT, 10),
        r16f: floats(gl.R16F, 1, gl.HALF_FLOAT, 16),
        rg16f: floats(gl.RG16F, 2, gl.HALF_FLOAT, 16),
        rgba16f: floats(gl.RGBA16F, 4, gl.HALF_FLOAT, 16),
        r32f: floats(gl.R32F, 1, gl.FLOAT, 32),
        rg32f: floats(gl.RG32F, 2, gl.FLOAT, 32),
        rgb32f: floats(gl.RGB32F, 3, gl.FLOAT, 32),
        rgba32f: floats(gl.RGBA32F, 4, gl.FLOAT, 32),
        rgb10_a2ui: {
            internal: gl.RGB10_A2UI, format: gl.RGBA_INTEGER, type: gl.UNSIGNED_INT_2_10_10_10_REV,
            channels: 4, bytes: 4, kind: 'unsigned', bits: 0,
        },
    };
    const found = known[name] || integerFormat(gl, name);
    if (!found)
        throw new Error(`The pixel format '${name}' is unknown. Export the look again.`);
    return found;
}

/**
 * The name of the format that stores only red.
 * @param {string} name
 */
export function oneChannelOf(name) {
    const parts = /^(rg|rgba)(8|16f|32f)$/.exec(name);
    return parts ? `r${parts[2]}` : name;
}

/**
 * The name of the format with 16-bit floats.
 * @param {string} name
 */
export function halfFloatsOf(name) {
    return name.replace(/^(r|rg|rgba)32f$/, '$116f');
}
