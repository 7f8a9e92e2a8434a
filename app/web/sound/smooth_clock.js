// A clock that follows one that advances in steps.

const SETTLE_SECONDS = 0.5; // to adjust to the speed of the device
const MAX_CLOCK_ERROR = 0.1; // s; a larger one is corrected at once

/**
 * Follows a clock that advances in bursts, as audio devices do. It never goes back, except by a
 * jump. All times are in s.
 */
export class SmoothClock {
    #seconds = 0;
    #asked = 0; // time of the last call
    #isWaiting = true;

    /**
     * Sets the time. It stays until the target has reached it.
     * @param {number} seconds
     */
    jump(seconds) {
        this.#seconds = seconds;
        this.#isWaiting = true;
    }

    /**
     * @param {number} target the time that the other clock has now
     * @param {number} now of a monotonic clock
     * @returns {number} the time, never before an earlier result
     */
    follow(target, now) {
        const passed = now - this.#asked;
        const expected = this.#seconds + passed;
        const error = target - expected;
        this.#asked = now;
        let next = target;
        if (!this.#isWaiting && Math.abs(error) < MAX_CLOCK_ERROR) {
            next = expected + error * Math.min(passed / SETTLE_SECONDS, 1);
        }
        this.#isWaiting &&= target < this.#seconds;
        this.#seconds = Math.max(this.#seconds, next);
        return this.#seconds;
    }

    /** The last result. */
    get seconds() {
        return this.#seconds;
    }
}
