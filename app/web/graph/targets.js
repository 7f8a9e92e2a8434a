// The targets of a look with their previous pictures.

import { clearGlCanvas, deleteGlCanvas, makeGlCanvas } from '../gl/textures.js';
import { stretchGlCanvas, updateLevels } from '../gl/textures.js';
import { halfFloatsOf, pixelFormat } from '../gl/formats.js';

/**
 * @typedef {import('../gl/textures.js').GlCanvas} TargetCanvas
 * @typedef {import('./plan.js').PlannedTarget} TargetPlan
 */

/** The stored pictures of a pass: a ring of canvases. */
export class PassTarget {
    /**
     * @param {WebGL2RenderingContext} gl
     * @param {TargetPlan} planned
     * @param {string} format that the browser supports
     */
    constructor(gl, planned, format) {
        this.gl = gl;
        this.key = PassTarget.keyOf(planned, format);
        this.current = 0;
        /** @type {TargetCanvas[]} */
        this.slots = [];
        for (let i = 0; i < planned.slots; i++)
            this.slots.push(makeGlCanvas(gl, pixelFormat(gl, format), planned.width, planned.height,
                planned.isMipmapped));
    }

    /**
     * @param {TargetPlan} planned
     * @param {string} format
     */
    static keyOf(planned, format) {
        return [planned.width, planned.height, format, planned.slots, planned.isMipmapped].join();
    }

    /**
     * The picture of some frames ago, at most of the oldest one that is stored.
     * @param {number} framesAgo
     * @returns {TargetCanvas}
     */
    canvas(framesAgo) {
        const count = this.slots.length;
        const back = Math.min(framesAgo, count - 1);
        return this.slots[(this.current + count - back) % count];
    }

    /**
     * Whether another target of the pass continues its history. Integers have no filter.
     * @param {import('../look/types.js').PassDescription} pass
     * @param {PassTarget} next
     */
    canBeStretched(pass, next) {
        const format = this.slots[0].format;
        return !!pass.target.keeps_when_resized && next.slots.length > 1 && format.kind === 'float'
            && format.internal === next.slots[0].format.internal;
    }

    /**
     * Takes over the pictures of a target of another size.
     * @param {PassTarget} old with the same format
     */
    stretchFrom(old) {
        for (let ago = 0; ago < Math.min(this.slots.length, old.slots.length); ago++)
            stretchGlCanvas(this.gl, old.canvas(ago), this.canvas(ago));
    }

    /** The next picture replaces the oldest. */
    advance() {
        this.current = (this.current + 1) % this.slots.length;
    }

    clear() {
        for (const slot of this.slots) {
            clearGlCanvas(this.gl, slot, 0);
            updateLevels(this.gl, slot);
        }
    }

    dispose() {
        for (const slot of this.slots)
            deleteGlCanvas(this.gl, slot);
        this.slots = [];
    }
}

/**
 * The format that replaces one which this browser can't draw into, blend or filter.
 * @param {import('../gl/context.js').GlContext} context
 * @param {string} format
 * @param {boolean} isBlended
 * @param {boolean} isFiltered
 */
export function supportedFormat(context, format, isBlended, isFiltered) {
    const isFloat = /32f$/.test(format);
    const isLimited = !context.hasFloatTargets || (isBlended && !context.hasFloatBlending)
        || (isFiltered && !context.hasFloatFilter);
    if (format === 'r11f_g11f_b10f' && !context.hasFloatTargets)
        return 'rgba16f';
    return isFloat && isLimited ? halfFloatsOf(format) : format;
}
