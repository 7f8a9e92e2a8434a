// What a page plays: its signal, source pictures and sound, and those that the user opens.

import { SoundPlayer } from '../sound/sound_player.js';
import { decodeSound } from '../sound/sound.js';
import { openMicrophone } from '../sound/live_sound.js';
import { soundStream } from '../signals/audio_stream.js';
import { SoundTexels } from '../sound/sound_texels.js';
import { makeSignal } from '../signals/signals.js';
import { makeTexture } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';
import { openSource, openSourceFile } from '../sources/open_source.js';
import { openCameraSource, openScreenSource } from '../sources/live_sources.js';
import { mediaFile, pageMedia } from './media.js';

/**
 * @typedef {import('../look/types.js').LookDescription} ContentLook
 * @typedef {import('../look/types.js').SignalDescription} ContentSignal
 * @typedef {import('../sources/source.js').Source} ContentSource
 * @typedef {import('../sources/source.js').SourcePicture} ContentPicture
 */

/** Settings of a sound that the user opens. */
const openedSoundSettings = { loop: 'on', start: 0, end: 0, mode: 'xy', level: 1, auto_gain: 'off',
    upsample: 4, channel: 'mean', fit: 'whole', x: 1, y: 2, intensity: 0, r: 0, g: 0, b: 0 };

/**
 * How pictures are opened. A page without pictures does not contain the code for it.
 * @type {{named: (text: string, media: Map<string, any>) => Promise<ContentSource|null>,
 *     file: (file: File) => Promise<ContentSource|null>,
 *     camera: () => Promise<ContentSource|null>, screen: () => Promise<ContentSource|null>}}
 */
const pictureOpeners = PAGE_HAS_PICTURES
    ? { named: openSource, file: openSourceFile, camera: openCameraSource,
        screen: openScreenSource }
    : { named: noSource, file: noSource, camera: noSource, screen: noSource };

/** @returns {Promise<ContentSource|null>} */
function noSource() {
    return Promise.resolve(null);
}

/** The signal, source and sound of a look. */
export class PageContent {
    /** @param {ContentLook} description */
    constructor(description) {
        this.description = description;
        this.media = pageMedia(description.media);
        /** @type {ContentSignal|null} */
        this.signalSpec = null;
        /** @type {import('../signals/signal.js').Signal|null} */
        this.signal = null;
        /** @type {ContentSource|null} */
        this.source = null;
        /** @type {import('../sound/sound.js').Sound|null} */
        this.sound = null;
        /** @type {SoundPlayer|null} */
        this.player = null;
        /** @type {import('../sound/live_sound.js').Microphone|null} */
        this.microphone = null;
        /** @type {SoundTexels|null} */
        this.texels = null;
        /** @type {Map<string, ContentPicture>} pictures by the name of an image or parameter */
        this.images = new Map();
        /** @type {string[]} */
        this.notes = [];
        this.openedName = '';
    }

    /** Reads everything that the page brings. */
    async load() {
        await this.loadImages();
        await this.reset();
    }

    async loadImages() {
        const { images, parameters } = this.description;
        for (const image of images)
            if (image.file)
                await this.loadImage(image.name, image.file);
        for (const parameter of parameters)
            if (parameter.type === 'image' && parameter.value)
                await this.loadImage(parameter.name, String(parameter.value));
    }

    /**
     * @param {string} name
     * @param {string} text path of a picture, with settings
     */
    async loadImage(name, text) {
        const source = await pictureOpeners.named(text, this.media);
        const picture = source && source.pictureAt(0);
        if (picture)
            this.images.set(name, picture);
    }

    /** Plays what the page was exported with. */
    async reset() {
        const { signal, source } = this.description;
        this.closeSound();
        this.openedName = '';
        if (source)
            this.replaceSource(await pictureOpeners.named(source.content, this.media));
        if (signal)
            await this.playExported(signal);
        await this.loadSoundParameter();
    }

    /** @param {ContentSignal} signal */
    async playExported(signal) {
        if (signal.kind === 'microphone' || signal.kind === 'stdin' || signal.kind === 'socket') {
            this.signalSpec = signal;
            this.signal = null;
            this.notes = [`The signal '${signal.kind}' needs a device. Use a button of the panel.`];
            return;
        }
        if (signal.kind === 'audio')
            this.useSound(await this.soundOf(String(signal.settings.file)), signal.settings);
        this.setSignal(signal);
    }

