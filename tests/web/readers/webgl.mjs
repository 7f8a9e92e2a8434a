// Runs in a page: what players of shaders need from WebGL 2.

/** A context of a canvas with targets of 32-bit floats, which are filtered. */
export function floatContext(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false });
    for (const name of ['EXT_color_buffer_float', 'OES_texture_float_linear'])
        if (!gl.getExtension(name)) throw new Error(`WebGL 2 has no ${name}`);
    return gl;
}

export async function loadedImage(url) {
    const image = Object.assign(new Image(), { src: url });
    await image.decode();
    return image;
}

export function throwOnError(gl) {
    const error = gl.getError();
    if (error) throw new Error(`WebGL error ${error}`);
}
