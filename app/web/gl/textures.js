// Textures, targets and samplers.

/**
 * @typedef {import('./formats.js').PixelFormat} TexelFormat
 * @typedef {import('../look/types.js').SamplerDescription} TexelSampler
 * @typedef {{texture: WebGLTexture, target: number, width: number, height: number,
 *     format: TexelFormat, levels: number}} GlTexture
 * @typedef {GlTexture & {framebuffer: WebGLFramebuffer}} GlCanvas
 */

/**
 * A flat texture of transparent black.
 * @param {WebGL2RenderingContext} gl
 * @param {TexelFormat} format
 * @param {number} width px
 * @param {number} height px
 * @param {boolean} isMipmapped
 * @returns {GlTexture}
 */
export function makeTexture(gl, format, width, height, isMipmapped) {
    const texture = /** @type {WebGLTexture} */ (gl.createTexture());
    const levels = isMipmapped ? 1 + Math.floor(Math.log2(Math.max(width, height))) : 1;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, levels, format.internal, width, height);
    return { texture, target: gl.TEXTURE_2D, width, height, format, levels };
}

/**
 * A cube map or a volume of transparent black.
 * @param {WebGL2RenderingContext} gl
 * @param {TexelFormat} format
 * @param {number} side px
 * @param {'cube'|'volume'} shape
 * @param {boolean} isMipmapped
 * @returns {GlTexture}
 */
export function makeSolidTexture(gl, format, side, shape, isMipmapped) {
    const texture = /** @type {WebGLTexture} */ (gl.createTexture());
    const levels = isMipmapped ? 1 + Math.floor(Math.log2(side)) : 1;
    const target = shape === 'cube' ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_3D;
    gl.bindTexture(target, texture);
    if (shape === 'cube')
        gl.texStorage2D(target, levels, format.internal, side, side);
    else
        gl.texStorage3D(target, levels, format.internal, side, side, side);
    return { texture, target, width: side, height: side, format, levels };
}

/**
 * A texture that can be drawn into, cleared. Throws if the browser can't draw into its format.
 * @param {WebGL2RenderingContext} gl
 * @param {TexelFormat} format
 * @param {number} width px
 * @param {number} height px
 * @param {boolean} isMipmapped
 * @returns {GlCanvas}
 */
export function makeGlCanvas(gl, format, width, height, isMipmapped) {
    const made = makeTexture(gl, format, width, height, isMipmapped);
    const framebuffer = /** @type {WebGLFramebuffer} */ (gl.createFramebuffer());
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, made.texture, 0);
    const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
    if (status !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost())
        throw new Error(`This browser can't draw into a texture of ${width} x ${height} pixels `
            + `(status 0x${status.toString(16)}). Choose a smaller size, or another browser.`);
    const canvas = { ...made, framebuffer };
    clearGlCanvas(gl, canvas, 0);
    updateLevels(gl, canvas);
    return canvas;
}

/**
 * Sets all channels of all texels to a number.
 * @param {WebGL2RenderingContext} gl
 * @param {GlCanvas} canvas
 * @param {number} number
 */
export function clearGlCanvas(gl, canvas, number) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, canvas.framebuffer);
    gl.disable(gl.SCISSOR_TEST);
    const numbers = [number, number, number, number];
    if (canvas.format.kind === 'float')
        gl.clearBufferfv(gl.COLOR, 0, numbers);
    else if (canvas.format.kind === 'unsigned')
        gl.clearBufferuiv(gl.COLOR, 0, numbers);
    else
        gl.clearBufferiv(gl.COLOR, 0, numbers);
}

/**
 * Copies the texels of a canvas of the same size and format.
 * @param {WebGL2RenderingContext} gl
 * @param {GlCanvas} from
 * @param {GlCanvas} to
 */
export function copyGlCanvas(gl, from, to) {
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to.framebuffer);
    gl.blitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height,
        gl.COLOR_BUFFER_BIT, gl.NEAREST);
}

/**
 * Copies the texels of a canvas with a linear filter to another size.
 * @param {WebGL2RenderingContext} gl
 * @param {GlCanvas} from
 * @param {GlCanvas} to
 */
export function stretchGlCanvas(gl, from, to) {
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to.framebuffer);
    gl.blitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height,
        gl.COLOR_BUFFER_BIT, gl.LINEAR);
    updateLevels(gl, to);
}

/**
 * Makes the mip levels from the largest one.
 * @param {WebGL2RenderingContext} gl
 * @param {GlTexture} texture
 */
export function updateLevels(gl, texture) {
    if (texture.levels === 1)
        return;
    gl.bindTexture(texture.target, texture.texture);
    gl.generateMipmap(texture.target);
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {GlCanvas} canvas
 */
export function deleteGlCanvas(gl, canvas) {
    gl.deleteFramebuffer(canvas.framebuffer);
    gl.deleteTexture(canvas.texture);
}

/** Sampler objects, one for each combination of settings. */
export class Samplers {
    /** @param {WebGL2RenderingContext} gl */
    constructor(gl) {
        this.gl = gl;
        /** @type {Map<string, WebGLSampler>} */
        this.made = new Map();
        /** @type {Map<TexelSampler, WebGLSampler>} the same, by their settings */
        this.known = new Map();
    }

    /**
     * Binds a texture to a unit. Integers are not filtered. A border is added by the shaders.
     * @param {number} unit
     * @param {GlTexture} texture
     * @param {TexelSampler} sampler
     */
    bind(unit, texture, sampler) {
        const gl = this.gl;
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(texture.target, texture.texture);
        if (texture.format.kind !== 'float') {
            gl.bindSampler(unit,
                this.find({ filter: 'nearest', wrap: sampler.wrap, mipmap: false }));
            return;
        }
        const known = this.known.get(sampler) || this.find(sampler);
        this.known.set(sampler, known);
        gl.bindSampler(unit, known);
    }

    /**
     * @param {TexelSampler} sampler
     * @returns {WebGLSampler}
     */
    find(sampler) {
        const between = sampler.between_levels || sampler.filter;
        const key = [sampler.filter, sampler.wrap, sampler.mipmap, between].join();
        const known = this.made.get(key);
        if (known)
            return known;
        const gl = this.gl;
        const isLinear = sampler.filter === 'linear';
        const single = isLinear ? gl.LINEAR : gl.NEAREST;
        const levels = between === 'linear'
            ? [gl.NEAREST_MIPMAP_LINEAR, gl.LINEAR_MIPMAP_LINEAR]
            : [gl.NEAREST_MIPMAP_NEAREST, gl.LINEAR_MIPMAP_NEAREST];
        const wrap = { edge: gl.CLAMP_TO_EDGE, border: gl.CLAMP_TO_EDGE, repeat: gl.REPEAT,
            mirror: gl.MIRRORED_REPEAT }[sampler.wrap];
        const made = /** @type {WebGLSampler} */ (gl.createSampler());
        gl.samplerParameteri(made, gl.TEXTURE_MIN_FILTER,
            sampler.mipmap ? levels[isLinear ? 1 : 0] : single);
        gl.samplerParameteri(made, gl.TEXTURE_MAG_FILTER, single);
        for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R])
            gl.samplerParameteri(made, axis, wrap);
        this.made.set(key, made);
        return made;
    }
}
