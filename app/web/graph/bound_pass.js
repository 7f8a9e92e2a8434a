// A pass with its program, samplers and vertices.

import { isSamplerType, linkedProgram, writeUniform } from '../gl/programs.js';
import { readPass } from './plan.js';

/**
 * @typedef {import('../look/types.js').LookDescription} BoundLook
 * @typedef {import('../look/types.js').PassDescription} BoundDescription
 * @typedef {import('../look/types.js').SamplerDescription} BoundSampler
 * @typedef {{unit: number, kind: 'flat'|'cube'|'volume', numbers: 'float'|'signed'|'unsigned',
 *     from: string, name: string, pass: number, framesAgo: number, sampler: BoundSampler,
 *     holds: string, columns: number,
 *     texture: import('../gl/textures.js').GlTexture|null}} BoundInput
 *     `texture` is the one that was bound last.
 */

/** @type {BoundSampler} */
const unboundSampler = { filter: 'linear', wrap: 'edge', mipmap: false };

/** The linked program of a pass and what it reads. */
export class BoundPass {
    /**
     * @param {WebGL2RenderingContext} gl
     * @param {BoundLook} look
     * @param {number} index of the pass
     * @param {WebGLProgram} program
     * @param {string} text of its shaders
     */
    constructor(gl, look, index, program, text) {
        this.gl = gl;
        this.look = look;
        this.index = index;
        this.text = text;
        this.description = look.passes[index];
        this.linked = linkedProgram(gl, program, this.description.name);
        gl.useProgram(program);
        /** @type {BoundInput[]} */
        this.inputs = [];
        for (const uniform of this.linked.uniforms.values())
            if (isSamplerType(gl, uniform.type))
                this.bindSampler(uniform);
        for (const [name, numbers] of Object.entries(this.description.set))
            this.write(name, Array.isArray(numbers) ? numbers : [Number(numbers)]);
        this.readsItself = this.inputs.some((input) => input.pass === index);
        /** @type {WebGLVertexArrayObject|null} */
        this.vertices = null;
        this.tint = -1;
    }

    /** @param {import('../gl/programs.js').ActiveUniform} uniform */
    bindSampler(uniform) {
        const gl = this.gl;
        const unit = this.inputs.length;
        gl.uniform1i(uniform.location, unit);
        const declared = this.description.inputs.find((one) => one.uniform === uniform.name);
        const chosen = this.description.parameters[uniform.name];
        const read = declared && declared.from === 'pass'
            ? readPass(this.look, this.index, declared)
            : { pass: -1, framesAgo: (declared && declared.frames_ago) || 0 };
        this.inputs.push({
            unit,
            kind: uniform.type === gl.SAMPLER_CUBE ? 'cube'
                : uniform.type === gl.SAMPLER_3D ? 'volume' : 'flat',
            numbers: uniform.type === gl.INT_SAMPLER_2D ? 'signed'
                : uniform.type === gl.UNSIGNED_INT_SAMPLER_2D ? 'unsigned' : 'float',
            from: declared ? declared.from : chosen ? 'image' : 'nothing',
            name: (declared && declared.name) || chosen || '',
            ...read,
            sampler: declared || unboundSampler,
            holds: (declared && declared.holds) || '',
            columns: (declared && declared.columns) || 0,
            texture: null,
        });
    }

    /**
     * Writes a uniform of the program, which must be in use. Unused names are ignored.
     * @param {string} name
     * @param {number[]} numbers
     */
    write(name, numbers) {
        const uniform = this.linked.uniforms.get(name);
        if (uniform)
            writeUniform(this.gl, uniform, numbers);
    }
}
