// Measures frames, and decides when the picture must be smaller.

const slowFrame = 1 / 24;  // s
const longestFrame = 1;  // s; the page was hidden, or compiled
const patience = 1.5;  // s of slow frames
const mostHalvings = 2;
const rateSeconds = 0.5;  // over which the rate is averaged

/** The rate of drawn frames. */
export class FramePace {
    #slowSeconds = 0;

    constructor() {
        this.framesPerSecond = 0;
        /** How often the sides of the picture are halved. */
        this.halvings = 0;
    }

    /**
     * Notes a frame. True: the picture must become smaller now.
     * @param {number} seconds since the previous frame
     * @param {boolean} canHalve the size is not fixed
     */
    note(seconds, canHalve) {
        if (!(seconds > 0) || seconds > longestFrame) {
            this.#slowSeconds = 0;
            return false;
        }
        const weight = this.framesPerSecond > 0 ? Math.min(1, seconds / rateSeconds) : 1;
        const mean = this.framesPerSecond > 0 ? 1 / this.framesPerSecond : 0;
        this.framesPerSecond = 1 / (mean + (seconds - mean) * weight);
        this.#slowSeconds = seconds > slowFrame ? this.#slowSeconds + seconds
            : Math.max(0, this.#slowSeconds - 2 * seconds);
        if (!canHalve || this.#slowSeconds < patience || this.halvings === mostHalvings)
            return false;
        this.#slowSeconds = 0;
        this.halvings++;
        return true;
    }

    /** Tries the full size again. */
    reset() {
        this.halvings = 0;
        this.#slowSeconds = 0;
    }
}
