// The beam of a frame as vertices: points, and segments that connect them across frames.

import { Beam } from '../signals/beam.js';
import { BeamTail } from '../signals/beam_tail.js';
import { mergeSegments } from '../signals/merge_segments.js';
import { SegmentBuffer, makeSegments } from '../signals/segments.js';

const beamAttributes = {
    points: { stride: 16, fields: { position: [2, 0], intensity: [1, 8], age_seconds: [1, 12] } },
    segments: { stride: 32,
        fields: { segment: [4, 0], intensities: [2, 16], ages_seconds: [2, 24] } },
};

/** GL buffers of the points and segments of a frame. */
export class BeamBuffers {
    /** @param {WebGL2RenderingContext} gl */
    constructor(gl) {
        this.gl = gl;
        this.tail = new BeamTail();
        this.scaled = new Beam();
        this.merged = new SegmentBuffer();
        this.hasTints = false;
        this.pointCount = 0;
        this.buffers = { points: gl.createBuffer(), segments: gl.createBuffer(),
            pointTints: gl.createBuffer(), segmentTints: gl.createBuffer() };
    }

    get segmentCount() {
        return this.merged.count;
    }

    /**
     * Uploads the vertices of a frame.
     * @param {Beam} beam points of the frame
     * @param {{seconds: number, isFirst: boolean, hasPoints: boolean,
     *     spot: {across: number, up: number}|null, scale: [number, number]}} frame
     *     `seconds` of the frame, `spot` of the passes that draw segments,
     *     `scale` multiplies positions
     */
    write(beam, frame) {
        const [scaleX, scaleY] = frame.scale;
        this.tail.advance(beam, frame.seconds, frame.isFirst);
        this.pointCount = beam.count;
        this.hasTints = beam.tints !== null;
        this.scaled.copyScaled(beam, scaleX, scaleY);
        if (frame.hasPoints) {
            this.upload(this.buffers.points, this.scaled.points, 4 * beam.count);
            if (this.scaled.tints)
                this.upload(this.buffers.pointTints, this.scaled.tints, 3 * beam.count);
        }
        this.merged.count = 0;
        if (!frame.spot)
            return;
        makeSegments(this.scaled, this.tail.before(scaleX, scaleY), this.merged);
        mergeSegments(this.merged, frame.spot);
        this.upload(this.buffers.segments, this.merged.segments, 8 * this.merged.count);
        if (this.merged.tints)
            this.upload(this.buffers.segmentTints, this.merged.tints, 3 * this.merged.count);
    }

    /** Discards the previous frames. */
    clear() {
        this.tail.clear();
    }

    /**
     * @param {WebGLBuffer|null} buffer
     * @param {Float32Array} numbers
     * @param {number} count
     */
    upload(buffer, numbers, count) {
        const gl = this.gl;
        if (count === 0)  // would upload all of it
            return;
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STREAM_DRAW, 0, count);
    }

    /**
     * The vertex attributes for a program that draws points or segments.
     * @param {WebGLProgram} program
     * @param {'points'|'segments'} draw
     * @returns {{vertices: WebGLVertexArrayObject, tint: number}} `tint`: location, -1 if unused
     */
    verticesFor(program, draw) {
        const gl = this.gl;
        const vertices = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
        gl.bindVertexArray(vertices);
        const layout = beamAttributes[draw];
        const isSegments = draw === 'segments';
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[draw]);
        for (const [name, [components, offset]] of Object.entries(layout.fields))
            this.addAttribute(gl.getAttribLocation(program, name), components, layout.stride, offset,
                isSegments);
        const tint = gl.getAttribLocation(program, 'tint');
        gl.bindBuffer(gl.ARRAY_BUFFER, isSegments ? this.buffers.segmentTints
            : this.buffers.pointTints);
        this.addAttribute(tint, 3, 12, 0, isSegments);
        gl.bindVertexArray(null);
        return { vertices, tint };
    }

    /**
     * @param {number} location
     * @param {number} components
     * @param {number} stride bytes
     * @param {number} offset bytes
     * @param {boolean} isPerInstance
     */
    addAttribute(location, components, stride, offset, isPerInstance) {
        const gl = this.gl;
        if (location < 0)
            return;
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, components, gl.FLOAT, false, stride, offset);
        gl.vertexAttribDivisor(location, isPerInstance ? 1 : 0);
    }

    /**
     * Draws the points or segments of the frame. The vertices must be bound.
     * @param {'points'|'segments'} draw
     * @param {number} tint location, -1 if unused
     */
    draw(draw, tint) {
        const gl = this.gl;
        const count = draw === 'points' ? this.pointCount : this.segmentCount;
        if (count === 0)
            return;
        if (tint >= 0 && this.hasTints)
            gl.enableVertexAttribArray(tint);
        else if (tint >= 0) {
            gl.disableVertexAttribArray(tint);
            gl.vertexAttrib3f(tint, 1, 1, 1);
        }
        if (draw === 'points')
            gl.drawArrays(gl.POINTS, 0, count);
        else
            gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    }
}

/**
 * Factors of beam positions, so that a signal fits the picture as it asks, whatever the look does.
 * @param {import('../look/types.js').LookDescription} look
 * @param {Map<string, number[]>} values
 * @param {{width: number, height: number}} picture
 * @param {string|number|undefined} fit of the signal
 * @returns {[number, number]}
 */
export function beamScale(look, values, picture, fit) {
    if (!fit || fit === 'look')
        return [1, 1];
    const scope = look.passes[0].scope || '';
    const parameter = look.parameters.find((one) => one.name === `${scope}fit`);
    const chosen = parameter && (values.get(parameter.name) || [NaN])[0];
    const isRound = !!parameter && parameter.items.some((item) => item.value === chosen
        && item.label === 'Keep circles round');
    const drawn = fitShares(picture, isRound ? 'whole' : 'stretch');
    const wanted = fitShares(picture, fit);
    return [wanted[0] / drawn[0], wanted[1] / drawn[1]];
}

/**
 * The part of width and height that the square from -1 to 1 covers.
 * @param {{width: number, height: number}} picture
 * @param {string|number} fit
 */
function fitShares(picture, fit) {
    if (fit === 'stretch')
        return [1, 1];
    const side = fit === 'crop' ? Math.max(picture.width, picture.height)
        : Math.min(picture.width, picture.height);
    return [side / picture.width, side / picture.height];
}
