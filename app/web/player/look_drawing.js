// Draws the frames of a look on a canvas, with its source picture, beam and sound textures.

import { pixelFormat } from '../gl/formats.js';
import { glContextOf, makeGlContext } from '../gl/context.js';
import { makeTexture } from '../gl/textures.js';
import { Presenter } from '../graph/presenter.js';
import { Renderer } from '../graph/renderer.js';
import { makeModulations } from '../look/modulation.js';
import { Beam } from '../signals/beam.js';
import { placedAspect, placedRaster, placingOf } from '../sources/placing.js';
import { ConstantChanges } from './constant_changes.js';
import { KeyboardKeys } from './keyboard.js';
import { imageTexture } from './picture_images.js';
import { PicturePointer } from './pointer.js';

/**
 * @typedef {import('../look/types.js').LookDescription} DrawingLook
 * @typedef {import('../sources/source.js').SourcePicture} DrawingPicture
 * @typedef {import('../sources/source_settings.js').SourceSettings} DrawingSettings
 * @typedef {{number: number, start: number, end: number, now: number,
 *     date: [number, number, number, number]}} DrawnSpan
 *     `number` of the frame from 1, its time span in s, and its date as in FrameState.
 *     `now` is later than `end` in a frame that is drawn again.
 * @typedef {{placing: import('../sources/placing.js').Placing|null, aspect: number,
 *     raster: import('../graph/built_ins.js').SourceRaster|null,
 *     settings: DrawingSettings|null, picture: [number, number], viewport: [number, number]}}
 *     PlacedSource
 */

const withoutSource = { width: 1, height: 1 };

/**
 * @param {Float32Array} levels
 * @returns {Float32Array} opaque grey RGBA
 */
function greyTexels(levels) {
    const texels = new Float32Array(4 * levels.length).fill(1);
    levels.forEach((level, i) => texels.fill(level, 4 * i, 4 * i + 3));
    return texels;
}

