// The rotation of a scene's item at one instant, and its view on the screen.

/**
 * A line that the beam draws without a gap: x, y, z and current of each point.
 * Lengths are in half screens, y up, z towards the eye. A smooth path dwells at its ends only.
 * @typedef {{points: ArrayLike<number>, smooth: boolean}} ScenePath
 */

/**
 * Paths with a common transform: scale, rotation about x, then y, then z, translation.
 * `turn` is in degrees at time 0, counter-clockwise, and `spin` in degrees/s.
 * `perspective` is the distance from the eye to the middle; 0 is orthographic.
 * `current` and `speed` are factors. The beam dwells `dwell_seconds` at each corner.
 * @typedef {{
 *   paths: ScenePath[],
 *   at: number[],
 *   scale: number,
 *   turn: number[],
 *   spin: number[],
 *   perspective: number,
 *   current: number,
 *   speed: number,
 *   dwell_seconds: number
 * }} SceneItem
 */

/** Numbers per point of a path: x, y, z, current. */
export const NUMBERS_PER_SCENE_POINT = 4;

/** Transforms points of an item. The result is in `x`, `y` and `z`. */
export class ScenePose {
    #item;
    #cosines = new Float64Array(3);
    #sines = new Float64Array(3);
    x = 0;
    y = 0;
    z = 0;

    /** @param {SceneItem} item */
    constructor(item) {
        this.#item = item;
    }

    /** @param {number} seconds */
    turnTo(seconds) {
        const { turn, spin } = this.#item;
        for (let axis = 0; axis < 3; axis++) {
            const degrees = turn[axis] + (spin[axis] * seconds) % 360;
            this.#cosines[axis] = Math.cos(degrees * Math.PI / 180);
            this.#sines[axis] = Math.sin(degrees * Math.PI / 180);
        }
    }

    /**
     * To the screen. The distance to the eye is at least a tenth of `perspective`.
     * @param {ArrayLike<number>} points
     * @param {number} at index of x; y and z follow
     */
    project(points, at) {
        this.#rotate(points, at);
        const eye = this.#item.perspective;
        const nearer = eye > 0 ? eye / Math.max(eye - this.z, 0.1 * eye) : 1;
        this.x = this.#item.at[0] + this.x * nearer;
        this.y = this.#item.at[1] + this.y * nearer;
    }

    /**
     * In space, for lengths.
     * @param {ArrayLike<number>} points
     * @param {number} at index of x; y and z follow
     */
    place(points, at) {
        this.#rotate(points, at);
        this.x += this.#item.at[0];
        this.y += this.#item.at[1];
    }

    /**
     * @param {ArrayLike<number>} points
     * @param {number} at
     */
    #rotate(points, at) {
        const scale = this.#item.scale;
        const cosines = this.#cosines;
        const sines = this.#sines;
        const x0 = points[at] * scale;
        const y0 = points[at + 1] * scale;
        const z0 = points[at + 2] * scale;
        const y1 = y0 * cosines[0] - z0 * sines[0];
        const z1 = y0 * sines[0] + z0 * cosines[0];
        const x2 = x0 * cosines[1] + z1 * sines[1];
        this.z = z1 * cosines[1] - x0 * sines[1];
        this.x = x2 * cosines[2] - y1 * sines[2];
        this.y = x2 * sines[2] + y1 * cosines[2];
    }
}
