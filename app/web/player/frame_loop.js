// The clock of the page: which time span each frame draws, live, fixed or again.

import { frameSpan } from '../signals/clock.js';
import { FramePace } from './pace.js';

const fixedRate = 60;  // frames per second
// Seconds of a frame. A frame with more beam takes longer, so a slow device would never catch up.
const longestStep = 1 / 20;
const longestSoundStep = 1 / 10;
const mostReplayed = 256;  // frames
const replayedAtOnce = 8;  // frames; more would block the browser

/** @type {[number]} */
const switchedOff = [0];

/**
 * Year, month from 1, day and seconds since midnight.
 * @returns {[number, number, number, number]}
 */
function dateNow() {
    const now = new Date();
    const seconds = 3600 * now.getHours() + 60 * now.getMinutes() + now.getSeconds();
    return [now.getFullYear(), now.getMonth() + 1, now.getDate(),
        seconds + now.getMilliseconds() / 1000];
}

/** Draws frames in order. The latest ones can be drawn again, for a change while paused. */
export class FrameLoop {
    #content;
    #values;
    /** Names of parameters that are on in one frame only. */
    #events;
    #isPaused = false;
    /** Start and end of the latest frames, by their number. */
    #spans = new Float64Array(2 * mostReplayed);
    #oldest = 1;  // number of the oldest frame in #spans
    #isOutdated = false;
    /** Number of the next frame to draw again. 0: none. */
    #replayed = 0;

    /**
     * @param {import('./look_drawing.js').LookDrawing} drawing
     * @param {import('./content.js').PageContent} content
     * @param {Map<string, number[]>} values of the parameters
     * @param {import('../look/types.js').ParameterDescription[]} parameters
     */
    constructor(drawing, content, values, parameters) {
        this.drawing = drawing;
        this.#content = content;
        this.#values = values;
        this.#events = parameters.filter((one) => one.type === 'event').map((one) => one.name);
        this.pace = new FramePace();
        this.number = 0;  // of the latest frame
        this.seconds = 0;  // at its end
    }

    get isPaused() {
        return this.#isPaused;
    }

    /** @param {boolean} isPaused */
    setPaused(isPaused) {
        if (isPaused === this.#isPaused)
            return;
        this.#isPaused = isPaused;
        this.#isOutdated = false;
        this.#content.setPaused(isPaused, this.seconds);
    }

    /** Starts again at time 0 with an empty history. */
    restart() {
        this.number = 0;
        this.seconds = 0;
        this.#oldest = 1;
        this.#replayed = 0;
        this.#isOutdated = this.#isPaused;
        this.drawing.clearHistory();
        this.#content.restart();
    }

    /** Call after a change. While paused, the latest frames are drawn again. */
    invalidate() {
        this.#isOutdated = this.#isPaused;
    }

    /** Draws the latest frames again, because the history is empty. */
    replay() {
        const count = Math.min(this.drawing.settleFrames, this.number - this.#oldest + 1);
        this.#isOutdated = false;
        this.#replayed = count > 0 ? this.number - count + 1 : 0;
        if (this.#replayed)
            this.drawing.clearHistory();
    }

    /**
     * Waits for the source picture of a frame of a clock of 60 Hz.
     * @param {number} number of the frame, from 1
     */
    async prepareFixed(number) {
        this.drawing.updateConstants(this.#values, false);
        const { source } = this.#content;
        if (source)
            await source.prepare(number / fixedRate);
    }

    /**
     * Draws a frame of a clock of 60 Hz.
     * @param {number} number of the frame, from 1
     */
    drawFixed(number) {
        const { start, end } = frameSpan(number, fixedRate);
        this.#drawNext(number, start, end, [2000, 1, 1, end]);
    }

    /**
     * Draws what is due, and shows it. A playing sound is the clock.
     * @param {number} elapsed s since the previous call
     */
    drawLive(elapsed) {
        if (this.drawing.isLost)
            return;
        if (this.drawing.updateConstants(this.#values, this.number > 0))
            this.invalidate();
        if (this.#isOutdated && !this.#replayed)
            this.#drawAgain();
        else if (this.#replayed)
            this.#continueReplay();
        else if (!this.#isPaused)
            this.#drawStep(elapsed);
    }

    /** @param {number} elapsed s */
    #drawStep(elapsed) {
        const heard = this.#content.sound.seconds();
        const end = heard === null ? this.seconds + Math.min(elapsed, longestStep) : heard;
        const isJump = Math.abs(end - this.seconds) > longestSoundStep;
        const start = isJump ? Math.max(0, end - 1 / fixedRate) : this.seconds;
        if (end > start)
            this.#drawNext(this.number + 1, start, end, dateNow());
        else if (this.number === 0)
            this.drawFixed(1);  // the sound has not started yet
        else
            return;
        this.drawing.present();
    }

    /** Shows the effect of a change while the clock is stopped. */
    #drawAgain() {
        if (this.number > 0)
            return this.replay();
        this.#isOutdated = false;
        this.drawFixed(1);
        this.drawing.present();
    }

    #continueReplay() {
        const date = dateNow();
        for (let i = 0; i < replayedAtOnce && this.#replayed <= this.number; i++) {
            const at = 2 * (this.#replayed % mostReplayed);
            this.drawing.draw({ number: this.#replayed++, start: this.#spans[at],
                end: this.#spans[at + 1], now: this.seconds, date }, this.#values, this.#content);
        }
        if (this.#replayed <= this.number)
            return;
        this.#replayed = 0;
        this.drawing.present();
    }

    /**
     * @param {number} number
     * @param {number} start s
     * @param {number} end s
     * @param {[number, number, number, number]} date
     */
    #drawNext(number, start, end, date) {
        const at = 2 * (number % mostReplayed);
        this.#spans[at] = start;
        this.#spans[at + 1] = end;
        this.#oldest = Math.max(this.#oldest, number - mostReplayed + 1);
        this.number = number;
        this.seconds = end;
        this.drawing.draw({ number, start, end, now: end, date }, this.#values, this.#content);
        for (const name of this.#events)
            this.#values.set(name, switchedOff);
    }
}
