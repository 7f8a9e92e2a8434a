// Uniforms that the player sets, docs/portable.md.

/**
 * @typedef {import('./plan.js').Size} BuiltInSize
 * @typedef {{rows: number[], columns: number[]}} SourceRaster start, distance and count of lines
 * @typedef {{time: number, delta: number, number: number, mouse: [number, number],
 *     press: number[], date: [number, number, number, number], aspect: number,
 *     raster: SourceRaster|null}} FrameState
 *     `time` in s at the frame's end, `number` from 1, `aspect` width / height of a source pixel,
 *     `date` year, month from 1, day, seconds.
 * @typedef {{target: BuiltInSize, output: BuiltInSize, source: BuiltInSize, isTopFirst: boolean,
 *     modulo: number, isOwnSource: boolean, read: (of: any) => BuiltInSize}} PassState
 */

/** @param {BuiltInSize} size */
function extentNumbers(size) {
    const width = Math.max(size.width, 1);
    const height = Math.max(size.height, 1);
    return [width, height, 1 / width, 1 / height];
}

/** @param {BuiltInSize} size */
function resolutionNumbers(size) {
    return [size.width, size.height, 1];
}

/**
 * Lines of a source that fills the picture.
 * @param {number} count
 */
function ownLines(count) {
    return [0, 1 / Math.max(count, 1), count];
}

/**
 * From 0..1 to clip space. The quad's y points down from the top of the picture.
 * @param {boolean} isTopFirst
 */
function quadToClip(isTopFirst) {
    const down = isTopFirst ? 1 : -1;
    return [2, 0, 0, 0, 0, 2 * down, 0, 0, 0, 0, 1, 0, -1, -down, 0, 1];
}

/** @param {number} number @param {number} modulo 0: none */
function countedFrame(number, modulo) {
    return modulo > 0 ? number % modulo : number;
}

/**
 * The numbers of a built-in value. Null: the caller sets it.
 * @param {import('../look/types.js').BuiltInDescription} builtIn
 * @param {FrameState} frame
 * @param {PassState} pass
 * @returns {number[]|null}
 */
export function builtInNumbers(builtIn, frame, pass) {
    const raster = pass.isOwnSource ? frame.raster : null;
    const [year, month, day, seconds] = frame.date;
    switch (builtIn.value) {
        case 'time': return [frame.time];
        case 'time_delta': return [frame.delta];
        case 'frame_rate': return [frame.delta > 0 ? 1 / frame.delta : 0];
        case 'frame': return [countedFrame(frame.number, pass.modulo)];
        case 'frame_index':
        case 'source_frame_index': return [countedFrame(Math.max(frame.number - 1, 0), pass.modulo)];
        // Pages draw without HDR, and whole frames.
        case 'peak': return [1];
        case 'hdr_mode': return [0];
        case 'paper_white': return [200];
        case 'subframe': return [0];
        case 'subframe_number':
        case 'subframes': return [1];
        case 'microseconds': return [Math.round(frame.delta * 1e6)];
        case 'time_before': return [frame.time - frame.delta];
        case 'delta_before': return [frame.number > 1 ? frame.delta : 0];
        case 'date': return [year, month, day, seconds];
        case 'date_from_0': return [year, month - 1, day, seconds];
        case 'target_size': return [pass.target.width, pass.target.height];
        case 'output_size': return [pass.output.width, pass.output.height];
        case 'source_size': return [pass.source.width, pass.source.height];
        case 'source_aspect':
            return [(pass.source.width * frame.aspect) / Math.max(pass.source.height, 1)];
        case 'source_lines': return raster ? raster.rows : ownLines(pass.source.height);
        case 'source_columns': return raster ? raster.columns : ownLines(pass.source.width);
        case 'mouse': return frame.mouse;
        case 'press': return frame.press;
        case 'quad_to_clip': return quadToClip(pass.isTopFirst);
        case 'target_extent': return extentNumbers(pass.target);
        case 'output_extent': return extentNumbers(pass.output);
        case 'input_extent': return extentNumbers(pass.read(builtIn.of));
        case 'target_resolution': return resolutionNumbers(pass.target);
        case 'input_resolution': return resolutionNumbers(pass.read(builtIn.of));
        case 'drawn_onto': return [0];
        default: return null;
    }
}
