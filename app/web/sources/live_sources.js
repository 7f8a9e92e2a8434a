// Sources that show a camera or the screen.

import { Source } from './source.js';
import { openedFileSettings } from './source_settings.js';
import { VideoFrames, firstVideoFrame, makeVideoElement, setVideoPaused } from './video_frames.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/** The pictures of a media stream. */
class StreamSource extends Source {
    /**
     * @param {string} name
     * @param {HTMLVideoElement} video That plays a stream.
     * @param {string} endMessage For the user when the stream ends.
     */
    constructor(name, video, endMessage) {
        super(name, { ...openedFileSettings(name), prescaled: 1 });
        this.isLive = true;
        this.hasOwnClock = true;
        this.video = video;
        this.stream = /** @type {MediaStream} */ (video.srcObject);
        this.frames = new VideoFrames(video);
        for (const track of this.stream.getTracks()) {
            track.addEventListener('ended', () => {
                this.problem = endMessage;
            });
        }
    }

    /** @returns {SourcePicture | null} */
    pictureAt() {
        return this.frames.takePicture();
    }

    naturalSize() {
        return { width: this.video.videoWidth, height: this.video.videoHeight };
    }

    refresh() {
        this.frames.refresh();
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        setVideoPaused(this.video, isPaused);
    }

    dispose() {
        this.frames.dispose();
        this.video.pause();
        this.video.srcObject = null;
        for (const track of this.stream.getTracks()) {
            track.stop();
        }
    }
}

/** A camera. */
export class CameraSource extends StreamSource {
    /** @param {HTMLVideoElement} video */
    constructor(video) {
        super('Camera', video, 'The camera stopped. Connect it, then open it again.');
    }
}

/** The screen, a window or a tab. */
export class ScreenSource extends StreamSource {
    /** @param {HTMLVideoElement} video */
    constructor(video) {
        super('Screen', video, 'Screen sharing ended. Choose the screen again.');
    }
}

/**
 * A video element that plays a stream.
 * @param {MediaStream} stream
 * @returns {Promise<HTMLVideoElement>}
 */
async function playedStream(stream) {
    const video = makeVideoElement();
    video.srcObject = stream;
    setVideoPaused(video, false);
    try {
        await firstVideoFrame(video);
    } catch {
        stream.getTracks().forEach((track) => track.stop());
        throw new Error('it sent no picture');
    }
    return video;
}

/**
 * @param {unknown} error Of getUserMedia().
 * @returns {Error} With a message for the user.
 */
function cameraError(error) {
    const { name, message } = /** @type {DOMException} */ (error);
    switch (name) {
        case 'NotAllowedError':
            return new Error('The browser refused the camera. Allow it for this page, ' +
                'then open it again.');
        case 'NotFoundError':
            return new Error('No camera found. Connect one, then open it again.');
        case 'NotReadableError':
        case 'AbortError':
            return new Error("Can't read the camera. Close other programs that use it, " +
                'then open it again.');
        default:
            return new Error(`Can't open the camera: ${message}. Try another camera.`);
    }
}

/**
 * @param {unknown} error Of getDisplayMedia().
 * @returns {Error} With a message for the user.
 */
function screenError(error) {
    const { name, message } = /** @type {DOMException} */ (error);
    return new Error(name === 'NotAllowedError' ?
        'Screen sharing was refused or cancelled. Choose a screen or window to share.' :
        `Can't share the screen: ${message}. Choose another screen or window.`);
}

/**
 * Asks for the camera. Throws an Error with a message for the user.
 * @returns {Promise<CameraSource>}
 */
export async function openCameraSource() {
    if (!navigator.mediaDevices || !navigator.mediaDevices.getUserMedia) {
        throw new Error("This page can't use a camera. Open it as a file or over HTTPS.");
    }
    const video = { width: { ideal: 1280 }, height: { ideal: 720 } };
    try {
        const stream = await navigator.mediaDevices.getUserMedia({ video, audio: false });
        return new CameraSource(await playedStream(stream));
    } catch (error) {
        throw cameraError(error);
    }
}

/**
 * Whether the browser can share the screen.
 * @returns {boolean}
 */
export function canShareScreen() {
    return Boolean(navigator.mediaDevices && navigator.mediaDevices.getDisplayMedia);
}

/**
 * Asks for a screen or window. Throws an Error with a message for the user.
 * @returns {Promise<ScreenSource>}
 */
export async function openScreenSource() {
    if (!canShareScreen()) {
        throw new Error("This browser can't share the screen. Use a desktop browser, and open " +
            'the page as a file or over HTTPS.');
    }
    try {
        const stream = await navigator.mediaDevices.getDisplayMedia({ video: true, audio: false });
        return new ScreenSource(await playedStream(stream));
    } catch (error) {
        throw screenError(error);
    }
}
