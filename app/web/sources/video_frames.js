// Video elements and their pictures.

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/**
 * Waits until a video element has its first picture. Rejects with an Event if it cannot.
 * @param {HTMLVideoElement} video With a source.
 * @returns {Promise<void>}
 */
export function firstVideoFrame(video) {
    const currentData = 2;  // HAVE_CURRENT_DATA
    return new Promise((resolve, reject) => {
        if (video.readyState >= currentData) {
            resolve();
            return;
        }
        video.addEventListener('loadeddata', () => resolve(), { once: true });
        video.addEventListener('error', reject, { once: true });
    });
}

/**
 * A silent video element. It is not part of the page.
 * @returns {HTMLVideoElement}
 */
export function makeVideoElement() {
    const video = document.createElement('video');
    video.muted = true;
    video.playsInline = true;
    video.preload = 'auto';
    return video;
}

/**
 * Starts a video, or stops it. A browser may refuse to start it before the first click.
 * @param {HTMLVideoElement} video
 * @param {boolean} isPaused
 */
export function setVideoPaused(video, isPaused) {
    if (isPaused) {
        video.pause();
    } else {
        video.play().catch(() => undefined);
    }
}

/**
 * Seeks a video. Rejects with an Event if it cannot.
 * @param {HTMLVideoElement} video
 * @param {number} time In seconds.
 * @returns {Promise<void>}
 */
function seekVideo(video, time) {
    return new Promise((resolve, reject) => {
        /** @param {Event} event */
        const finish = (event) => {
            video.removeEventListener('seeked', finish);
            video.removeEventListener('error', finish);
            if (event.type === 'seeked') {
                resolve();
            } else {
                reject(event);
            }
        };
        video.addEventListener('seeked', finish);
        video.addEventListener('error', finish);
        video.currentTime = time;
    });
}

/**
 * Waits until a browser reports that it shows the picture of a time. Browsers may end a seek
 * before, and not all of them report.
 * @param {HTMLVideoElement} video
 * @param {number} time In seconds.
 * @param {number} duration The longest of a picture, in seconds.
 * @returns {Promise<void>}
 */
function shownVideoTime(video, time, duration) {
    const longestWait = 200;  // ms
    const rounding = 1e-3;  // s
    return new Promise((resolve) => {
        let isOver = false;
        setTimeout(() => {
            isOver = true;
            resolve();
        }, longestWait);
        const wait = () => video.requestVideoFrameCallback((_, { mediaTime }) => {
            isOver = isOver || (mediaTime <= time + rounding &&
                mediaTime >= time - duration - rounding);
            if (isOver) {
                resolve();
            } else {
                wait();
            }
        });
        if ('requestVideoFrameCallback' in video) {
            wait();
        } else {
            resolve();
        }
    });
}

/** Notices new pictures of a video element. */
export class VideoFrames {
    /** @param {HTMLVideoElement} video */
    constructor(video) {
        this.video = video;
        this.isNew = true;
        this.shownTime = -1;
        /** Whether the browser reports new pictures. */
        this.hasReports = false;
        this.isWatching = 'requestVideoFrameCallback' in video;
        this.watch();
    }

    watch() {
        if (this.isWatching) {
            this.video.requestVideoFrameCallback(() => {
                this.isNew = true;
                this.hasReports = true;
                this.watch();
            });
        }
    }

    /**
     * Seeks a paused video and waits for its picture. Rejects with an Event if it cannot.
     * @param {number} time In seconds.
     * @param {number} duration The longest of a picture, in seconds.
     * @returns {Promise<void>}
     */
    async seek(time, duration) {
        const shown = shownVideoTime(this.video, time, duration);
        await seekVideo(this.video, time);
        await shown;
        this.isNew = true;
    }

    /** Makes the next takePicture() return a picture. */
    refresh() {
        this.isNew = true;
    }

    /**
     * Null: unchanged since the last call.
     * @returns {SourcePicture | null}
     */
    takePicture() {
        const { video } = this;
        const isChanged = this.isNew || (!this.hasReports && video.currentTime !== this.shownTime);
        if (!isChanged || video.videoWidth === 0) {
            return null;
        }
        this.isNew = false;
        this.shownTime = video.currentTime;
        return this.picture();
    }

    /** @returns {SourcePicture} */
    picture() {
        return {
            width: this.video.videoWidth,
            height: this.video.videoHeight,
            channels: 4,
            encoding: 'display',
            pixels: this.video,
            isTopFirst: true,
        };
    }

    dispose() {
        this.isWatching = false;
    }
}
