// Draws frames of a look: passes in order, samples, history.

import { startProgram } from '../gl/programs.js';
import { Samplers, clearGlCanvas, copyGlCanvas, makeTexture } from '../gl/textures.js';
import { updateLevels } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';
import { numbersForShaders } from '../look/values.js';
import { BeamBuffers, beamScale } from './beam_buffers.js';
import { BoundPass } from './bound_pass.js';
import { builtInNumbers } from './built_ins.js';
import { cameraMatrix, viewMatrix } from './orbit.js';
import { planTargets, smallestSpot, sourceSizeOf } from './plan.js';
import { AccumulatedSamples, repeatsOf } from './samples.js';
import { PicturePlacer, SourceTextures } from './source_texture.js';
import { PassTarget, supportedFormat } from './targets.js';

/**
 * @typedef {import('../look/types.js').LookDescription} DrawnLook
 * @typedef {import('../gl/textures.js').GlTexture} DrawnTexture
 * @typedef {import('./built_ins.js').FrameState} FrameState
 * @typedef {{width: number, height: number}} DrawnSize
 */

/** Draws a look into textures. The picture is that of the last pass. */
export class Renderer {
    /**
     * Compiles all passes. Throws with the log of the driver.
     * @param {import('../gl/context.js').GlContext} context
     * @param {DrawnLook} look
     */
    constructor(context, look) {
        const gl = context.gl;
        this.context = context;
        this.gl = gl;
        this.look = look;
        const started = look.passes.map((pass) =>
            startProgram(gl, look.shaders[pass.vertex], look.shaders[pass.fragment]));
        this.passes = started.map((program, i) => new BoundPass(gl, look, i, program));
        this.samplers = new Samplers(gl);
        this.beam = new BeamBuffers(gl);
        this.quad = this.makeQuad();
        this.placer = PAGE_HAS_PICTURES ? new PicturePlacer(context) : null;
        this.samples = new AccumulatedSamples(look);
        /** @type {PassTarget[]} */
        this.targets = [];
        /** @type {SourceTextures|null} */
        this.source = null;
        /** @type {Map<string, DrawnTexture>} pictures by name, sounds by kind and columns */
        this.images = new Map();
        /** @type {Map<string, DrawnTexture>} */
        this.empty = new Map();
        this.viewport = { width: 0, height: 0 };
        /** @type {import('./plan.js').Plan|null} */
        this.plan = null;
        /** @type {Map<string, number[]>|null} */
        this.written = null;
        /** @type {{across: number, up: number}|null} */
        this.spot = null;
        /** Where the source picture is placed in its texture. */
        this.sourcePlace = '';
        this.bindVertices();
    }

    bindVertices() {
        for (const pass of this.passes) {
            const { draw } = pass.description;
            if (draw === 'points' || draw === 'segments') {
                const { vertices, tint } = this.beam.verticesFor(pass.linked.program, draw);
                pass.vertices = vertices;
                pass.tint = tint;
            } else if (draw === 'quad')
                pass.vertices = this.quad;
        }
    }

