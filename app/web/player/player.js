// Plays a look on a canvas: what the controls and the page change.

import { defaultNumbers, exportedNumbers } from '../controls/parameter_text.js';
import { usableNumbers } from '../look/values.js';
import { PageContent } from './content.js';
import { FrameLoop } from './frame_loop.js';
import { LookDrawing } from './look_drawing.js';

/**
 * @typedef {import('../look/types.js').LookDescription} PlayedLook
 * @typedef {import('../look/types.js').SignalDescription} PlayedSignal
 * @typedef {{hasSound: boolean, needsClick: boolean, sourceName: string, signalName: string,
 *     isMediaChanged: boolean, frame: number, seconds: number, isHalved: boolean,
 *     framesPerSecond: number}} PlayerState
 */

/** Plays a look. Events: 'values', 'signal', 'source', 'notes', 'state'. */
export class Player extends EventTarget {
    #content;
    #drawing;
    /** @type {string[]} */
    #failures = [];

    /**
     * Throws with a message if this browser can't draw the look. Call load() before the first
     * frame.
     * @param {PlayedLook} description
     * @param {HTMLCanvasElement} canvas
     * @param {{isTransparent: boolean}} options
     */
    constructor(description, canvas, { isTransparent }) {
        super();
        this.description = description;
        this.canvas = canvas;
        /** @type {Map<string, number[]>} */
        this.values = new Map();
        for (const parameter of description.parameters)
            this.values.set(parameter.name, exportedNumbers(parameter));
        this.#drawing = new LookDrawing(description, canvas, isTransparent);
        this.#content = new PageContent(description);
        this.frames = new FrameLoop(this.#drawing, this.#content, this.values,
            description.parameters);
        this.#drawing.listenForLoss(this.#content, (error) => {
            if (error)
                this.#failures.push(error.message);
            this.frames.replay();
            this.#changed('notes');
        });
    }

    /** Reads pictures, source and sound. */
    async load() {
        await this.#content.load();
        this.#drawing.updateImages(this.#content);
    }

    /** @param {string[]} types */
    #changed(...types) {
        this.frames.invalidate();
        for (const type of types)
            this.dispatchEvent(new Event(type));
    }

    get notes() {
        const { source, sound, notes } = this.#content;
        const problems = [source ? source.problem : '', sound.problem].filter((text) => text);
        const all = [...this.#failures, ...this.#drawing.notes, ...notes, ...problems];
        if (this.frames.pace.halvings > 0)
            all.push('Frames are slow, so the picture has fewer pixels. Use a smaller window or a '
                + 'faster device.');
        return all;
    }

    /** @returns {PlayerState} */
    get state() {
        const content = this.#content;
        const { number, seconds, pace } = this.frames;
        return {
            hasSound: content.sound.hasSound,
            needsClick: content.sound.needsClick,
            sourceName: content.names.source,
            signalName: content.names.signal,
            isMediaChanged: content.isChanged,
            frame: number,
            seconds,
            isHalved: pace.halvings > 0,
            framesPerSecond: pace.framesPerSecond,
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
        this.values.set(name, usableNumbers(defaultNumbers(parameter), parameter, numbers));
        this.#changed('values');
    }

    /** @param {string} name */
    resetValue(name) {
        const parameter = this.description.parameters.find((one) => one.name === name);
        if (parameter && (parameter.type === 'image' || parameter.type === 'sound'))
            this.#changeContent(async () => {
                await this.#content.resetFile(name);
                this.#drawing.updateImages(this.#content);
            });
        else if (parameter)
            this.setValue(name, exportedNumbers(parameter));
    }

    get signal() {
        return this.#content.signalSpec;
    }

    /** @param {PlayedSignal} spec */
    setSignal(spec) {
        this.#content.setSignal(spec);
        this.#changed('signal');
    }

    get isPaused() {
        return this.frames.isPaused;
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        this.frames.setPaused(isPaused);
        this.dispatchEvent(new Event('state'));
    }

    /** Starts again at time 0 with an empty history. */
    restart() {
        this.frames.restart();
        this.#changed('state');
    }

    /** @param {() => Promise<void>} change */
    async #changeContent(change) {
        await change();
        this.#changed('source', 'signal', 'notes', 'state');
    }

    /**
     * Opens a file of the user.
     * @param {'sound'|'picture'|'video'} kind
     * @param {File} file
     */
    async openFile(kind, file) {
        await this.#changeContent(() => this.#content.openFile(kind, file));
        if (kind === 'sound')
            this.restart();
    }

    /**
     * Call it in the handler of a click.
     * @param {'microphone'|'camera'|'screen'} kind
     */
    openDevice(kind) {
        return this.#changeContent(() => this.#content.openDevice(kind, this.frames.seconds));
    }

    /**
     * Opens a picture or sound for a parameter.
     * @param {string} name
     * @param {File} file
     */
    openParameterFile(name, file) {
        return this.#changeContent(async () => {
            await this.#content.openParameterFile(name, file);
            this.#drawing.updateImages(this.#content);
        });
    }

    /** Call it in the handler of a click. The picture of a new sound starts with it. */
    async startSound() {
        if (this.#content.sound.isNew)
            this.frames.restart();
        this.#content.startSound(this.frames.seconds);
        this.#changed('state');
    }

    /** Plays what the page was exported with. */
    async resetSource() {
        await this.#changeContent(() => this.#content.reset());
        if (this.#content.sound.hasSound)
            this.startSound();
    }

    /**
     * The latest frame as a PNG.
     * @returns {Promise<Blob>}
     */
    screenshot() {
        const copy = this.#drawing.copy();
        return new Promise((resolve, reject) => copy.toBlob((blob) => (blob ? resolve(blob)
            : reject(new Error('The browser could not make a PNG. Try a smaller window.')))));
    }
}
