// The source picture as a texture: placed, and encoded as the look expects.

import { linkedProgram, startProgram, writeUniform } from '../gl/programs.js';
import { deleteGlCanvas, makeGlCanvas, makeTexture, updateLevels } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';

/**
 * @typedef {import('../gl/textures.js').GlTexture} StagedTexture
 * @typedef {import('../gl/textures.js').GlCanvas} SourceCanvas
 * @typedef {import('../sources/source.js').SourcePicture} GivenPicture
 * @typedef {{width: number, height: number, left: number, top: number, repeatX: number,
 *     repeatY: number, shrink: number}} PicturePlacing
 */

const placingVertex = `#version 300 es
void main()
{
    vec2 p = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(p * 2.0 - 1.0, 0.0, 1.0);
}
`;

// IEC 61966-2-1.
const placingFragment = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D picture;
uniform ivec2 made;
uniform ivec4 place;    // left, top, repeats
uniform int encoding;   // 0: as it is, 1: display to linear, 2: linear to display
uniform int shrink;     // pixels per side whose mean is taken
uniform bool top_first;
uniform bool is_grey;
uniform bool has_bytes;
out vec4 color;
// n / 255 rounded to the nearest float, as the program computes it. Texels are n * (1 / 255).
vec4 exact_bytes(vec4 c)
{
    vec4 n = floor(c * 255.0 + 0.5);
    vec4 quotient = n / 255.0;
    return quotient + ((n - quotient * 256.0) + quotient) / 255.0;
}
vec3 recoded(vec3 c)
{
    if (encoding == 1)
        return mix(c / 12.92, pow((max(c, vec3(0.0)) + 0.055) / 1.055, vec3(2.4)),
                   vec3(greaterThan(c, vec3(0.04045))));
    if (encoding == 2)
        return mix(c * 12.92, 1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055,
                   vec3(greaterThan(c, vec3(0.0031308))));
    return c;
}
void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (!top_first)
        at.y = made.y - 1 - at.y;
    at -= place.xy;
    ivec2 size = textureSize(picture, 0);
    ivec2 smaller = max(size / shrink, ivec2(1));
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, smaller * place.zw)))
        return;
    ivec2 first = at / place.zw * shrink;
    ivec2 end = min(first + shrink, size);
    vec4 sum = vec4(0.0);
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x)
            sum += texelFetch(picture, ivec2(x, y), 0);
    if (shrink == 1 && has_bytes)
        sum = exact_bytes(sum);
    color = sum / float(max((end.x - first.x) * (end.y - first.y), 1));
    color = vec4(recoded(is_grey ? color.rrr : color.rgb), color.a);
}
`;

/** Uploads pictures and draws them into textures with the encoding that a look expects. */
export class PicturePlacer {
    /** @param {import('../gl/context.js').GlContext} context */
    constructor(context) {
        this.context = context;
        const gl = context.gl;
        this.linked = linkedProgram(gl, startProgram(gl, placingVertex, placingFragment), 'source');
        /** @type {StagedTexture|null} */
        this.staged = null;
    }

    /**
     * The picture in a texture of its own size, row 0 at the top.
     * @param {GivenPicture} picture
     * @returns {StagedTexture}
     */
    upload(picture) {
        const gl = this.context.gl;
        const isFloat = picture.pixels instanceof Float32Array;
        const channels = ['', 'r', '', 'rgb', 'rgba'][picture.channels];
        const format = pixelFormat(gl, channels + (isFloat ? '32f' : '8'));
        if (!this.staged || this.staged.width !== picture.width
            || this.staged.height !== picture.height
            || this.staged.format.internal !== format.internal) {
            if (this.staged)
                gl.deleteTexture(this.staged.texture);
            this.staged = makeTexture(gl, format, picture.width, picture.height, false);
        }
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.staged.texture);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
        gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
        gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        const { pixels, width, height } = picture;
        if (ArrayBuffer.isView(pixels))
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format.format, format.type,
                pixels instanceof Uint8ClampedArray
                    ? new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.length) : pixels);
        else
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE,
                /** @type {TexImageSource} */ (pixels));
        return this.staged;
    }

    /**
     * The texels of a picture.
     * @param {GivenPicture} picture
     * @returns {Uint8Array|Float32Array} RGBA, row 0 at the top
     */
    texelsOf(picture) {
        const gl = this.context.gl;
        const isFloat = picture.pixels instanceof Float32Array;
        const { width, height } = picture;
        const canvas = makeGlCanvas(gl, pixelFormat(gl, isFloat ? 'rgba32f' : 'rgba8'), width,
            height, false);
        this.draw(picture, canvas, { placing: { width, height, left: 0, top: 0, repeatX: 1,
            repeatY: 1, shrink: 1 }, encoding: null, isTopFirst: true });
        const texels = isFloat ? new Float32Array(4 * width * height)
            : new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, texels);
        deleteGlCanvas(gl, canvas);
        return texels;
    }

    /**
     * Draws a picture into a canvas.
     * @param {GivenPicture} picture
     * @param {SourceCanvas} canvas
     * @param {{placing: PicturePlacing, encoding: 'linear'|'display'|null, isTopFirst: boolean}} as
     *     encoding null: the numbers are data
     */
    draw(picture, canvas, as) {
        const gl = this.context.gl;
        const staged = this.upload(picture);
        gl.useProgram(this.linked.program);
        const { placing } = as;
        const recodes = as.encoding !== null && as.encoding !== picture.encoding;
        const encoding = as.encoding === 'linear' ? 1 : 2;
        this.write('picture', [0]);
        this.write('made', [canvas.width, canvas.height]);
        this.write('place', [placing.left, placing.top, placing.repeatX, placing.repeatY]);
        this.write('encoding', [recodes ? encoding : 0]);
        this.write('shrink', [placing.shrink]);
        this.write('top_first', [as.isTopFirst ? 1 : 0]);
        this.write('is_grey', [picture.channels === 1 ? 1 : 0]);
        this.write('has_bytes', [picture.pixels instanceof Float32Array ? 0 : 1]);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, staged.texture);
        gl.bindSampler(0, null);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, canvas.framebuffer);
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.disable(gl.BLEND);
        gl.bindVertexArray(null);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        updateLevels(gl, canvas);
    }

    /** @param {string} name @param {number[]} numbers */
    write(name, numbers) {
        const uniform = this.linked.uniforms.get(name);
        if (!uniform)
            return;
        if (name === 'picture')
            this.context.gl.uniform1i(uniform.location, numbers[0]);
        else
            writeUniform(this.context.gl, uniform, numbers);
    }
}

/** The source pictures that a look reads: of this frame and of previous ones. */
export class SourceTextures {
    /**
     * @param {PicturePlacer} placer
     * @param {string} format
     * @param {number} slots
     * @param {boolean} isMipmapped
     */
    constructor(placer, format, slots, isMipmapped) {
        this.placer = placer;
        this.format = format;
        this.isMipmapped = isMipmapped;
        /** @type {(SourceCanvas|null)[]} canvases in turn, one more than are read */
        this.canvases = new Array(slots > 1 ? slots + 1 : 1).fill(null);
        /** @type {number[]} index of the canvas of each previous frame, -1: none */
        this.frames = new Array(slots).fill(-1);
        this.newest = -1;
    }

    /**
     * Sets the picture of the next frames.
     * @param {GivenPicture} picture
     * @param {{placing: PicturePlacing, encoding: 'linear'|'display', isTopFirst: boolean}} as
     */
    set(picture, as) {
        let index = 0;
        while (this.frames.length > 1 && this.frames.includes(index))
            index++;
        const { gl } = this.placer.context;
        const had = this.canvases[index];
        let canvas = had;
        if (!had || had.width !== as.placing.width || had.height !== as.placing.height) {
            if (had)
                deleteGlCanvas(gl, had);
            canvas = makeGlCanvas(gl, pixelFormat(gl, this.format), as.placing.width,
                as.placing.height, this.isMipmapped);
            this.canvases[index] = canvas;
        }
        this.placer.draw(picture, /** @type {SourceCanvas} */ (canvas), as);
        this.newest = index;
    }

    /** The next frame begins. */
    advance() {
        this.frames.pop();
        this.frames.unshift(this.newest);
    }

    /** Forgets previous frames. */
    clear() {
        this.frames.fill(-1);
    }

    /**
     * @param {number} framesAgo
     * @returns {SourceCanvas|null}
     */
    texture(framesAgo) {
        const index = framesAgo === 0 ? this.newest
            : this.frames[Math.min(framesAgo, this.frames.length - 1)];
        return index < 0 ? null : this.canvases[index];
    }

    dispose() {
        for (const canvas of this.canvases)
            if (canvas)
                deleteGlCanvas(this.placer.context.gl, canvas);
    }
}
