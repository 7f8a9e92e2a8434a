// Merges segments if the spot of the beam cannot resolve the difference.
import { AGE_ROUNDING, FLOATS_PER_SEGMENT } from './segments.js';

/**
 * The smallest beam spot: the standard deviation of its light on each axis, in half screens.
 * 0 is unknown.
 * @typedef {{across: number, up: number}} BeamSpot
 */

/**
 * Merges consecutive segments, in place.
 *
 * Charge is conserved. The beam passes every dropped joint within 0.01 of the spot.
 * On a segment of at most half a spot it passes it within 0.05.
 * If the spot is unknown, only straight paths are merged, to 2e-6 half screens.
 * Another colour, another current (by 1 in 100) and a blanked path end a segment.
 * @param {import('./segments.js').SegmentBuffer} buffer
 * @param {BeamSpot} spot
 */
export function mergeSegments(buffer, spot) {
    const total = buffer.count;
    if (total === 0) {
        return;
    }
    const run = new SegmentRun(buffer, spot);
    let kept = 0;
    run.begin(0, 0);
    for (let next = 1; next < total; next++) {
        if (!run.take(next)) {
            kept++;
            run.begin(next, kept);
        }
    }
    buffer.count = kept + 1;
}

/** The range of velocities, in half screens per charge of 1, that pass all joints closely. */
class VelocityRange {
    #freeX;
    #freeY;
    #lowX = -Infinity;
    #lowY = -Infinity;
    #highX = Infinity;
    #highY = Infinity;

    /**
     * Squares around the joints that lie in circles of about 1.4 times the share.
     * @param {BeamSpot} spot
     * @param {number} share tolerance relative to the spot
     */
    constructor(spot, share) {
        this.#freeX = Math.max(share * spot.across, 2e-6);
        this.#freeY = Math.max(share * spot.up, 2e-6);
    }

    reset() {
        this.#lowX = this.#lowY = -Infinity;
        this.#highX = this.#highY = Infinity;
    }

    /**
     * @param {number} x way to the joint
     * @param {number} y
     * @param {number} charge up to the joint
     */
    pass(x, y, charge) {
        this.#lowX = largerOf(this.#lowX, (x - this.#freeX) / charge);
        this.#lowY = largerOf(this.#lowY, (y - this.#freeY) / charge);
        this.#highX = smallerOf(this.#highX, (x + this.#freeX) / charge);
        this.#highY = smallerOf(this.#highY, (y + this.#freeY) / charge);
    }

    /**
     * @param {number} x velocity
     * @param {number} y
     * @returns {boolean}
     */
    holds(x, y) {
        return x >= this.#lowX && x <= this.#highX && y >= this.#lowY && y <= this.#highY;
    }
}

/**
 * Like Math.max, but ignores a second number that is NaN.
 * @param {number} a
 * @param {number} b
 * @returns {number}
 */
function largerOf(a, b) {
    return a < b ? b : a;
}

/**
 * Like Math.min, but ignores a second number that is NaN.
 * @param {number} a
 * @param {number} b
 * @returns {number}
 */
function smallerOf(a, b) {
    return b < a ? b : a;
}

/**
 * A run of segments that may be merged.
 * Each has an even intensity and starts where and when the previous one ended.
 * The position is a function of the charge, which is exact, as it is of time.
 */
class SegmentRun {
    #segments;
    #tints;
    #spot;
    #evenness; // tolerance of the current, relative to the run's current
    #long;
    #short;
    #at = 0; // the merged segment
    #tintAt = 0;
    #charge = 0;
    #isEven = false;

    /**
     * @param {import('./segments.js').SegmentBuffer} buffer
     * @param {BeamSpot} spot
     */
    constructor(buffer, spot) {
        this.#segments = buffer.segments;
        this.#tints = buffer.tints;
        this.#spot = spot;
        this.#evenness = spot.across > 0 && spot.up > 0 ? 0.005 : 0;
        this.#long = new VelocityRange(spot, 0.007);
        this.#short = new VelocityRange(spot, 0.035);
    }

