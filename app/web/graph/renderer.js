// Draws frames of a look: passes in order, samples, history.

import { startProgram } from '../gl/programs.js';
import { Samplers, clearGlCanvas, copyGlCanvas, updateLevels } from '../gl/textures.js';
import { numbersForShaders } from '../look/values.js';
import { BeamBuffers, beamScale } from './beam_buffers.js';
import { BoundPass } from './bound_pass.js';
import { builtInNumbers } from './built_ins.js';
import { InputTextures } from './input_textures.js';
import { cameraMatrix, viewMatrix } from './orbit.js';
import { planTargets, plannedNames, smallestSpot, sourceSizeOf } from './plan.js';
import { AccumulatedSamples, repeatsOf } from './samples.js';
import { shaderText } from './shader_constants.js';
import { PicturePlacer, SourceTextures } from './source_texture.js';
import { PassTarget, supportedFormat } from './targets.js';

/**
 * @typedef {import('../look/types.js').LookDescription} DrawnLook
 * @typedef {import('./built_ins.js').FrameState} FrameState
 * @typedef {{width: number, height: number}} DrawnSize
 */

/**
 * @param {DrawnSize} a
 * @param {DrawnSize} b
 */
function isSameSize(a, b) {
    return a.width === b.width && a.height === b.height;
}

/**
 * Compiles the passes whose texts differ from those before. All are started before the first is
 * needed.
 * @param {WebGL2RenderingContext} gl
 * @param {DrawnLook} look
 * @param {Map<string, number[]>|null} values of constants, null: those in the texts
 * @param {BoundPass[]} before
 */
function boundPasses(gl, look, values, before) {
    const texts = look.passes.map((pass) => [shaderText(look, pass.vertex, values),
        shaderText(look, pass.fragment, values)]);
    const started = texts.map(([vertex, fragment], i) =>
        (before[i] && before[i].text === vertex + fragment ? null
            : startProgram(gl, vertex, fragment)));
    return started.map((program, i) => (program ? new BoundPass(gl, look, i, program,
        texts[i].join('')) : before[i]));
}

