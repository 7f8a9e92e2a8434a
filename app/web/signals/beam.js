// The points of the beam in a time span, in buffers that grow and are reused.

/** Floats per point: x, y, intensity, age. */
export const FLOATS_PER_POINT = 4;

/**
 * The points of a time span, oldest first.
 *
 * x is -1 (left) to 1 (right) and y is -1 (bottom) to 1 (top).
 * The intensity is a charge: 1 is full current for 1/4096 of 1/60 s, and 0 is blanked.
 * The age is the time from the point to the end of the span, in s.
 */
export class Beam {
    #capacity = 4096;
    #hasTints = false;
    #points = new Float32Array(this.#capacity * FLOATS_PER_POINT);
    /** @type {Float32Array | null} */
    #tints = null;

    /** Number of points. */
    count = 0;

    /** x, y, intensity and age of each point. The first `count` points are valid. */
    get points() {
        return this.#points;
    }

    /**
     * Red, green and blue of each point: linear factors of the look's own colour.
     * Null if the beam has no colour of its own.
     */
    get tints() {
        return this.#hasTints ? this.#tints : null;
    }

    /** Removes all points and colours. */
    clear() {
        this.count = 0;
        this.#hasTints = false;
    }

    /**
     * Appends points, to be written by the caller.
     * Their values are undefined and their colour is white.
     * @param {number} added number of points
     * @returns {number} index of the first one
     */
    extend(added) {
        const first = this.count;
        this.count += added;
        if (this.count > this.#capacity) {
            this.#grow(first);
        }
        if (this.#hasTints && this.#tints) {
            this.#tints.fill(1, 3 * first, 3 * this.count);
        }
        return first;
    }

    /**
     * Gives the beam colours: white until the caller writes `tints`.
     * @returns {Float32Array} the colours of all points
     */
    addTints() {
        this.#tints ??= new Float32Array(3 * this.#capacity);
        if (!this.#hasTints) {
            this.#tints.fill(1, 0, 3 * this.count);
        }
        this.#hasTints = true;
        return this.#tints;
    }

    /**
     * @param {number} x
     * @param {number} y
     * @param {number} intensity
     * @param {number} age in s
     */
    add(x, y, intensity, age) {
        const at = FLOATS_PER_POINT * this.extend(1);
        this.#points[at] = x;
        this.#points[at + 1] = y;
        this.#points[at + 2] = intensity;
        this.#points[at + 3] = age;
    }

    /**
     * @param {number} x
     * @param {number} y
     * @param {number} intensity
     * @param {number} age in s
     * @param {number} r
     * @param {number} g
     * @param {number} b
     */
    addTinted(x, y, intensity, age, r, g, b) {
        this.add(x, y, intensity, age);
        const tints = this.addTints();
        const at = 3 * (this.count - 1);
        tints[at] = r;
        tints[at + 1] = g;
        tints[at + 2] = b;
    }

    /**
     * Replaces the points by those of another beam, with positions multiplied by the factors.
     * @param {Beam} other
     * @param {number} scaleX
     * @param {number} scaleY
     */
    copyScaled(other, scaleX, scaleY) {
        this.clear();
        this.extend(other.count);
        const from = other.points;
        const to = this.#points;
        for (let at = 0; at < FLOATS_PER_POINT * other.count; at += FLOATS_PER_POINT) {
            to[at] = from[at] * scaleX;
            to[at + 1] = from[at + 1] * scaleY;
            to[at + 2] = from[at + 2];
            to[at + 3] = from[at + 3];
        }
        if (other.tints) {
            this.addTints().set(other.tints.subarray(0, 3 * other.count));
        }
    }

    /** @param {number} kept number of points to keep */
    #grow(kept) {
        while (this.#capacity < this.count) {
            this.#capacity *= 2;
        }
        const points = new Float32Array(FLOATS_PER_POINT * this.#capacity);
        points.set(this.#points.subarray(0, FLOATS_PER_POINT * kept));
        this.#points = points;
        if (this.#tints) {
            const tints = new Float32Array(3 * this.#capacity);
            tints.set(this.#tints.subarray(0, 3 * kept));
            this.#tints = tints;
        }
    }
}
