// The timing of keyframes: each is held, then morphs into the next.

/**
 * @typedef {{
 *   steps: number,
 *   loops: boolean,
 *   holdSeconds: number,
 *   morphSeconds: number,
 *   isEased: boolean
 * }} KeyframeTiming
 */

/**
 * The step from one keyframe to the next at a time, and its progress.
 * Eased progress is the smoothstep 3 x^2 - 2 x^3.
 * @param {KeyframeTiming} timing
 * @param {number} seconds
 * @returns {{step: number, share: number}} share: 0..1
 */
export function keyframeMoment(timing, seconds) {
    const { steps, loops, holdSeconds, morphSeconds, isEased } = timing;
    const stepSeconds = holdSeconds + morphSeconds;
    if (stepSeconds <= 0) {
        return { step: 0, share: 0 };
    }
    const gone = Math.max(seconds, 0);
    const step = Math.floor(gone / stepSeconds);
    if (!loops && step >= steps) {
        return { step: steps - 1, share: 1 };
    }
    const within = gone - step * stepSeconds - holdSeconds;
    const even = within > 0 ? Math.min(within / morphSeconds, 1) : 0;
    const share = isEased ? even * even * (3 - 2 * even) : even;
    return { step: step % steps, share };
}