    /** A sound that a parameter of the look chooses. */
    async loadSoundParameter() {
        const chosen = this.description.parameters.find((one) => one.type === 'sound'
            && one.value);
        if (chosen)
            this.useSound(await this.soundOf(String(chosen.value)), openedSoundSettings);
    }

    /** @param {string} path */
    async soundOf(path) {
        return decodeSound(await mediaFile(this.media, path).arrayBuffer());
    }

    /** @param {ContentSignal} spec */
    setSignal(spec) {
        this.signal = makeSignal(spec, { sound: this.sound || undefined,
            live: this.microphone ? this.microphone.sound : undefined });
        this.signalSpec = spec;
    }

    /**
     * @param {import('../sound/sound.js').Sound} sound
     * @param {Object<string, string|number>} settings
     */
    useSound(sound, settings) {
        this.closeSound();
        this.sound = sound;
        this.player = new SoundPlayer(sound, settings);
        this.texels = new SoundTexels(soundStream(sound, { first: 0, end: 0, loops: true }));
    }

    closeSound() {
        if (this.player)
            this.player.close();
        if (this.microphone)
            this.microphone.close();
        this.player = null;
        this.microphone = null;
        this.sound = null;
        this.texels = null;
    }

    /** @param {ContentSource|null} source null: kept */
    replaceSource(source) {
        if (!source)
            return;
        if (this.source)
            this.source.dispose();
        this.source = source;
    }

    /** @param {File} file */
    async openSound(file) {
        const sound = await decodeSound(await file.arrayBuffer());
        this.useSound(sound, openedSoundSettings);
        this.openedName = file.name;
        if (this.description.driven_by === 'signal')
            this.setSignal({ kind: 'audio', settings: openedSoundSettings });
        await this.startSound();
    }

    async openMicrophone() {
        const microphone = await openMicrophone();
        this.closeSound();
        this.microphone = microphone;
        this.openedName = microphone.name || 'Microphone';
        if (this.description.driven_by === 'signal')
            this.setSignal({ kind: 'microphone', settings: openedSoundSettings });
    }

    async startSound() {
        if (this.microphone)
            this.microphone.resume();
        if (this.player)
            await this.player.start();
    }

    /** @param {File} file */
    async openPicture(file) {
        this.replaceSource(await pictureOpeners.file(file));
        this.openedName = file.name;
    }

    /** @param {File} file */
    openVideo(file) {
        return this.openPicture(file);
    }

    async openCamera() {
        this.replaceSource(await pictureOpeners.camera());
        this.openedName = 'Camera';
    }

    async openScreen() {
        this.replaceSource(await pictureOpeners.screen());
        this.openedName = 'Screen';
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        if (this.player)
            this.player.setPaused(isPaused);
        if (this.source)
            this.source.setPaused(isPaused);
    }

    /** Starts again at time 0. */
    restart() {
        if (this.player)
            this.player.restart();
    }

    get hasSound() {
        return this.player !== null || this.microphone !== null;
    }

    get needsClick() {
        return (this.player !== null && this.player.needsClick)
            || (this.microphone !== null && this.microphone.needsClick);
    }

    /**
     * The time of the sound, which the picture follows. Null without a playing sound.
     * @returns {number|null} s
     */
    soundSeconds() {
        if (this.microphone)
            return this.microphone.needsClick ? null : this.microphone.seconds();
        return this.player && this.player.isPlaying ? this.player.seconds() : null;
    }

    get sourceName() {
        return this.openedName || (this.source ? this.source.name : '');
    }

    get signalName() {
        return this.openedName || (this.signalSpec ? this.signalSpec.kind : '');
    }

    /**
     * Uploads the textures of sound that passes read.
     * @param {import('../graph/renderer.js').Renderer} renderer
     * @param {number} seconds
     */
    updateSound(renderer, seconds) {
        const { gl } = renderer;
        for (const pass of renderer.passes)
            for (const input of pass.inputs) {
                if (input.from !== 'sound' || !this.texels)
                    continue;
                const key = `sound ${input.holds} ${input.columns}`;
                const rows = this.texels.rows({ holds: input.holds, columns: input.columns },
                    seconds);
                const texture = renderer.images.get(key)
                    || makeTexture(gl, pixelFormat(gl, 'r32f'), rows.width, rows.height, false);
                renderer.images.set(key, texture);
                gl.bindTexture(gl.TEXTURE_2D, texture.texture);
                gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rows.width, rows.height, gl.RED, gl.FLOAT,
                    rows.values);
            }
    }
}
