// Segments: the path of the beam from one point to the next.
import { FLOATS_PER_POINT } from './beam.js';

/** Floats per segment: x0, y0, x1, y1, start and end intensity, start and end age. */
export const FLOATS_PER_SEGMENT = 8;
/** Rounding error of a time difference between two float ages, relative to the older age. */
export const AGE_ROUNDING = Math.fround(2.5e-7);

const NEARLY_EQUAL = Math.fround(1e-3); // relative tolerance for equal charges and times

/** Segments in buffers that grow and are reused. */
export class SegmentBuffer {
    #capacity = 4096;
    #hasTints = false;
    #tints = new Float32Array(0);

    /** Number of segments. */
    count = 0;
    /**
     * x0, y0, x1, y1, start and end intensity, start and end age of each segment.
     * The first `count` segments are valid.
     */
    segments = new Float32Array(this.#capacity * FLOATS_PER_SEGMENT);

    /** Red, green and blue of each segment. Null if the beam has no colour of its own. */
    get tints() {
        return this.#hasTints ? this.#tints : null;
    }

    /**
     * Removes all segments.
     * @param {number} capacity segments that will be written
     * @param {boolean} hasTints
     */
    restart(capacity, hasTints) {
        this.count = 0;
        this.#hasTints = hasTints;
        if (capacity > this.#capacity) {
            this.#capacity = 2 * capacity;
            this.segments = new Float32Array(this.#capacity * FLOATS_PER_SEGMENT);
        }
        if (hasTints && this.#tints.length < 3 * this.#capacity) {
            this.#tints = new Float32Array(3 * this.#capacity);
        }
    }
}

/**
 * Connects consecutive points, the first one to `before`.
 *
 * If the current is known at both ends of a segment, it is interpolated linearly.
 * Otherwise it is that of the end. To a point of intensity 0 the beam is blanked and not drawn.
 * Points that are not finite are skipped, and the beam is blanked around them.
 * A segment has the colour of its end point.
 * @param {import('./beam.js').Beam} beam
 * @param {Float32Array | null} before last point of the previous frame, aged to the end of this one
 * @param {SegmentBuffer} buffer is overwritten
 */
export function makeSegments(beam, before, buffer) {
    const pointTints = beam.tints;
    buffer.restart(beam.count, pointTints !== null);
    let last = before; // the array of the previous point; null: none
    let from = 0; // its index there
    let secondsBefore = 0; // duration of the previous segment; 0: unknown
    const points = beam.points;
    for (let at = 0; at < FLOATS_PER_POINT * beam.count; at += FLOATS_PER_POINT) {
        const isGood = isFinitePoint(points, at);
        if (isGood && last && points[at + 2] !== 0) {
            addSegment(buffer, last, from, points, at, secondsBefore);
            if (pointTints) {
                copyTint(buffer, pointTints, 3 * at / FLOATS_PER_POINT);
            }
        }
        secondsBefore = isGood && last ? Math.fround(last[from + 3] - points[at + 3]) : 0;
        last = isGood ? points : null;
        from = at;
    }
}

/**
 * @param {Float32Array} points
 * @param {number} at
 * @returns {boolean}
 */
function isFinitePoint(points, at) {
    return Number.isFinite(points[at]) && Number.isFinite(points[at + 1]) &&
        Number.isFinite(points[at + 2]) && Number.isFinite(points[at + 3]);
}

/**
 * @param {SegmentBuffer} buffer
 * @param {Float32Array} last
 * @param {number} from
 * @param {Float32Array} points
 * @param {number} to
 * @param {number} secondsBefore
 */
function addSegment(buffer, last, from, points, to, secondsBefore) {
    const segments = buffer.segments;
    const at = FLOATS_PER_SEGMENT * buffer.count++;
    const charge = points[to + 2];
    const startAge = last[from + 3];
    const endAge = points[to + 3];
    segments[at] = last[from];
    segments[at + 1] = last[from + 1];
    segments[at + 2] = points[to];
    segments[at + 3] = points[to + 1];
    segments[at + 4] = chargeAtStart(last[from + 2], startAge, charge, endAge, secondsBefore);
    segments[at + 5] = charge;
    segments[at + 6] = startAge;
    segments[at + 7] = endAge;
}

/**
 * The charge at the start, scaled to the duration of this segment.
 * The charge of the start point belongs to the previous segment.
 * Without scaling, charges of unevenly spaced points are not comparable.
 * @param {number} fromCharge
 * @param {number} fromAge
 * @param {number} toCharge
 * @param {number} toAge
 * @param {number} secondsBefore duration of the previous segment
 * @returns {number}
 */
function chargeAtStart(fromCharge, fromAge, toCharge, toAge, secondsBefore) {
    const float = Math.fround;
    const seconds = float(fromAge - toAge);
    if (fromCharge === 0 || !(secondsBefore > 0) || !(seconds > 0)) {
        return toCharge;
    }
    const doubt = float(AGE_ROUNDING * float(fromAge + secondsBefore));
    const sameTime = float(float(NEARLY_EQUAL * secondsBefore) + doubt);
    if (Math.abs(float(seconds - secondsBefore)) <= sameTime) {
        return fromCharge;
    }
    const charge = float(fromCharge * float(seconds / secondsBefore));
    const rounding = float(float(charge * doubt) / Math.min(seconds, secondsBefore));
    const sameCharge = float(float(NEARLY_EQUAL * toCharge) + rounding);
    return Math.abs(float(charge - toCharge)) <= sameCharge ? toCharge : charge;
}

/**
 * Gives the last segment a colour.
 * @param {SegmentBuffer} buffer
 * @param {Float32Array} pointTints
 * @param {number} from
 */
function copyTint(buffer, pointTints, from) {
    const to = 3 * (buffer.count - 1);
    const tints = buffer.tints;
    if (tints) {
        tints[to] = pointTints[from];
        tints[to + 1] = pointTints[from + 1];
        tints[to + 2] = pointTints[from + 2];
    }
}
