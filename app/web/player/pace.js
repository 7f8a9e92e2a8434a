// Measures frames, and halves the size while they are slow.

const slowSeconds = 1 / 24;
const framesToJudge = 40;
const mostHalvings = 2;

/** The rate of drawn frames. */
export class FramePace {
    constructor() {
        this.framesPerSecond = 0;
        this.halvings = 0;
        this.slow = 0;
        this.last = 0;
    }

    /**
     * Notes a frame. True: the picture should be made smaller now.
     * @param {number} now s
     */
    note(now) {
        const seconds = now - this.last;
        this.last = now;
        if (!(seconds > 0) || seconds > 1) {
            this.slow = 0;
            return false;
        }
        const rate = 1 / seconds;
        this.framesPerSecond += (rate - this.framesPerSecond) * (this.framesPerSecond ? 0.05 : 1);
        this.slow = seconds > slowSeconds ? this.slow + 1 : Math.max(0, this.slow - 2);
        if (this.slow < framesToJudge || this.halvings === mostHalvings)
            return false;
        this.slow = 0;
        this.halvings++;
        return true;
    }
}
