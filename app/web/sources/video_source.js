// A source that is a video file.

import { pictureWithoutPrescale, prescaleOf } from './decoding.js';
import { filmNumberAt, filmNumberWithin, usualFilmRate } from './film_time.js';
import { sizeWithoutPrescale } from './prescaled.js';
import { Source } from './source.js';
import { VideoFrames, firstVideoFrame, makeVideoElement, setVideoPaused } from './video_frames.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */
/** @typedef {import('./source_settings.js').SourceSettings} SourceSettings */

/**
 * A video and what browsers do not report about it.
 * @typedef {object} VideoFile
 * @property {Blob | string} video A file, or its URL.
 * @property {number} [rate] Pictures per second. 0: unknown.
 * @property {number} [count] Number of pictures. 0: unknown.
 */

const slowestPlayback = 0.0625;
const fastestPlayback = 16;

/** Plays by its own clock, until prepare() is called. From then on it shows exact times. */
export class VideoSource extends Source {
    /**
     * Use openVideo(), which waits for the first picture.
     * @param {string} name
     * @param {SourceSettings} settings
     * @param {HTMLVideoElement} video With its first picture.
     * @param {{rate: number, count: number}} film 0: unknown.
     */
    constructor(name, settings, video, film) {
        super(name, settings);
        this.hasOwnClock = true;
        this.video = video;
        this.ownRate = film.rate > 0 ? film.rate : usualFilmRate;
        this.longestPicture = film.rate > 0 ? 1 / film.rate : 0.25;  // s
        this.rate = settings.rate > 0 ? settings.rate : this.ownRate;
        this.count = film.count > 0 ? film.count :
            Math.max(Math.round(video.duration * this.ownRate), 1);
        this.frames = new VideoFrames(video);
        this.prescale = prescaleOf(this.frames.picture(), settings.prescaled);
        this.isExact = false;
        this.lastSeconds = 0;
        video.loop = settings.loops;
        video.playbackRate = Math.min(
            Math.max(this.rate / this.ownRate, slowestPlayback), fastestPlayback);
    }

    /**
     * Restarts with the clock of the player.
     * @param {number} seconds
     * @returns {SourcePicture | null}
     */
    pictureAt(seconds) {
        const isRestarted = seconds < this.lastSeconds;
        this.lastSeconds = seconds;
        if (isRestarted && !this.isExact) {
            this.video.currentTime = this.timeAt(seconds);
        }
        const picture = this.frames.takePicture();
        return picture ? pictureWithoutPrescale(picture, this.prescale) : null;
    }

    naturalSize() {
        return sizeWithoutPrescale(this.frames.picture(), this.prescale);
    }

    /**
     * Stops the video and seeks the picture of this time.
     * @param {number} seconds
     * @returns {Promise<void>}
     */
    async prepare(seconds) {
        this.isExact = true;
        this.video.pause();
        const time = this.timeAt(seconds);
        if (Math.abs(this.video.currentTime - time) < 1e-5 && !this.video.seeking) {
            return;
        }
        try {
            await this.frames.seek(time, this.longestPicture);
        } catch {
            throw new Error(`Can't play '${this.name}' at ${time} s. Convert the video, ` +
                'then export the page again.');
        }
    }

    refresh() {
        this.frames.refresh();
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        setVideoPaused(this.video, isPaused || this.isExact);
    }

    dispose() {
        this.frames.dispose();
        this.video.pause();
        if (this.video.src.startsWith('blob:')) {
            URL.revokeObjectURL(this.video.src);
        }
        this.video.removeAttribute('src');
        this.video.load();
    }

    /**
     * The middle of the picture's time in the video, which no rounding moves to another picture.
     * @param {number} seconds
     * @returns {number}
     */
    timeAt(seconds) {
        const number = filmNumberAt(seconds, this.rate);
        const within = filmNumberWithin(number, this.count, this.settings.loops);
        return (within + 0.5) / this.ownRate;
    }
}

/**
 * Opens a video and plays it.
 * @param {string} name
 * @param {SourceSettings} settings
 * @param {VideoFile} file
 * @returns {Promise<VideoSource>}
 */
export async function openVideo(name, settings, { video: content, rate = 0, count = 0 }) {
    const video = makeVideoElement();
    video.src = typeof content === 'string' ? content : URL.createObjectURL(content);
    try {
        await firstVideoFrame(video);
    } catch {
        throw new Error(`Can't play '${name}': this browser does not know its format. ` +
            'Use MP4 with H.264 or WebM with VP9.');
    }
    if (video.videoWidth === 0) {
        throw new Error(`Can't play '${name}': it contains sound only. Choose a video.`);
    }
    const source = new VideoSource(name, settings, video, { rate, count });
    source.setPaused(false);
    return source;
}
