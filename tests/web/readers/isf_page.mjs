// Runs in a page: draws an ISF file with npm's interactive-shader-format 2.9.0.
//
// The package is made for WebGL 1. ISF programs on a desktop have newer GLSL and float targets.
// Therefore the package gets a context of WebGL 2 here, with the adapters below. Its parser,
// passes, sizes, inputs and uniforms are unchanged.
import { Renderer } from '../../../build/npm/interactive-shader-format';
import { floatContext, loadedImage, throwOnError } from './webgl.mjs';

const stageStarts = {
    vertex: '#define attribute in\n#define varying out\n',
    fragment: '#define varying in\nout vec4 isf_FragColor;\n',
};

/**
 * Compiles shaders as GLSL ES 3.00. The package writes GLSL ES 1.00, which has no unsigned
 * integers. Version 3.00 has no `gl_FragColor`, so it gets another name.
 */
function useNewerGlsl(gl) {
    const { shaderSource } = gl;
    gl.shaderSource = (shader, text) => {
        const isVertex = gl.getShaderParameter(shader, gl.SHADER_TYPE) === gl.VERTEX_SHADER;
        shaderSource.call(gl, shader, '#version 300 es\nprecision highp float;\n'
            + `precision highp int;\nprecision highp sampler2D;\n`
            + `${stageStarts[isVertex ? 'vertex' : 'fragment']}#define texture2D texture\n`
            + text.replace(/\bgl_FragColor\b/g, 'isf_FragColor'));
    };
}

/**
 * Stores targets with `FLOAT` as 32-bit floats. The package asks for unsized RGBA, which WebGL 2
 * cannot draw to as floats.
 */
function useFloatTargets(gl) {
    const { texImage2D } = gl;
    gl.texImage2D = (target, level, format, ...rest) => texImage2D.call(gl, target, level,
        rest.includes(gl.FLOAT) ? gl.RGBA32F : format, ...rest);
}

/**
 * Draws to 32-bit floats instead of to the canvas. The package has one shader for all passes, which
 * software GL compiles again for each format. One format takes half the time.
 */
function useFloatCanvas(gl, width, height) {
    const { bindFramebuffer } = gl;
    const texture = gl.createTexture();
    const canvas = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
    gl.bindFramebuffer = (target, framebuffer) =>
        bindFramebuffer.call(gl, target, framebuffer || canvas);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
}

/** The URL of a PNG file with the drawn numbers from 0 to 1, rounded to 8 bits. */
function pictureUrl(gl, width, height) {
    const numbers = new Float32Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, numbers);
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const picture = new ImageData(width, height);
    for (let y = 0; y < height; ++y)
        for (let i = 0; i < 4 * width; ++i)
            picture.data[y * 4 * width + i] = i % 4 === 3 ? 255
                : 255 * numbers[(height - 1 - y) * 4 * width + i];
    canvas.getContext('2d').putImageData(picture, 0, 0);
    return canvas.toDataURL();
}

/**
 * Lets a pass read what earlier passes of the same frame drew, as the specification says. The
 * package binds all buffers before the first pass, so each pass gets those of the previous frame.
 * After each pass it unbinds the texture of the active unit. A spare unit is active then.
 */
function bindDrawnBuffers(gl, renderer) {
    const { drawArrays, framebufferTexture2D } = gl;
    const spareUnit = gl.TEXTURE0 + gl.getParameter(gl.MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1;
    let drawn = null;
    gl.framebufferTexture2D = (...words) => {
        drawn = words[3];
        framebufferTexture2D.apply(gl, words);
    };
    gl.drawArrays = (...words) => {
        drawArrays.apply(gl, words);
        const index = renderer.renderBuffers.findIndex(({ textures }) =>
            textures.some(({ texture }) => texture === drawn));
        if (index >= 0) {
            gl.activeTexture(gl.TEXTURE0 + index);  // the unit that the package gives to this buffer
            gl.bindTexture(gl.TEXTURE_2D, drawn);
        }
        gl.activeTexture(spareUnit);
        drawn = null;
    };
}

/** A renderer of an ISF text. */
function startedRenderer(gl, text) {
    const renderer = new Renderer(gl);
    renderer.loadSource(text);
    if (!renderer.valid) throw new Error(renderer.error.message || String(renderer.error));
    for (const { buffer, target, width, height } of renderer.model.passes) {
        // Before the first frame, the package gives the first buffer's unit to the first image too.
        renderer.contextState.newTextureIndex();
        // It creates targets in the first frame. Software GL compiles again for each new target.
        if (target) buffer.setSize(...[width, height].map((side) =>
            renderer.evaluateSize(gl.canvas, side)));
    }
    bindDrawnBuffers(gl, renderer);
    return renderer;
}

/**
 * Draws frames at 60 per second and returns the last one as the URL of a PNG file.
 * @param {{text: string, values: Record<string, unknown>, picture: string, width: number,
 *     height: number, frames: number}} wanted `picture` is the URL of all images
 */
export async function draw({ text, values, picture, width, height, frames }) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const gl = floatContext(canvas);
    useNewerGlsl(gl);
    useFloatTargets(gl);
    useFloatCanvas(gl, width, height);
    const image = await loadedImage(picture);
    let now = 0;
    Date.now = () => now;  // the clock of the package
    const renderer = startedRenderer(gl, text);
    for (const [name, value] of Object.entries(values)) renderer.setValue(name, value);
    for (let frame = 0; frame < frames; ++frame) {
        now = frame * 1000 / 60;
        for (const { NAME, TYPE } of renderer.model.inputs)
            if (TYPE === 'image') renderer.setValue(NAME, image);
        renderer.draw(canvas);
    }
    throwOnError(gl);
    return pictureUrl(gl, width, height);
}
