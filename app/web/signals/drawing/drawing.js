// The signal of a drawing by hand: keyframes that morph into each other.
import { numberSetting } from '../signal.js';
import { linearBetween } from '../sine.js';
import { keyframeMoment } from './keyframe_order.js';
import { forEachDrawing, SceneTracer } from './scene.js';
import { NUMBERS_PER_SCENE_POINT } from './scene_pose.js';
import { SceneTimetable } from './timetable.js';

/**
 * Two lines with the same number of points, x, y of each.
 * @typedef {{from: number[], to: number[]}} LineMorph
 */

/**
 * A drawing: the morphs of each step in playback order, and its timing.
 * @typedef {{
 *   steps: LineMorph[][],
 *   loops: boolean,
 *   hold_seconds: number,
 *   morph_seconds: number,
 *   eased: boolean,
 *   spin: number,
 *   beam_speed: number,
 *   refresh: number
 * }} MorphingDrawing
 */

/**
 * @param {import('../signal.js').SignalSettings} settings
 * @param {MorphingDrawing} drawing
 * @returns {import('../signal.js').Signal}
 */
export function makeDrawing(settings, drawing) {
    const rate = 60 * numberSetting(settings, 'points');
    const steps = drawing.steps.map((morphs) => new MorphStep(drawing, morphs, rate));
    // An interpolated line is never longer than the longer of the two.
    // The start and end of each step therefore give the maximum duration.
    const length = Math.max(1 / drawing.refresh, ...steps.map((step) => step.longestSeconds()));
    const timing = {
        steps: steps.length,
        loops: drawing.loops,
        holdSeconds: drawing.hold_seconds,
        morphSeconds: drawing.morph_seconds,
        isEased: drawing.eased,
    };
    return {
        seconds: Infinity,
        trace: (start, end, beam) => {
            forEachDrawing(start, end, length, (time) => {
                const { step, share } = keyframeMoment(timing, time);
                steps[step].tracerAt(share).trace(time, start, end, beam);
            });
        },
    };
}

/** One step of a drawing as a scene. Its buffers are reused. */
class MorphStep {
    #morphs;
    #paths;
    #scene;
    #table = new SceneTimetable();
    #tracer;
    #share = NaN; // of the scene and its timetable

    /**
     * @param {MorphingDrawing} drawing
     * @param {LineMorph[]} morphs
     * @param {number} rate points per second
     */
    constructor(drawing, morphs, rate) {
        this.#morphs = morphs.filter((morph) => morph.from.length > 0);
        this.#paths = this.#morphs.map((morph) => emptyMorphPath(morph.from.length / 2));
        /** @type {import('./scene_pose.js').SceneItem} */
        const item = {
            paths: this.#paths,
            at: [0, 0],
            scale: 1,
            turn: [0, 0, 0],
            spin: [0, drawing.spin, 0],
            perspective: 3,
            current: 1,
            speed: 1,
            dwell_seconds: 0,
        };
        this.#scene = {
            items: [item],
            beam_speed: drawing.beam_speed,
            move_speed: 5000,
            move_current: 0,
            refresh: drawing.refresh,
        };
        this.#tracer = new SceneTracer([item], this.#table, rate);
    }

    /** The longest duration of a drawing, without waiting. */
    longestSeconds() {
        const moving = { ...this.#scene, refresh: 0 };
        return Math.max(...[0, 1].map((share) => {
            this.#morphTo(share);
            this.#table.build(moving);
            return this.#table.seconds;
        }));
    }

    /**
     * @param {number} share 0..1
     * @returns {SceneTracer} of the drawing at this progress
     */
    tracerAt(share) {
        if (share !== this.#share) {
            this.#morphTo(share);
            this.#table.build(this.#scene);
            this.#share = share;
        }
        return this.#tracer;
    }

    /** @param {number} share */
    #morphTo(share) {
        this.#morphs.forEach(({ from, to }, line) => {
            const points = this.#paths[line].points;
            for (let i = 0; i < from.length; i += 2) {
                points[2 * i] = linearBetween(from[i], to[i], share);
                points[2 * i + 1] = linearBetween(from[i + 1], to[i + 1], share);
            }
        });
    }
}

/**
 * @param {number} count of points
 * @returns {{points: Float64Array, smooth: boolean}}
 */
function emptyMorphPath(count) {
    const points = new Float64Array(NUMBERS_PER_SCENE_POINT * count);
    for (let i = 0; i < count; i++) {
        points[NUMBERS_PER_SCENE_POINT * i + 3] = 1; // full current
    }
    return { points, smooth: false };
}
