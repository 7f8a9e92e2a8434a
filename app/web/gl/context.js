// The WebGL 2 context and what it can do.

/**
 * @typedef {{gl: WebGL2RenderingContext, hasFloatTargets: boolean, hasFloatBlending: boolean,
 *     hasFloatFilter: boolean, largestSide: number, notes: string[]}} GlContext
 */

/**
 * Creates the context of a canvas. Throws if the browser has no WebGL 2 or no float targets.
 * @param {HTMLCanvasElement} canvas
 * @param {boolean} isTransparent
 * @returns {GlContext}
 */
export function makeGlContext(canvas, isTransparent) {
    const gl = canvas.getContext('webgl2', {
        alpha: isTransparent,
        antialias: false,
        depth: false,
        stencil: false,
        premultipliedAlpha: false,
        powerPreference: 'high-performance',
    });
    if (!gl)
        throw new Error('This browser has no WebGL 2. Enable graphics acceleration in its settings, '
            + 'or use another browser.');
    return glContextOf(gl);
}

/**
 * Enables the extensions. They must be enabled again after the context was lost.
 * @param {WebGL2RenderingContext} gl
 * @returns {GlContext}
 */
export function glContextOf(gl) {
    const hasFloatTargets = !!gl.getExtension('EXT_color_buffer_float');
    const hasHalfTargets = hasFloatTargets || !!gl.getExtension('EXT_color_buffer_half_float');
    if (!hasHalfTargets)
        throw new Error('This browser lacks EXT_color_buffer_half_float: it can\'t draw into '
            + 'float textures. Use another browser or device.');
    const context = {
        gl,
        hasFloatTargets,
        hasFloatBlending: hasFloatTargets && !!gl.getExtension('EXT_float_blend'),
        hasFloatFilter: !!gl.getExtension('OES_texture_float_linear'),
        largestSide: gl.getParameter(gl.MAX_TEXTURE_SIZE),
        notes: /** @type {string[]} */ ([]),
    };
    const missing = [
        ['EXT_color_buffer_float', context.hasFloatTargets],
        ['EXT_float_blend', context.hasFloatBlending],
        ['OES_texture_float_linear', context.hasFloatFilter],
    ].filter(([, has]) => !has).map(([name]) => name);
    if (missing.length > 0)
        context.notes.push(`This browser lacks ${missing.join(', ')}. Light is stored in 16 bits `
            + 'where needed, so faint light may fade inaccurately.');
    return context;
}
