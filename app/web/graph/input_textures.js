// The textures that the samplers of a pass read in a frame.

import { pixelFormat } from '../gl/formats.js';
import { makeSolidTexture, makeTexture, updateLevels } from '../gl/textures.js';

/**
 * @typedef {import('../gl/textures.js').GlTexture} InputTexture
 * @typedef {import('../gl/textures.js').GlCanvas} InputCanvas
 * @typedef {import('./bound_pass.js').BoundInput} ReadInput
 * @typedef {{targets: import('./targets.js').PassTarget[],
 *     source: import('./source_texture.js').SourceTextures|null}} DrawnPictures
 */

const cubeFaces = 6;

/** Pictures, sounds and keys by name, and the pictures of passes. */
export class InputTextures {
    #gl;
    #samplers;
    /** One texel of transparent black for each kind of sampler. @type {Map<string, InputTexture>} */
    #empty = new Map();
    /** Cube maps of faces that passes drew. @type {Map<WebGLTexture, InputTexture>} */
    #cubes = new Map();

    /**
     * @param {WebGL2RenderingContext} gl
     * @param {import('../gl/textures.js').Samplers} samplers
     */
    constructor(gl, samplers) {
        this.#gl = gl;
        this.#samplers = samplers;
        /** @type {Map<string, InputTexture>} */
        this.named = new Map();
    }

    /**
     * The texture of an input. Null if it has nothing to read.
     * @param {ReadInput} input
     * @param {DrawnPictures} drawn
     * @returns {InputTexture|null}
     */
    find(input, { targets, source }) {
        if (input.from === 'pass')
            return input.pass < 0 ? null : targets[input.pass].canvas(input.framesAgo);
        if (input.from === 'source')
            return source && source.texture(input.framesAgo);
        const key = input.from === 'sound' ? `sound ${input.holds} ${input.columns}`
            : input.from === 'keyboard' ? 'keyboard' : `image ${input.name}`;
        return this.named.get(key) || null;
    }

    /**
     * Binds the textures of a pass. The framebuffer for reading can change.
     * @param {ReadInput[]} inputs
     * @param {DrawnPictures} drawn
     */
    bind(inputs, drawn) {
        // New textures are bound while they are made, so they are made first.
        for (const input of inputs)
            input.texture = this.#usable(input, drawn);
        for (const input of inputs)
            if (input.texture)
                this.#samplers.bind(input.unit, input.texture, input.sampler);
    }

    /**
     * @param {ReadInput} input
     * @param {DrawnPictures} drawn
     * @returns {InputTexture}
     */
    #usable(input, drawn) {
        const gl = this.#gl;
        let found = this.find(input, drawn);
        if (found && input.kind === 'cube' && input.from === 'pass')
            found = this.#cubeOf(/** @type {InputCanvas} */ (found), input.sampler.mipmap);
        const target = { flat: gl.TEXTURE_2D, cube: gl.TEXTURE_CUBE_MAP,
            volume: gl.TEXTURE_3D }[input.kind];
        const isUsable = found && found.target === target && found.format.kind === input.numbers;
        return isUsable && found ? found : this.#black(input);
    }

    /**
     * Six faces from left to right as a cube map.
     * @param {InputCanvas} canvas
     * @param {boolean} isMipmapped
     * @returns {InputTexture|null}
     */
    #cubeOf(canvas, isMipmapped) {
        const gl = this.#gl;
        const side = canvas.height;
        if (canvas.width !== cubeFaces * side)
            return null;
        let cube = this.#cubes.get(canvas.texture);
        if (!cube || (cube.levels > 1) !== isMipmapped)
            cube = makeSolidTexture(gl, canvas.format, side, 'cube', isMipmapped);
        this.#cubes.set(canvas.texture, cube);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, canvas.framebuffer);
        gl.bindTexture(cube.target, cube.texture);
        for (let face = 0; face < cubeFaces; face++)
            gl.copyTexSubImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, face * side, 0,
                side, side);
        updateLevels(gl, cube);
        return cube;
    }

    /** Frees the cube maps of targets that were replaced. */
    forgetCubes() {
        for (const cube of this.#cubes.values())
            this.#gl.deleteTexture(cube.texture);
        this.#cubes.clear();
    }

    /**
     * @param {ReadInput} input
     * @returns {InputTexture}
     */
    #black(input) {
        const gl = this.#gl;
        const key = `${input.kind} ${input.numbers}`;
        const known = this.#empty.get(key);
        if (known)
            return known;
        const names = { float: 'rgba8', signed: 'rgba8i', unsigned: 'rgba8ui' };
        const format = pixelFormat(gl, names[input.numbers]);
        const made = input.kind === 'flat' ? makeTexture(gl, format, 1, 1, false)
            : makeSolidTexture(gl, format, 1, input.kind, false);
        this.#empty.set(key, made);
        return made;
    }
}
