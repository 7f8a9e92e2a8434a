// Signals that draw a scene repeatedly: texts, scene files and models.
import { chargeOfPoint } from '../points.js';
import { numberSetting } from '../signal.js';
import { linearBetween } from '../sine.js';
import { ScenePose } from './scene_pose.js';
import { SceneTimetable } from './timetable.js';

const TIME_SLACK = 1e-9; // s: tolerance for span ends computed in two ways

/**
 * A text or a scene. Rotation changes between drawings only.
 * @param {import('../signal.js').SignalSettings} settings
 * @param {import('./timetable.js').BeamScene} scene
 * @returns {import('../signal.js').Signal}
 */
export function makeScene(settings, scene) {
    const table = new SceneTimetable();
    table.build(scene);
    if (table.seconds < 1e-6 || !table.current.subarray(0, table.count).some((lit) => lit > 0)) {
        throw new Error('The scene has nothing to draw. Choose another signal.');
    }
    const tracer = new SceneTracer(scene.items, table, 60 * numberSetting(settings, 'points'));
    return {
        seconds: Infinity,
        trace: (start, end, beam) => {
            forEachDrawing(start, end, table.seconds, (time) => {
                tracer.trace(time, start, end, beam);
            });
        },
    };
}

/**
 * Calls back with the start of each drawing that has points in (start, end].
 * @param {number} start in s
 * @param {number} end in s
 * @param {number} length of a drawing, in s
 * @param {(seconds: number) => void} draw
 */
export function forEachDrawing(start, end, length, draw) {
    const inside = Math.floor(Math.max(start, 0) / length);
    // The last point of the previous drawing may be just after its end.
    for (let drawing = Math.max(inside - 1, 0); drawing * length < end; drawing++) {
        draw(drawing * length);
    }
}

/**
 * Traces one drawing of a scene, in the state at its start.
 * Each straight leg is divided evenly, and its ends are always points.
 */
export class SceneTracer {
    #table;
    #rate;
    #poses;

    /**
     * @param {import('./scene_pose.js').SceneItem[]} items
     * @param {SceneTimetable} table
     * @param {number} rate at least this number of points per second
     */
    constructor(items, table, rate) {
        this.#table = table;
        this.#rate = rate;
        this.#poses = items.map((item) => new ScenePose(item));
    }

    /**
     * Appends the points of (start, end].
     * @param {number} drawn start of the drawing, in s
     * @param {number} start in s
     * @param {number} end in s
     * @param {import('../beam.js').Beam} beam
     */
    trace(drawn, start, end, beam) {
        const table = this.#table;
        for (const pose of this.#poses) {
            pose.turnTo(drawn);
        }
        let leg = this.#firstLegEndingAfter(start - drawn);
        for (; leg < table.count && drawn + table.begin[leg] <= end; leg++) {
            this.#traceLeg(leg, drawn + table.begin[leg], start, end, beam);
        }
    }

    /**
     * @param {number} time in s of the drawing
     * @returns {number} leg
     */
    #firstLegEndingAfter(time) {
        const { begin, duration, count } = this.#table;
        let low = 0;
        let high = count;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (time < begin[middle] + duration[middle] + TIME_SLACK) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }

    /**
     * @param {number} leg
     * @param {number} legStart in s
     * @param {number} start of the span, in s
     * @param {number} end
     * @param {import('../beam.js').Beam} beam
     */
    #traceLeg(leg, legStart, start, end, beam) {
        const { from, to, duration, current } = this.#table;
        const begin = this.#project(from[leg]);
        const x0 = begin.x;
        const y0 = begin.y;
        const target = this.#project(to[leg]);
        const x1 = target.x;
        const y1 = target.y;
        const isLit = current[leg] > 0;
        const steps = isLit ? Math.max(1, Math.ceil(duration[leg] * this.#rate)) : 1;
        const step = duration[leg] / steps;
        const charge = isLit ? current[leg] * step * chargeOfPoint(1) : 0;
        const first = Math.floor((start - legStart) / step);
        for (let i = Math.min(Math.max(first, 1), steps); i <= steps; i++) {
            const time = legStart + i * step;
            if (time > end + TIME_SLACK) {
                return;
            }
            if (time > start + TIME_SLACK) {
                const share = i / steps;
                const x = linearBetween(x0, x1, share);
                const y = linearBetween(y0, y1, share);
                beam.add(x, y, charge, Math.max(end - time, 0));
            }
        }
    }

    /**
     * @param {number} corner
     * @returns {ScenePose} with the position on the screen
     */
    #project(corner) {
        const pose = this.#poses[this.#table.items[corner]];
        pose.project(this.#table.corners, 3 * corner);
        return pose;
    }
}