    /** The four corners from (0, 0) to (1, 1), for position and texture coordinates. */
    makeQuad() {
        const gl = this.gl;
        const vertices = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
        gl.bindVertexArray(vertices);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]), gl.STATIC_DRAW);
        for (const location of [0, 1]) {
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, 2, gl.FLOAT, false, 8, 0);
        }
        gl.bindVertexArray(null);
        return vertices;
    }

    /**
     * Allocates the targets for a size and values. Unchanged ones keep their pictures.
     * @param {DrawnSize} viewport
     * @param {DrawnSize} source
     * @param {Map<string, number[]>} values
     */
    resize(viewport, source, values) {
        this.viewport = viewport;
        const { context, look } = this;
        const terms = { viewport, source, values, largestSide: context.largestSide };
        const plan = planTargets(look, terms);
        plan.targets.forEach((planned, i) => {
            const isFiltered = look.passes.some((pass) => pass.inputs.some((input) =>
                input.name === look.passes[i].name && input.filter === 'linear'));
            const isBlended = look.passes[i].blend !== 'replace';
            const format = supportedFormat(context, planned.format, isBlended, isFiltered);
            const had = this.targets[i];
            if (had && had.key === PassTarget.keyOf(planned, format))
                return;
            if (had)
                had.dispose();
            this.targets[i] = new PassTarget(this.gl, planned, format);
            this.samples.restart();
        });
        if (PAGE_HAS_PICTURES && this.placer && !this.source && look.source)
            this.source = new SourceTextures(this.placer, supportedFormat(context,
                look.source.format, false, true), plan.sourceSlots, plan.isSourceMipmapped);
        this.plan = plan;
        this.spot = smallestSpot(look, plan, terms);
    }

    /** Discards all previous frames. */
    clearHistory() {
        for (const target of this.targets)
            target.clear();
        this.samples.restart();
        this.beam.clear();
        if (this.source)
            this.source.clear();
    }

    /**
     * Draws the next frame.
     * @param {FrameState} frame
     * @param {Map<string, number[]>} values
     * @param {import('../signals/beam.js').Beam|null} beam of a look that draws a signal
     * @param {string|number|undefined} fit of the signal
     */
    draw(frame, values, beam, fit) {
        const gl = this.gl;
        for (const target of this.targets)
            target.advance();
        if (this.source)
            this.source.advance();
        if (beam)
            this.beam.write(beam, { seconds: frame.delta, isFirst: frame.number === 1,
                hasPoints: this.look.passes.some((pass) => pass.draw === 'points'),
                spot: this.spot,
                scale: beamScale(this.look, values, this.viewport, fit) });
        const changed = this.changedValues(values);
        this.samples.restartAfter(changed);
        this.passes.forEach((pass, i) => this.drawPass(pass, i, frame, values, changed));
        gl.bindVertexArray(null);
        gl.disable(gl.BLEND);
    }

    /**
     * Names of the parameters that differ from the last frame.
     * @param {Map<string, number[]>} values
     */
    changedValues(values) {
        const before = this.written;
        this.written = new Map(values);
        return [...values.keys()].filter((name) => {
            const had = before && before.get(name);
            const now = /** @type {number[]} */ (values.get(name));
            return !had || had.length !== now.length || had.some((one, i) => one !== now[i]);
        });
    }

    /**
     * @param {BoundPass} pass
     * @param {number} index
     * @param {FrameState} frame
     * @param {Map<string, number[]>} values
     * @param {string[]} changed
     */
    drawPass(pass, index, frame, values, changed) {
        const gl = this.gl;
        const target = this.targets[index];
        const { accumulate, repeat } = pass.description;
        gl.useProgram(pass.linked.program);
        this.writeParameters(pass, values, changed);
        this.writeBuiltIns(pass, index, frame, values);
        const held = this.samples.held;
        const draws = accumulate ? this.samples.beginFrame(index, values)
            : repeatsOf(repeat, values);
        if (accumulate && draws === 0)
            copyGlCanvas(gl, target.canvas(1), target.canvas(0));
        for (let i = 0; i < draws; i++) {
            if (i > 0 && pass.readsItself)
                target.advance();
            if (i === 0 || pass.readsItself)
                this.startTarget(pass, index, !!accumulate && held[index] > 0);
            const sample = accumulate ? held[index] : this.samples.before(index) + i;
            this.writeNamed(pass, 'samples', [sample]);
            this.drawShape(pass);
            held[index] += accumulate ? 1 : 0;
        }
        updateLevels(gl, target.canvas(0));
    }

    /**
     * @param {BoundPass} pass
     * @param {number} index
     * @param {boolean} keepsPicture
     */
    startTarget(pass, index, keepsPicture) {
        const gl = this.gl;
        const target = this.targets[index];
        const canvas = target.canvas(0);
        if (keepsPicture)
            copyGlCanvas(gl, target.canvas(1), canvas);
        else
            clearGlCanvas(gl, canvas, pass.description.blend === 'multiply' ? 1 : 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, canvas.framebuffer);
        gl.viewport(0, 0, canvas.width, canvas.height);
        this.setBlend(canvas.format.kind === 'float' ? pass.description.blend : 'replace');
        for (const input of pass.inputs)
            this.samplers.bind(input.unit, this.find(input) || this.black(input), input.sampler);
    }

    /** @param {string} blend */
    setBlend(blend) {
        const gl = this.gl;
        if (blend === 'replace')
            return gl.disable(gl.BLEND);
        gl.enable(gl.BLEND);
        gl.blendEquation(blend === 'maximum' ? gl.MAX : gl.FUNC_ADD);
        if (blend === 'add' || blend === 'maximum')
            gl.blendFunc(gl.ONE, gl.ONE);
        else if (blend === 'multiply')
            gl.blendFunc(gl.DST_COLOR, gl.ZERO);
        else
            gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE,
                gl.ONE_MINUS_SRC_ALPHA);
        return undefined;
    }

    /** @param {BoundPass} pass */
    drawShape(pass) {
        const gl = this.gl;
        const { draw } = pass.description;
        gl.bindVertexArray(pass.vertices);
        if (draw === 'points' || draw === 'segments')
            this.beam.draw(draw, pass.tint);
        else if (draw === 'quad')
            gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
        else
            gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /**
     * @param {BoundPass} pass
     * @param {Map<string, number[]>} values
     * @param {string[]} changed
     */
    writeParameters(pass, values, changed) {
        for (const [uniform, parameter] of Object.entries(pass.description.parameters)) {
            const numbers = values.get(parameter);
            const declared = this.look.parameters.find((one) => one.name === parameter);
            if (numbers && declared && !declared.orbit && changed.includes(parameter))
                pass.write(uniform, numbersForShaders(declared, numbers));
        }
    }

    /**
     * @param {BoundPass} pass
     * @param {number} index
     * @param {FrameState} frame
     * @param {Map<string, number[]>} values
     */
    writeBuiltIns(pass, index, frame, values) {
        const { description } = pass;
        const plan = /** @type {import('./plan.js').Plan} */ (this.plan);
        const newest = this.source ? this.source.texture(0) : null;
        const source = sourceSizeOf(this.look, description, plan.targets, newest || this.viewport);
        /** @type {import('./built_ins.js').PassState} */
        const state = {
            target: plan.targets[index],
            output: this.viewport,
            source,
            isTopFirst: description.target.rows === 'top-first',
            modulo: description.frame_modulo || 0,
            isOwnSource: !description.source,
            read: (of) => this.sizeOf(pass, of) || source,
        };
        for (const builtIn of description.built_ins) {
            const numbers = builtInNumbers(builtIn, frame, state)
                || this.orbitNumbers(builtIn.value, description.scope || '', values);
            if (numbers)
                pass.write(builtIn.uniform, numbers);
        }
    }

    /**
     * @param {string} value
     * @param {string} scope
     * @param {Map<string, number[]>} values
     */
    orbitNumbers(value, scope, values) {
        /** @type {(part: string, initial: number[]) => number[]} */
        const part = (name, initial) => {
            const found = this.look.parameters.find((one) => one.orbit === name
                && one.name.startsWith(scope));
            return (found && values.get(found.name)) || initial;
        };
        if (value === 'view')
            return viewMatrix(part('turn', [0, 0, 0]));
        if (value === 'camera')
            return cameraMatrix(part('azimuth', [0])[0], part('elevation', [0])[0],
                part('distance', [1])[0]);
        return null;
    }

    /**
     * @param {BoundPass} pass
     * @param {string} value
     * @param {number[]} numbers
     */
    writeNamed(pass, value, numbers) {
        const builtIn = pass.description.built_ins.find((one) => one.value === value);
        if (builtIn)
            pass.write(builtIn.uniform, numbers);
    }

    /**
     * The size of a texture that a pass may read.
     * @param {BoundPass} pass
     * @param {import('../look/types.js').ReadDescription} of
     */
    sizeOf(pass, of) {
        if (of.from === 'pass') {
            const index = this.look.passes.findIndex((one) => one.name === of.name);
            return this.plan ? this.plan.targets[index] : null;
        }
        const input = pass.inputs.find((one) => one.from === of.from
            && (of.from !== 'image' || one.name === of.name));
        return input ? this.find(input) : null;
    }

    /**
     * The texture of an input in this frame.
     * @param {import('./bound_pass.js').BoundInput} input
     * @returns {DrawnTexture|null}
     */
    find(input) {
        if (input.from === 'pass')
            return input.pass < 0 ? null : this.targets[input.pass].canvas(input.framesAgo);
        if (input.from === 'source')
            return this.source && this.source.texture(input.framesAgo);
        const key = input.from === 'sound' ? `sound ${input.holds} ${input.columns}`
            : input.from === 'keyboard' ? 'keyboard' : `image ${input.name}`;
        return this.images.get(key) || null;
    }

    /**
     * One texel of transparent black.
     * @param {import('./bound_pass.js').BoundInput} input
     * @returns {DrawnTexture}
     */
    black(input) {
        const gl = this.gl;
        const key = `${input.kind} ${input.numbers}`;
        const known = this.empty.get(key);
        if (known)
            return known;
        const names = { float: 'rgba8', signed: 'rgba8i', unsigned: 'rgba8ui' };
        let made = makeTexture(gl, pixelFormat(gl, names[input.numbers]), 1, 1, false);
        if (input.kind !== 'flat') {
            const target = input.kind === 'cube' ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_3D;
            made = { ...made, target, texture: /** @type {WebGLTexture} */ (gl.createTexture()) };
            gl.bindTexture(target, made.texture);
            if (input.kind === 'cube')
                gl.texStorage2D(target, 1, gl.RGBA8, 1, 1);
            else
                gl.texStorage3D(target, 1, gl.RGBA8, 1, 1, 1);
        }
        this.empty.set(key, made);
        return made;
    }

    /** The picture of the last pass. */
    picture() {
        return this.targets[this.targets.length - 1].canvas(0);
    }
}