/** The picture of a look. It is lost and restored with the WebGL context. */
export class LookDrawing {
    #description;
    #isTransparent;
    #context;
    #renderer;
    #presenter;
    #constants;
    #beam = new Beam();
    /** @type {KeyboardKeys|null} */
    #keyboard = null;
    #modulations;
    /** @type {Map<string, number[]>} values of the latest frame with modulations */
    #modulated = new Map();
    /** @type {import('../sources/source.js').Source|null} */
    #source = null;
    /** @type {DrawingPicture|null} */
    #picture = null;
    /** @type {PlacedSource} where the source picture is, for these terms */
    #placed = { placing: null, aspect: 1, raster: null, settings: null, picture: [0, 0],
        viewport: [0, 0] };
    /** @type {import('../graph/built_ins.js').FrameState} */
    #frame = { time: 0, delta: 0, number: 0, mouse: [0, 0], press: [0, 0, 0, 0],
        date: [2000, 1, 1, 0], aspect: 1, raster: null };

    /**
     * Throws with a message if this browser can't draw the look.
     * @param {DrawingLook} description
     * @param {HTMLCanvasElement} canvas
     * @param {boolean} isTransparent
     */
    constructor(description, canvas, isTransparent) {
        this.#description = description;
        this.#isTransparent = isTransparent;
        this.canvas = canvas;
        this.#context = makeGlContext(canvas, isTransparent);
        this.#renderer = new Renderer(this.#context, description);
        this.#presenter = new Presenter(this.#context.gl);
        this.#constants = new ConstantChanges(description);
        this.#modulations = makeModulations(description.parameters, description.tempo);
        this.pointer = new PicturePointer(canvas);
        this.size = { width: description.size[0], height: description.size[1] };
        this.isLost = false;
        if (description.passes.some((pass) => pass.inputs.some((one) => one.from === 'keyboard')))
            this.#keyboard = new KeyboardKeys();
    }

    /**
     * Calls a function when the context was restored. The drawing has no history then.
     * @param {import('./content.js').PageContent} content
     * @param {(error: Error|null) => void} restored
     */
    listenForLoss(content, restored) {
        this.canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault();
            this.isLost = true;
        });
        this.canvas.addEventListener('webglcontextrestored', () => {
            try {
                this.#context = glContextOf(this.#context.gl);
                this.#renderer = new Renderer(this.#context, this.#description);
                this.#presenter = new Presenter(this.#context.gl);
                this.#constants = new ConstantChanges(this.#description);
                this.updateImages(content);
                if (content.source)
                    content.source.refresh();
                this.isLost = false;
                restored(null);
            } catch (error) {
                restored(/** @type {Error} */ (error));
            }
        });
    }

    /**
     * Compiles the passes with changed constants. True if it did. Throws if the browser can't, and
     * keeps the passes then.
     * @param {Map<string, number[]>} values
     * @param {boolean} isPatient waits for a slider that is dragged
     */
    updateConstants(values, isPatient) {
        if (!this.#constants.isDue(values, performance.now() / 1000, isPatient))
            return false;
        this.#renderer.compile(values);
        return true;
    }

    /** What the browser lacks. */
    get notes() {
        return this.isLost ? ['The browser lost the graphics context. Reload the page if the '
            + 'picture does not come back.'] : this.#context.notes;
    }

    /** Frames after which the picture no longer depends on older ones, as far as is known. */
    get settleFrames() {
        const { targets } = this.#renderer;  // none before the first frame
        const isHistoric = targets.some((target) => target.slots.length > 1);
        return isHistoric || targets.length === 0 ? Math.max(this.#description.settle_frames, 1) : 1;
    }

    /**
     * Uploads the pictures of the look and of its parameters.
     * @param {import('./content.js').PageContent} content
     */
    updateImages({ images }) {
        if (!PAGE_HAS_PICTURES)
            return;
        const textures = this.#renderer.inputs.named;
        for (const key of [...textures.keys()])
            if (key.startsWith('image ')) {
                this.#context.gl.deleteTexture((textures.get(key) || { texture: null }).texture);
                textures.delete(key);
            }
        for (const [name, pictures] of images)
            textures.set(`image ${name}`, imageTexture(this.#renderer, name, pictures));
        this.#renderer.samples.restart();
    }

    /** Discards all previous frames. */
    clearHistory() {
        this.#renderer.clearHistory();
    }

    /**
     * Draws a frame into the texture that present() shows.
     * @param {DrawnSpan} span
     * @param {Map<string, number[]>} chosen values without modulations
     * @param {import('./content.js').PageContent} content
     */
    draw(span, chosen, content) {
        const renderer = this.#renderer;
        const { signal, signalSpec, loudness } = content;
        const values = this.#modulations.apply(chosen, span.end, loudness, this.#modulated);
        this.#takeSource(content.source, span, values);
        this.#updateSound(content, span.end);
        if (this.#keyboard)
            this.#keyboard.update(renderer.gl, renderer.inputs.named);
        if (this.pointer.hasMoved)
            renderer.samples.restartAfterPointer();
        this.pointer.beginFrame(this.size);
        if (signal) {
            this.#beam.clear();
            signal.trace(span.start, span.end, this.#beam);
        }
        const frame = this.#frame;
        frame.time = span.end;
        frame.delta = span.end - span.start;
        frame.number = span.number;
        frame.mouse = this.pointer.position;
        frame.press = this.pointer.press;
        frame.date = span.date;
        frame.aspect = this.#placed.aspect;
        frame.raster = this.#placed.raster;
        renderer.draw(frame, values, signal && this.#beam, signalSpec
            ? signalSpec.settings.fit : undefined);
        this.pointer.endFrame();
        if (this.#keyboard)
            this.#keyboard.endFrame();
    }

    /**
     * Prepares the targets, and uploads the source picture of a time if it or its place has
     * changed.
     * @param {import('../sources/source.js').Source|null} source
     * @param {DrawnSpan} span
     * @param {Map<string, number[]>} values
     */
    #takeSource(source, span, values) {
        const renderer = this.#renderer;
        const declared = this.#description.source;
        if (source !== this.#source)
            this.#picture = null;
        this.#source = source;
        const time = source && source.hasOwnClock ? span.now : span.end;
        const picture = source && declared ? source.pictureAt(time) : null;
        this.#picture = picture || this.#picture;
        const isMoved = !!source && !!this.#picture
            && this.#updatePlace(this.#picture, source.settings);
        const { placing } = this.#placed;
        renderer.resize(this.size, placing || withoutSource, values);
        if (!declared || !this.#picture || !placing || !renderer.source)
            return;
        if (!picture && !isMoved && renderer.source.texture(0))
            return;
        renderer.source.set(this.#picture, { placing, encoding: declared.encoding,
            isTopFirst: declared.rows === 'top-first' });
        renderer.samples.restart();
    }

    /**
     * Computes where the source picture is. True if that has changed.
     * @param {{width: number, height: number}} picture
     * @param {DrawingSettings} settings
     */
    #updatePlace({ width, height }, settings) {
        const { picture, viewport, settings: before } = this.#placed;
        if (picture[0] === width && picture[1] === height && before === settings
            && viewport[0] === this.size.width && viewport[1] === this.size.height)
            return false;
        const size = { width, height };
        this.#placed = { placing: placingOf(size, settings, this.size),
            aspect: placedAspect(size, settings),
            raster: placedRaster(size, settings, this.size), settings, picture: [width, height],
            viewport: [this.size.width, this.size.height] };
        return true;
    }

    /**
     * Uploads the textures of sound that passes read.
     * @param {import('./content.js').PageContent} content
     * @param {number} seconds
     */
    #updateSound(content, seconds) {
        const { gl, inputs, passes } = this.#renderer;
        for (const pass of passes)
            for (const input of pass.inputs) {
                if (input.from !== 'sound')
                    continue;
                const key = `sound ${input.holds} ${input.columns}`;
                const rows = content.soundRows(input, seconds);
                const texture = inputs.named.get(key)
                    || makeTexture(gl, pixelFormat(gl, 'rgba32f'), rows.width, rows.height, false);
                inputs.named.set(key, texture);
                gl.bindTexture(gl.TEXTURE_2D, texture.texture);
                gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rows.width, rows.height, gl.RGBA, gl.FLOAT,
                    greyTexels(rows.values));
            }
    }

    /**
     * What the texels of the last pass hold.
     * @returns {import('../graph/presenter.js').PresentedAs}
     */
    #presentedAs() {
        const { passes, output } = this.#description;
        const { target } = passes[passes.length - 1];
        const alpha = target.alpha ? 'own' : 'from-black';
        return { isLinear: output === 'linear', isTopFirst: target.rows === 'top-first',
            alpha: this.#isTransparent ? alpha : 'opaque' };
    }

    /** Shows the latest frame. */
    present() {
        const picture = this.#renderer.picture();
        // Each assignment clears the canvas.
        if (this.canvas.width !== picture.width || this.canvas.height !== picture.height) {
            this.canvas.width = picture.width;
            this.canvas.height = picture.height;
        }
        this.#presenter.draw(picture, this.#presentedAs(), null, picture.width, picture.height);
    }

    /** Waits until the GPU has drawn everything. */
    finish() {
        this.#context.gl.finish();
    }

    /**
     * The latest frame in 8 bits as a canvas.
     * @returns {HTMLCanvasElement}
     */
    copy() {
        const image = this.#presenter.read(this.#renderer.picture(), this.#presentedAs());
        const copy = document.createElement('canvas');
        copy.width = image.width;
        copy.height = image.height;
        /** @type {CanvasRenderingContext2D} */ (copy.getContext('2d')).putImageData(image, 0, 0);
        return copy;
    }
}
