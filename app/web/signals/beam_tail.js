// The last point of the previous frames, which the first segment of a frame starts at.
import { FLOATS_PER_POINT } from './beam.js';

/** The end of the beam's path before a frame. */
export class BeamTail {
    #before = new Float32Array(FLOATS_PER_POINT);
    #last = new Float32Array(FLOATS_PER_POINT);
    #scaled = new Float32Array(FLOATS_PER_POINT);
    #hasBefore = false;
    #hasLast = false;

    /**
     * Starts a frame. The previous point ages by the duration of the frame.
     * @param {import('./beam.js').Beam} beam of the frame
     * @param {number} seconds duration of the frame
     * @param {boolean} isFirst the frame has no previous beam
     */
    advance(beam, seconds, isFirst) {
        this.#hasBefore = this.#hasLast && !isFirst;
        this.#before.set(this.#last);
        this.#before[3] += Math.fround(seconds);
        if (beam.count > 0) {
            const end = FLOATS_PER_POINT * beam.count;
            this.#last.set(beam.points.subarray(end - FLOATS_PER_POINT, end));
        } else {
            this.#last.set(this.#before);
        }
        this.#hasLast = this.#hasBefore || beam.count > 0;
    }

    /**
     * @param {number} [scaleX] factors of the position
     * @param {number} [scaleY]
     * @returns {Float32Array | null} x, y, intensity, and age at the end of the frame
     */
    before(scaleX = 1, scaleY = 1) {
        if (!this.#hasBefore) {
            return null;
        }
        this.#scaled.set(this.#before);
        this.#scaled[0] *= scaleX;
        this.#scaled[1] *= scaleY;
        return this.#scaled;
    }

    /** Discards the previous frames. */
    clear() {
        this.#hasBefore = false;
        this.#hasLast = false;
    }
}
