// Plays a look on a canvas: its clock, values, signal, source and sound.

import { defaultNumbers, exportedNumbers } from '../controls/parameter_text.js';
import { glContextOf, makeGlContext } from '../gl/context.js';
import { Presenter } from '../graph/presenter.js';
import { Renderer } from '../graph/renderer.js';
import { usableNumbers } from '../look/values.js';
import { Beam } from '../signals/beam.js';
import { frameSpan } from '../signals/clock.js';
import { placedAspect, placedRaster, placingOf } from '../sources/placing.js';
import { PageContent } from './content.js';
import { FramePace } from './pace.js';
import { imageTexture } from './picture_images.js';
import { PicturePointer } from './pointer.js';

/**
 * @typedef {import('../look/types.js').LookDescription} PlayedLook
 * @typedef {{width: number, height: number}} PlayedSize
 * @typedef {{hasSound: boolean, needsClick: boolean, sourceName: string, signalName: string,
 *     frame: number, seconds: number, isHalved: boolean, framesPerSecond: number}} PlayerState
 */

const framesPerSecond = 60;
const longestStep = 0.25;  // s of a frame

/** Plays a look. Events: 'values', 'signal', 'source', 'notes', 'state'. */
export class Player extends EventTarget {
    /**
     * Throws with a message if this browser can't draw the look. Call load() before the first
     * frame.
     * @param {PlayedLook} description
     * @param {HTMLCanvasElement} canvas
     * @param {{isTransparent: boolean}} options
     */
    constructor(description, canvas, options) {
        super();
        this.description = description;
        this.canvas = canvas;
        this.isTransparent = options.isTransparent;
        this.context = makeGlContext(canvas, options.isTransparent);
        this.content = new PageContent(description);
        this.pointer = new PicturePointer(canvas);
        this.pace = new FramePace();
        this.beam = new Beam();
        /** @type {Map<string, number[]>} */
        this.values = new Map();
        for (const parameter of description.parameters)
            this.values.set(parameter.name, exportedNumbers(parameter));
        /** @type {PlayedSize} */
        this.size = { width: description.size[0], height: description.size[1] };
        this.isPaused = false;
        this.number = 0;  // of the latest frame
        this.seconds = 0;  // at its end
        this.isLost = false;
        /** @type {import('../sources/source.js').SourcePicture|null} */
        this.sourcePicture = null;
        this.renderer = this.makeRenderer();
        this.presenter = new Presenter(this.context.gl);
        this.listenForLoss();
    }

    /** Reads pictures, source and sound. */
    async load() {
        await this.content.load();
        this.addImages();
    }

    makeRenderer() {
        return new Renderer(this.context, this.description);
    }

    addImages() {
        if (PAGE_HAS_PICTURES)
            for (const [name, picture] of this.content.images)
                this.renderer.images.set(`image ${name}`, imageTexture(this.renderer, name, picture));
    }