/** Draws a look into textures. The picture is that of the last pass. */
export class Renderer {
    #beam;
    #quad;
    /** Parameters that sizes depend on. */
    #plannedNames;
    #viewport = { width: 0, height: 0 };
    #planned = { viewport: { width: 0, height: 0 }, source: { width: 0, height: 0 } };
    /** @type {import('./plan.js').Plan|null} */
    #plan = null;
    /** @type {Map<string, number[]>} values of the latest frame */
    #written = new Map();
    /** @type {string[]} names of the values that differ from it */
    #changed = [];
    /** @type {{across: number, up: number}|null} */
    #spot = null;

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
        this.passes = boundPasses(gl, look, null, []);
        this.inputs = new InputTextures(gl, new Samplers(gl));
        this.#beam = new BeamBuffers(gl);
        this.#quad = this.#makeQuad();
        this.placer = PAGE_HAS_PICTURES ? new PicturePlacer(context) : null;
        this.samples = new AccumulatedSamples(look);
        /** @type {PassTarget[]} */
        this.targets = [];
        /** @type {SourceTextures|null} */
        this.source = null;
        this.#plannedNames = plannedNames(look);
        this.#bindVertices();
    }

    #bindVertices() {
        for (const pass of this.passes) {
            const { draw } = pass.description;
            if (draw === 'points' || draw === 'segments') {
                const { vertices, tint } = this.#beam.verticesFor(pass.linked.program, draw);
                pass.vertices = vertices;
                pass.tint = tint;
            } else if (draw === 'quad')
                pass.vertices = this.#quad;
        }
    }

    /**
     * Compiles the passes with other constants. Throws with the log of the driver, and keeps the
     * passes then.
     * @param {Map<string, number[]>} values
     */
    compile(values) {
        const passes = boundPasses(this.gl, this.look, values, this.passes);
        for (const pass of this.passes)
            if (!passes.includes(pass))
                this.gl.deleteProgram(pass.linked.program);
        this.passes = passes;
        this.#bindVertices();
        this.#written.clear();
        this.samples.restart();
    }

    /** The four corners from (0, 0) to (1, 1), for position and texture coordinates. */
    #makeQuad() {
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
     * Allocates the targets for a size and values, before each frame. Unchanged ones keep their
     * pictures.
     * @param {DrawnSize} viewport
     * @param {DrawnSize} source
     * @param {Map<string, number[]>} values
     */
    resize(viewport, source, values) {
        const { context, look } = this;
        const before = this.#planned;
        this.#noteChanges(values);
        const isPlanned = !this.#changed.some((name) => this.#plannedNames.has(name));
        if (this.#plan && isPlanned && isSameSize(before.viewport, viewport)
            && isSameSize(before.source, source))
            return;
        this.#planned = { viewport: { ...viewport }, source: { ...source } };
        this.#viewport = this.#planned.viewport;
        const terms = { viewport, source, values, largestSide: context.largestSide };
        this.#plan = null;
        const plan = planTargets(look, terms);
        plan.targets.forEach((planned, i) => {
            const isFiltered = look.passes.some((pass) => pass.inputs.some((input) =>
                input.name === look.passes[i].name && input.filter === 'linear'));
            const isBlended = look.passes[i].blend !== 'replace';
            const format = supportedFormat(context, planned.format, isBlended, isFiltered);
            const had = this.targets[i];
            if (had && had.key === PassTarget.keyOf(planned, format))
                return;
            this.targets[i] = new PassTarget(this.gl, planned, format);
            if (had && had.canBeStretched(look.passes[i], this.targets[i]))
                this.targets[i].stretchFrom(had);
            if (had)
                had.dispose();
            this.inputs.forgetCubes();
            this.samples.restart();
        });
        if (PAGE_HAS_PICTURES && this.placer && !this.source && look.source)
            this.source = new SourceTextures(this.placer, supportedFormat(context,
                look.source.format, false, true), plan.sourceSlots, plan.isSourceMipmapped);
        this.#plan = plan;
        this.#spot = smallestSpot(look, plan, terms);
    }

    /** Discards all previous frames. */
    clearHistory() {
        for (const target of this.targets)
            target.clear();
        this.samples.restart();
        this.#beam.clear();
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
            this.#beam.write(beam, { seconds: frame.delta, isFirst: frame.number === 1,
                hasPoints: this.look.passes.some((pass) => pass.draw === 'points'),
                spot: this.#spot,
                scale: beamScale(this.look, values, this.#viewport, fit) });
        if (this.#changed.length > 0)
            this.samples.restartAfter(this.#changed);
        this.passes.forEach((pass, i) => this.#drawPass(pass, i, frame, values, this.#changed));
        for (const name of this.#changed)
            this.#written.set(name, /** @type {number[]} */ (values.get(name)));
        gl.bindVertexArray(null);
        gl.disable(gl.BLEND);
    }

    /**
     * Finds the values that differ from the latest frame.
     * @param {Map<string, number[]>} values
     */
    #noteChanges(values) {
        this.#changed.length = 0;
        for (const [name, now] of values) {
            const had = this.#written.get(name);
            if (had === now)
                continue;
            if (had && String(had) === String(now))
                this.#written.set(name, now);
            else
                this.#changed.push(name);
        }
    }

    /**
     * @param {BoundPass} pass
     * @param {number} index
     * @param {FrameState} frame
     * @param {Map<string, number[]>} values
     * @param {string[]} changed
     */
    #drawPass(pass, index, frame, values, changed) {
        const gl = this.gl;
        const target = this.targets[index];
        const { accumulate, repeat } = pass.description;
        gl.useProgram(pass.linked.program);
        this.#writeParameters(pass, values, changed);
        this.#writeBuiltIns(pass, index, frame, values);
        const held = this.samples.held;
        const draws = accumulate ? this.samples.beginFrame(index, values)
            : repeatsOf(repeat, values);
        if (accumulate && draws === 0)
            copyGlCanvas(gl, target.canvas(1), target.canvas(0));
        for (let i = 0; i < draws; i++) {
            if (i > 0 && pass.readsItself)
                target.advance();
            if (i === 0 || pass.readsItself)
                this.#startTarget(pass, index, !!accumulate && held[index] > 0);
            const sample = accumulate ? held[index] : this.samples.before(index) + i;
            this.#writeNamed(pass, 'samples', [sample]);
            this.#drawShape(pass);
            held[index] += accumulate ? 1 : 0;
        }
        updateLevels(gl, target.canvas(0));
    }

    /**
     * @param {BoundPass} pass
     * @param {number} index
     * @param {boolean} keepsPicture
     */
    #startTarget(pass, index, keepsPicture) {
        const gl = this.gl;
        const target = this.targets[index];
        const canvas = target.canvas(0);
        if (keepsPicture)
            copyGlCanvas(gl, target.canvas(1), canvas);
        else
            clearGlCanvas(gl, canvas, pass.description.blend === 'multiply' ? 1 : 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, canvas.framebuffer);
        gl.viewport(0, 0, canvas.width, canvas.height);
        this.#setBlend(canvas.format.kind === 'float' ? pass.description.blend : 'replace');
        this.inputs.bind(pass.inputs, this);
    }

    /** @param {string} blend */
    #setBlend(blend) {
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
    #drawShape(pass) {
        const gl = this.gl;
        const { draw } = pass.description;
        gl.bindVertexArray(pass.vertices);
        if (draw === 'points' || draw === 'segments')
            this.#beam.draw(draw, pass.tint);
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
    #writeParameters(pass, values, changed) {
        if (changed.length === 0)
            return;
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
    #writeBuiltIns(pass, index, frame, values) {
        const { description } = pass;
        const plan = /** @type {import('./plan.js').Plan} */ (this.#plan);
        const newest = this.source ? this.source.texture(0) : null;
        const source = sourceSizeOf(this.look, description, plan.targets, newest || this.#viewport);
        /** @type {import('./built_ins.js').PassState} */
        const state = {
            target: plan.targets[index],
            output: this.#viewport,
            source,
            isTopFirst: description.target.rows === 'top-first',
            modulo: description.frame_modulo || 0,
            isOwnSource: !description.source,
            read: (of) => this.#sizeOf(pass, of) || source,
        };
        for (const builtIn of description.built_ins) {
            const numbers = builtInNumbers(builtIn, frame, state)
                || this.#orbitNumbers(builtIn.value, description.scope || '', values);
            if (numbers)
                pass.write(builtIn.uniform, numbers);
        }
    }

    /**
     * @param {string} value
     * @param {string} scope
     * @param {Map<string, number[]>} values
     */
    #orbitNumbers(value, scope, values) {
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
    #writeNamed(pass, value, numbers) {
        const builtIn = pass.description.built_ins.find((one) => one.value === value);
        if (builtIn)
            pass.write(builtIn.uniform, numbers);
    }

    /**
     * The size of a texture that a pass may read.
     * @param {BoundPass} pass
     * @param {import('../look/types.js').ReadDescription} of
     */
    #sizeOf(pass, of) {
        if (of.from === 'pass') {
            const index = this.look.passes.findIndex((one) => one.name === of.name);
            return this.#plan ? this.#plan.targets[index] : null;
        }
        const input = pass.inputs.find((one) => one.from === of.from
            && (of.from !== 'image' || one.name === of.name));
        return input ? this.inputs.find(input, this) : null;
    }

    /** The picture of the last pass. */
    picture() {
        return this.targets[this.targets.length - 1].canvas(0);
    }
}
