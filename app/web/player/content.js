// What a page plays: its signal, source picture, pictures and sound, and those the user opens.

import { decodeSound } from '../sound/sound.js';
import { beamStream } from '../sound/beam_stream.js';
import { SoundTexels, silentTexels } from '../sound/sound_texels.js';
import { BeamLoudness, SoundLoudness } from '../signals/audio_loudness.js';
import { makeSignal } from '../signals/signals.js';
import { openSource, openSourceFile } from '../sources/open_source.js';
import { openCameraSource, openScreenSource } from '../sources/live_sources.js';
import { mediaFile, pageMedia } from './media.js';
import { SoundContent, settingsOfOpenedSound } from './sound_content.js';

/**
 * @typedef {import('../look/types.js').LookDescription} ContentLook
 * @typedef {import('../look/types.js').SignalDescription} ContentSignal
 * @typedef {import('../sources/source.js').Source} ContentSource
 * @typedef {import('../sources/source.js').SourcePicture} ContentPicture
 */

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
    #description;
    #media;
    /** @type {SoundTexels|null} null: silence */
    #texels = null;
    #soundName = '';
    #pictureName = '';
    #isSourceChanged = false;
    #isPaused = false;

    /** @param {ContentLook} description */
    constructor(description) {
        this.#description = description;
        this.#media = pageMedia(description.media);
        this.sound = new SoundContent();
        /** @type {ContentSignal|null} */
        this.signalSpec = null;
        /** @type {import('../signals/signal.js').Signal|null} */
        this.signal = null;
        /** @type {import('../look/modulation.js').Loudness|null} null: silence */
        this.loudness = null;
        /** @type {ContentSource|null} */
        this.source = null;
        /** @type {Map<string, ContentPicture[]>} by the name of an image or parameter: one
         * picture, or the six faces of a cube */
        this.images = new Map();
        /** @type {string[]} */
        this.notes = [];
    }

    /** Reads everything that the page brings. */
    async load() {
        const { images, parameters } = this.#description;
        for (const image of images)
            if (image.file || image.faces)
                await this.#loadImage(image.name, image.faces || [image.file || '']);
        for (const parameter of parameters)
            if (parameter.type === 'image')
                await this.resetFile(parameter.name);
        await this.reset();
    }

    /** Plays what the page was exported with. */
    async reset() {
        const { signal, source } = this.#description;
        this.sound.close();
        this.notes = [];
        this.#soundName = this.#pictureName = '';
        if (source)
            this.#replaceSource(await pictureOpeners.named(source.content, this.#media));
        this.#isSourceChanged = false;
        if (signal)
            await this.#playExported(signal);
        for (const parameter of this.#description.parameters)
            if (parameter.type === 'sound')
                await this.resetFile(parameter.name);
        this.#updateTexels();
    }

    /** @param {ContentSignal} signal */
    async #playExported(signal) {
        if (signal.kind === 'audio')
            this.sound.use(await this.#soundOf(String(signal.settings.file)), signal.settings);
        this.setSignal(signal);
    }

    /**
     * Gives a parameter that is a picture or sound the file that the page was exported with.
     * @param {string} name
     */
    async resetFile(name) {
        const parameter = this.#description.parameters.find((one) => one.name === name);
        if (!parameter)
            return;
        if (parameter.type === 'image')
            this.images.delete(name);
        if (parameter.type === 'image' && parameter.value)
            await this.#loadImage(name, [String(parameter.value)]);
        if (parameter.type === 'sound' && parameter.value)
            this.sound.use(await this.#soundOf(String(parameter.value)), settingsOfOpenedSound(2));
    }

    /**
     * @param {string} name
     * @param {string[]} texts paths of pictures, with settings
     */
    async #loadImage(name, texts) {
        const pictures = [];
        for (const text of texts) {
            const source = await pictureOpeners.named(text, this.#media);
            const picture = source && source.pictureAt(0);
            if (picture)
                pictures.push(picture);
        }
        if (pictures.length === texts.length)
            this.images.set(name, pictures);
    }

    /** @param {string} path */
    async #soundOf(path) {
        return decodeSound(await mediaFile(this.#media, path).arrayBuffer());
    }

    /**
     * Draws another signal. One that needs a closed sound or device draws nothing.
     * @param {ContentSignal} spec
     */
    setSignal(spec) {
        const { media } = this.sound;
        const missing = { stdin: true, socket: true, microphone: !media.live,
            audio: !media.sound }[spec.kind] || false;
        this.signal = missing ? null : makeSignal(spec, media);
        this.signalSpec = spec;
        this.notes = !missing ? [] : [spec.kind === 'microphone'
            ? 'The microphone is closed. Click "Use microphone".' : spec.kind === 'audio'
                ? 'The sound is closed. Click "Open sound".'
                : `A page can't draw the signal '${spec.kind}'. Open a sound instead.`];
        if (this.#description.driven_by === 'signal')
            this.sound.setMuted(spec.kind !== 'audio' && spec.kind !== 'microphone');
        this.#updateTexels();
    }

    /** Makes the sound textures and the loudness: of the sound, otherwise of the signal. */
    #updateTexels() {
        const sound = this.sound.stream();
        const stream = sound || (this.signal && beamStream(this.signal));
        this.#texels = stream && new SoundTexels(stream);
        const beam = this.signal && new BeamLoudness(this.signal);
        this.loudness = sound ? new SoundLoudness(sound) : beam;
    }

    /** Makes the signal of a live sound again, after its time has changed. */
    #followSound() {
        if (!this.sound.media.live)
            return;
        if (this.signal && this.signalSpec)
            this.setSignal(this.signalSpec);
        this.#updateTexels();
    }

    /** @param {ContentSource|null} source null: kept */
    #replaceSource(source) {
        if (!source)
            return;
        if (this.source)
            this.source.dispose();
        this.source = source;
        this.#isSourceChanged = true;
        if (this.#isPaused)
            source.setPaused(true);
    }

    /**
     * Opens a file of the user. Sound starts where the browser allows it.
     * @param {'sound'|'picture'|'video'} kind
     * @param {File} file
     */
    async openFile(kind, file) {
        if (kind === 'sound')
            return this.#openSound(file);
        this.#replaceSource(this.#fitted(await pictureOpeners.file(file)));
        this.#pictureName = file.name;
    }

    /**
     * An opened picture fills a look of another program, as in the program.
     * @param {ContentSource|null} source
     */
    #fitted(source) {
        if (source && this.#description.foreign)
            source.settings = { ...source.settings, fit: 'stretch' };
        return source;
    }

    /** @param {File} file */
    async #openSound(file) {
        const sound = await decodeSound(await file.arrayBuffer());
        const settings = settingsOfOpenedSound(sound.channels.length);
        this.sound.use(sound, settings);
        if (this.#description.driven_by === 'signal')
            this.setSignal({ kind: 'audio', settings });
        this.sound.start(0);
        this.#soundName = file.name;
        this.#updateTexels();
    }

    /**
     * Opens a device. Call it in the handler of a click.
     * @param {'microphone'|'camera'|'screen'} kind
     * @param {number} seconds time of the picture
     */
    async openDevice(kind, seconds) {
        if (kind === 'microphone') {
            const { name, channels } = await this.sound.openMicrophone(seconds);
            this.#soundName = name;
            if (this.#description.driven_by === 'signal')
                this.setSignal({ kind, settings: settingsOfOpenedSound(channels) });
            this.#updateTexels();
            return;
        }
        this.#replaceSource(this.#fitted(await pictureOpeners[kind]()));
        this.#pictureName = '';
    }

    /**
     * Opens a file for a parameter that is a picture or sound.
     * @param {string} name
     * @param {File} file
     */
    async openParameterFile(name, file) {
        const parameter = this.#description.parameters.find((one) => one.name === name);
        if (parameter && parameter.type === 'sound')
            return this.#openSound(file);
        const source = await pictureOpeners.file(file);
        const picture = source && source.pictureAt(0);
        if (picture)
            this.images.set(name, [picture]);
    }

    /**
     * Starts the sound. Call it in the handler of a click.
     * @param {number} seconds time of the picture
     */
    startSound(seconds) {
        this.sound.start(seconds);
        this.#followSound();
    }

    /**
     * @param {boolean} isPaused
     * @param {number} seconds time of the picture
     */
    setPaused(isPaused, seconds) {
        this.#isPaused = isPaused;
        this.sound.setPaused(isPaused, seconds);
        if (this.source)
            this.source.setPaused(isPaused);
        if (!isPaused)
            this.#followSound();
    }

    /** Starts again at time 0. */
    restart() {
        this.sound.restart();
        this.#followSound();
    }

    /** Whether the user has changed the signal, or opened something. */
    get isChanged() {
        const { signal } = this.#description;
        return this.#soundName !== '' || this.#isSourceChanged
            || (!!signal && JSON.stringify(signal) !== JSON.stringify(this.signalSpec));
    }

    /** Names of the source and of the signal for the user. */
    get names() {
        const kind = this.signalSpec ? this.signalSpec.kind : '';
        const known = (this.#description.generators || []).find((one) => one.kind === kind);
        const isSound = kind === 'audio' || kind === 'microphone';
        const file = this.signalSpec ? String(this.signalSpec.settings.file || '') : '';
        return {
            source: this.#pictureName || (this.source ? this.source.name : this.#soundName),
            signal: (isSound && this.#soundName) || file.replace(/^.*\//, '')
                || (known ? known.label : kind.charAt(0).toUpperCase() + kind.slice(1)),
        };
    }

    /**
     * The rows of a sound texture.
     * @param {{holds: string, columns: number}} texture
     * @param {number} seconds
     */
    soundRows(texture, seconds) {
        return this.#texels ? this.#texels.rows(texture, seconds) : silentTexels(texture);
    }
}