    listenForLoss() {
        this.canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault();
            this.isLost = true;
        });
        this.canvas.addEventListener('webglcontextrestored', () => {
            this.context = glContextOf(this.context.gl);
            this.renderer = this.makeRenderer();
            this.presenter = new Presenter(this.context.gl);
            this.addImages();
            if (this.content.source)
                this.content.source.refresh();
            this.isLost = false;
            this.number = 0;
            this.changed('state');
        });
    }

    /** @param {string} type */
    changed(type) {
        this.dispatchEvent(new Event(type));
    }

    get notes() {
        const all = [...this.context.notes, ...this.content.notes];
        if (this.pace.halvings > 0)
            all.push('The picture is drawn smaller, because frames are slow. Make the window '
                + 'smaller for full sharpness.');
        return all;
    }

    /** @returns {PlayerState} */
    get state() {
        const { content } = this;
        return {
            hasSound: content.hasSound,
            needsClick: content.needsClick,
            sourceName: content.sourceName,
            signalName: content.signalName,
            frame: this.number,
            seconds: this.seconds,
            isHalved: this.pace.halvings > 0,
            framesPerSecond: this.pace.framesPerSecond,
        };
    }

    /**
     * @param {string} name
     * @param {number[]} numbers
     */
    setValue(name, numbers) {
        const parameter = this.description.parameters.find((one) => one.name === name);
        if (!parameter)
            return;
        this.values.set(name, usableNumbers(defaultNumbers(parameter), parameter.type, numbers));
        this.changed('values');
    }

    /** @param {string} name */
    resetValue(name) {
        const parameter = this.description.parameters.find((one) => one.name === name);
        if (parameter)
            this.setValue(name, exportedNumbers(parameter));
    }

    resetAll() {
        for (const parameter of this.description.parameters)
            this.values.set(parameter.name, exportedNumbers(parameter));
        this.changed('values');
    }

    get signal() {
        return this.content.signalSpec;
    }

    /** @param {import('../look/types.js').SignalDescription} spec */
    setSignal(spec) {
        this.content.setSignal(spec);
        this.changed('signal');
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        this.isPaused = isPaused;
        this.content.setPaused(isPaused);
        this.changed('state');
    }

    /** Starts again at time 0 with an empty history. */
    restart() {
        this.number = 0;
        this.seconds = 0;
        this.content.restart();
        this.renderer.clearHistory();
        this.changed('state');
    }

    /**
     * Runs a change of the content, and tells about it.
     * @param {() => Promise<void>} change
     */
    async changeContent(change) {
        await change();
        this.sourcePicture = null;
        for (const type of ['source', 'signal', 'notes', 'state'])
            this.changed(type);
    }

    /** @param {File} file */
    openSound(file) {
        return this.changeContent(() => this.content.openSound(file));
    }

    openMicrophone() {
        return this.changeContent(() => this.content.openMicrophone());
    }

    /** Call in the handler of a click. */
    startSound() {
        return this.changeContent(() => this.content.startSound());
    }

    /** @param {File} file */
    openPicture(file) {
        return this.changeContent(() => this.content.openPicture(file));
    }

    /** @param {File} file */
    openVideo(file) {
        return this.changeContent(() => this.content.openVideo(file));
    }

    openCamera() {
        return this.changeContent(() => this.content.openCamera());
    }

    openScreen() {
        return this.changeContent(() => this.content.openScreen());
    }

    resetSource() {
        this.changeContent(() => this.content.reset());
    }

    /**
     * Draws the next frame of a fixed clock.
     * @param {number} [number] of the frame, from 1
     */
    drawFixed(number = this.number + 1) {
        const span = frameSpan(number, framesPerSecond);
        this.drawSpan(number, span.start, span.end, [2000, 1, 1, span.end]);
    }

    /**
     * Draws a frame of the live clock, if time has passed. The clock of a sound goes first.
     * @param {number} elapsed s since the previous call
     */
    drawLive(elapsed) {
        if (this.isPaused || this.isLost)
            return;
        const heard = this.content.soundSeconds();
        const end = heard === null ? this.seconds + Math.min(elapsed, longestStep) : heard;
        const start = end < this.seconds || end - this.seconds > longestStep
            ? Math.max(0, end - 1 / framesPerSecond) : this.seconds;
        if (!(end > start))
            return;
        const now = new Date();
        const midnight = new Date(now.getFullYear(), now.getMonth(), now.getDate());
        this.drawSpan(this.number + 1, start, end, [now.getFullYear(), now.getMonth() + 1,
            now.getDate(), (now.getTime() - midnight.getTime()) / 1000]);
        this.present();
    }

    /**
     * @param {number} number of the frame, from 1
     * @param {number} start s
     * @param {number} end s
     * @param {[number, number, number, number]} date
     */
    drawSpan(number, start, end, date) {
        const { renderer, content, pointer } = this;
        this.number = number;
        this.seconds = end;
        const source = content.source;
        const settings = source && source.settings;
        this.takeSource(end);
        const size = this.sourcePicture || { width: 1, height: 1 };
        const placing = settings ? placingOf(size, settings, this.size) : size;
        renderer.resize(this.size, placing, this.values);
        content.updateSound(renderer, end);
        if (pointer.hasMoved)
            renderer.samples.restartAfterPointer();
        let beam = null;
        if (content.signal) {
            beam = this.beam;
            beam.clear();
            content.signal.trace(start, end, beam);
        }
        renderer.draw({
            time: end,
            delta: end - start,
            number,
            mouse: pointer.position,
            press: pointer.press,
            date,
            aspect: settings ? placedAspect(size, settings) : 1,
            raster: settings ? placedRaster(size, settings, this.size) : null,
        }, this.values, beam, content.signalSpec ? content.signalSpec.settings.fit : undefined);
        pointer.endFrame();
        this.endEvents();
    }

    /**
     * Uploads the source picture of a time if it has changed, or if its place has.
     * @param {number} seconds
     */
    takeSource(seconds) {
        const { source } = this.content;
        const declared = this.description.source;
        if (!source || !declared)
            return;
        const picture = source.pictureAt(seconds);
        if (picture)
            this.sourcePicture = picture;
        if (!this.sourcePicture)
            return;
        const placing = placingOf(this.sourcePicture, source.settings, this.size);
        if (!this.renderer.source)
            this.renderer.resize(this.size, placing, this.values);
        const place = Object.values(placing).join();
        if (!this.renderer.source || (!picture && place === this.renderer.sourcePlace))
            return;
        this.renderer.sourcePlace = place;
        this.renderer.source.set(this.sourcePicture, { placing, encoding: declared.encoding,
            isTopFirst: declared.rows === 'top-first' });
        this.renderer.samples.restart();
    }

    /** Buttons are on in one frame only. */
    endEvents() {
        for (const parameter of this.description.parameters)
            if (parameter.type === 'event')
                this.values.set(parameter.name, [0]);
    }

    /** What the texels of the last pass hold. */
    presentedAs() {
        const { passes, output } = this.description;
        const { target } = passes[passes.length - 1];
        return { isLinear: output === 'linear', isTopFirst: target.rows === 'top-first',
            hasAlpha: this.isTransparent && !!target.alpha };
    }

    /** Shows the latest frame. */
    present() {
        const picture = this.renderer.picture();
        this.canvas.width = picture.width;
        this.canvas.height = picture.height;
        this.presenter.draw(picture, this.presentedAs(), null, picture.width, picture.height);
    }

    /** The latest frame in 8 bits, row 0 at the top. */
    pixels() {
        return this.presenter.read(this.renderer.picture(), this.presentedAs());
    }

    /**
     * The latest frame as a PNG.
     * @returns {Promise<Blob>}
     */
    screenshot() {
        const image = this.pixels();
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).putImageData(image, 0, 0);
        return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob)
            : reject(new Error('The browser could not make a PNG. Try a smaller window.')))));
    }
}