    /**
     * Starts with segment `first`, moved to position `to`.
     * @param {number} first
     * @param {number} to at most `first`
     */
    begin(first, to) {
        const segments = this.#segments;
        const from = FLOATS_PER_SEGMENT * first;
        this.#at = FLOATS_PER_SEGMENT * to;
        this.#tintAt = 3 * to;
        if (to < first) {
            segments.copyWithin(this.#at, from, from + FLOATS_PER_SEGMENT);
            this.#tints?.copyWithin(this.#tintAt, 3 * first, 3 * first + 3);
        }
        this.#charge = this.#chargeOf(this.#at);
        this.#isEven = this.#hasEvenCurrent(this.#at);
        this.#long.reset();
        this.#short.reset();
        this.#leaveJoint(this.#wayTo(this.#at, 0), this.#wayTo(this.#at, 1));
    }

    /**
     * @param {number} next segment
     * @returns {boolean} whether it was added
     */
    take(next) {
        const from = FLOATS_PER_SEGMENT * next;
        if (!this.#isEven || !this.#hasEvenCurrent(from) || !this.#follows(from) ||
            !this.#hasTint(3 * next)) {
            return false;
        }
        const charge = this.#charge + this.#chargeOf(from);
        const x = this.#wayTo(from, 0);
        const y = this.#wayTo(from, 1);
        if (!this.#long.holds(x / charge, y / charge) &&
            !(this.#isShort(x, y) && this.#short.holds(x / charge, y / charge))) {
            return false;
        }
        const segments = this.#segments;
        this.#charge = charge;
        segments[this.#at + 2] = segments[from + 2];
        segments[this.#at + 3] = segments[from + 3];
        segments[this.#at + 4] = charge;
        segments[this.#at + 5] = charge;
        segments[this.#at + 7] = segments[from + 7];
        this.#leaveJoint(x, y);
        return true;
    }

    /** @param {number} at @returns {number} */
    #chargeOf(at) {
        return 0.5 * (this.#segments[at + 4] + this.#segments[at + 5]);
    }

    /** @param {number} at @returns {boolean} */
    #hasEvenCurrent(at) {
        const start = this.#segments[at + 4];
        const end = this.#segments[at + 5];
        return Math.abs(start - end) <= this.#evenness * (start + end) && start > 0 && end > 0;
    }

    /**
     * The same position, time and current.
     * @param {number} from
     * @returns {boolean}
     */
    #follows(from) {
        const segments = this.#segments;
        const at = this.#at;
        if (segments[from] !== segments[at + 2] || segments[from + 1] !== segments[at + 3] ||
            segments[from + 6] !== segments[at + 7]) {
            return false;
        }
        const seconds = segments[from + 6] - segments[from + 7];
        const before = segments[at + 6] - segments[at + 7];
        const expected = before * this.#chargeOf(from) / this.#charge;
        const rounding = Math.fround(AGE_ROUNDING * segments[at + 6]);
        return Math.abs(seconds - expected) <= rounding + this.#evenness * seconds;
    }

    /** @param {number} from @returns {boolean} */
    #hasTint(from) {
        const tints = this.#tints;
        const at = this.#tintAt;
        return !tints || (tints[from] === tints[at] && tints[from + 1] === tints[at + 1] &&
            tints[from + 2] === tints[at + 2]);
    }

    /**
     * From the run's start to the end of a segment.
     * @param {number} from
     * @param {0 | 1} axis
     * @returns {number}
     */
    #wayTo(from, axis) {
        return this.#segments[from + 2 + axis] - this.#segments[this.#at + axis];
    }

    /** @param {number} x @param {number} y @returns {boolean} */
    #isShort(x, y) {
        const a = x / (0.5 * this.#spot.across);
        const b = y / (0.5 * this.#spot.up);
        return Math.sqrt(a * a + b * b) <= 1;
    }

    /** @param {number} x @param {number} y */
    #leaveJoint(x, y) {
        this.#long.pass(x, y, this.#charge);
        this.#short.pass(x, y, this.#charge);
    }
}
