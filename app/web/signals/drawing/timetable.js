// When the beam draws each part of a scene. It is the same for each drawing.
import { NUMBERS_PER_SCENE_POINT, ScenePose } from './scene_pose.js';

/**
 * A scene that the beam draws repeatedly. Speeds are in half screens/s.
 * `move_speed` and `move_current` apply between paths; a current of 0 is blanked.
 * `refresh` is the maximum number of drawings per second; 0 is no maximum.
 * @typedef {{
 *   items: import('./scene_pose.js').SceneItem[],
 *   beam_speed: number,
 *   move_speed: number,
 *   move_current: number,
 *   refresh: number
 * }} BeamScene
 */

/**
 * The legs of a drawing: the beam's paths to corners, and its dwells there.
 * Leg i goes from corner `from[i]` to `to[i]`, and starts `begin[i]` s after the drawing.
 */
export class SceneTimetable {
    #places = new Float64Array(0); // of the corners at time 0

    /** Number of legs. */
    count = 0;
    /** Duration of a drawing in s, including the return to its start. */
    seconds = 0;
    from = new Int32Array(0);
    to = new Int32Array(0);
    begin = new Float64Array(0);
    duration = new Float64Array(0);
    /** Of the beam: 1 is full, 0 is blanked. */
    current = new Float64Array(0);
    /** x, y and z of the corners, before their item's transform. */
    corners = new Float64Array(0);
    /** The item of each corner. */
    items = new Int32Array(0);

    /**
     * Replaces the timetable.
     * @param {BeamScene} scene
     */
    build(scene) {
        this.count = 0;
        this.seconds = 0;
        this.#reserve(countOfScenePoints(scene));
        let here = 0;
        scene.items.forEach((item, index) => {
            const pose = new ScenePose(item);
            pose.turnTo(0);
            for (const path of item.paths) {
                here = this.#addPath(scene, index, path, pose, here);
            }
        });
        if (here === 0) {
            return;
        }
        this.#addMove(scene, here - 1, 0);
        if (scene.refresh > 0) {
            this.#add(0, 0, 1 / scene.refresh - this.seconds, 0);
        }
    }

    /** @param {number} corners */
    #reserve(corners) {
        if (this.items.length >= corners) {
            return;
        }
        const legs = 2 * corners + 2; // to each corner and in it, the return, the wait
        this.#places = new Float64Array(3 * corners);
        this.corners = new Float64Array(3 * corners);
        this.items = new Int32Array(corners);
        this.from = new Int32Array(legs);
        this.to = new Int32Array(legs);
        this.begin = new Float64Array(legs);
        this.duration = new Float64Array(legs);
        this.current = new Float64Array(legs);
    }

    /**
     * @param {number} from corner
     * @param {number} to corner
     * @param {number} duration
     * @param {number} current
     */
    #add(from, to, duration, current) {
        if (duration <= 0) {
            return;
        }
        const leg = this.count++;
        this.from[leg] = from;
        this.to[leg] = to;
        this.begin[leg] = this.seconds;
        this.duration[leg] = duration;
        this.current[leg] = current;
        this.seconds += duration;
    }

    /**
     * @param {BeamScene} scene
     * @param {number} from
     * @param {number} to
     */
    #addMove(scene, from, to) {
        this.#add(from, to, this.#distance(from, to) / scene.move_speed, scene.move_current);
    }

    /**
     * @param {BeamScene} scene
     * @param {number} index of the item
     * @param {import('./scene_pose.js').ScenePath} path
     * @param {ScenePose} pose of the item
     * @param {number} here the next corner
     * @returns {number} the next corner
     */
    #addPath(scene, index, path, pose, here) {
        const item = scene.items[index];
        const points = path.points;
        for (let at = 0; at < points.length; at += NUMBERS_PER_SCENE_POINT) {
            this.#addCorner(index, points, at, pose, here);
            const current = item.current * points[at + 3];
            if (at > 0) {
                const speed = scene.beam_speed * item.speed;
                this.#add(here - 1, here, this.#distance(here - 1, here) / speed, current);
            } else if (here > 0) {
                this.#addMove(scene, here - 1, here);
            }
            const isEnd = at === 0 || at + NUMBERS_PER_SCENE_POINT === points.length;
            this.#add(here, here, !path.smooth || isEnd ? item.dwell_seconds : 0, current);
            here++;
        }
        return here;
    }

    /**
     * @param {number} index of the item
     * @param {ArrayLike<number>} points
     * @param {number} at
     * @param {ScenePose} pose
     * @param {number} corner
     */
    #addCorner(index, points, at, pose, corner) {
        pose.place(points, at);
        this.items[corner] = index;
        this.#places[3 * corner] = pose.x;
        this.#places[3 * corner + 1] = pose.y;
        this.#places[3 * corner + 2] = pose.z;
        for (let axis = 0; axis < 3; axis++) {
            this.corners[3 * corner + axis] = points[at + axis];
        }
    }

    /**
     * Distance of two corners in space, rounded like std::hypot.
     * @param {number} from
     * @param {number} to
     * @returns {number}
     */
    #distance(from, to) {
        const places = this.#places;
        const x = Math.abs(places[3 * from] - places[3 * to]);
        const y = Math.abs(places[3 * from + 1] - places[3 * to + 1]);
        const z = Math.abs(places[3 * from + 2] - places[3 * to + 2]);
        const longest = Math.max(x, y, z);
        if (longest === 0) {
            return 0;
        }
        const a = x / longest;
        const b = y / longest;
        const c = z / longest;
        return longest * Math.sqrt(a * a + b * b + c * c);
    }
}

/**
 * @param {BeamScene} scene
 * @returns {number}
 */
function countOfScenePoints(scene) {
    let count = 0;
    for (const item of scene.items) {
        for (const path of item.paths) {
            count += path.points.length / NUMBERS_PER_SCENE_POINT;
        }
    }
    return count;
}
