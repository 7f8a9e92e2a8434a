// Runs in a page: a player of Shadertoy's JSON, written from the documented behaviour of the site.
import { floatContext, loadedImage, throwOnError } from './webgl.mjs';

const bufferIds = ['4dXGR8', 'XsXGR8', '4sXGR8', 'XdfGR8'];  // the site's ids of Buffer A to D
const imageIndex = bufferIds.length;
const vertexText = `#version 300 es
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;
const startText = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform vec3 iResolution;
uniform float iTime;
uniform float iTimeDelta;
uniform float iFrameRate;
uniform int iFrame;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform vec4 iMouse;
uniform vec4 iDate;
uniform float iSampleRate;
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
out vec4 shadertoy_color;
`;
const endText = `
void main() {
    shadertoy_color = vec4(0.0, 0.0, 0.0, 1.0);
    mainImage(shadertoy_color, gl_FragCoord.xy);
}
`;

/** The passes in drawing order: {index, code, inputs}. Buffers are 0 to 3, the image is 4. */
function passesOf({ renderpass }) {
    const common = renderpass.find(({ type }) => type === 'common')?.code || '';
    return renderpass.filter(({ type }) => type !== 'common').map(({ type, outputs, inputs, code }) => {
        const index = type === 'image' ? imageIndex : bufferIds.indexOf(outputs[0].id);
        if (index < 0) throw new Error(`pass of type ${type} with output ${outputs[0].id}`);
        return { index, inputs, code: `${startText}${common}\n${code}${endText}` };
    }).sort((a, b) => a.index - b.index);
}

function compiled(gl, kind, text) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(gl.getShaderInfoLog(shader));
    return shader;
}

function linked(gl, text) {
    const program = gl.createProgram();
    gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertexText));
    gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, text));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
        throw new Error(gl.getProgramInfoLog(program));
    return program;
}

/** A buffer of 32-bit floats. textures[0] holds what was drawn last. */
function bufferOf(gl, width, height) {
    const textures = [0, 1].map(() => {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        const levels = 1 + Math.floor(Math.log2(Math.max(width, height)));
        gl.texStorage2D(gl.TEXTURE_2D, levels, gl.RGBA32F, width, height);
        return texture;
    });
    return { textures, width, height, target: gl.createFramebuffer() };
}

function textureOf(gl, image) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
    return { textures: [texture], width: image.naturalWidth, height: image.naturalHeight };
}

/** Binds what an input reads to its channel. */
function bindInput(gl, { program }, { channel, sampler }, { textures, width, height }) {
    const small = { nearest: gl.NEAREST, linear: gl.LINEAR, mipmap: gl.LINEAR_MIPMAP_LINEAR };
    const wraps = { clamp: gl.CLAMP_TO_EDGE, repeat: gl.REPEAT };
    gl.activeTexture(gl.TEXTURE0 + channel);
    gl.bindTexture(gl.TEXTURE_2D, textures[0]);
    if (sampler.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, small[sampler.filter]);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER,
        sampler.filter === 'nearest' ? gl.NEAREST : gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wraps[sampler.wrap]);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wraps[sampler.wrap]);
    gl.uniform3f(gl.getUniformLocation(program, `iChannelResolution[${channel}]`), width, height, 1);
}

/** Sets the uniforms of a pass for a frame from 0, at 60 frames per second. */
function setUniforms(gl, { program }, frame, { width, height }) {
    const at = (name) => gl.getUniformLocation(program, name);
    const seconds = frame / 60;
    gl.uniform3f(at('iResolution'), width, height, 1);
    gl.uniform1f(at('iTime'), seconds);
    gl.uniform1f(at('iTimeDelta'), 1 / 60);
    gl.uniform1f(at('iFrameRate'), 60);
    gl.uniform1i(at('iFrame'), frame);
    gl.uniform1fv(at('iChannelTime'), [seconds, seconds, seconds, seconds]);
    gl.uniform4f(at('iDate'), 2000, 0, 1, seconds);
    gl.uniform1f(at('iSampleRate'), 44100);
    for (let channel = 0; channel < 4; ++channel) gl.uniform1i(at(`iChannel${channel}`), channel);
}

/** Draws a pass. A buffer keeps its previous picture until then, which the pass may read. */
function drawPass(gl, pass, buffers, source, frame, size) {
    const buffer = buffers[pass.index];
    gl.useProgram(pass.program);
    setUniforms(gl, pass, frame, size);
    for (const input of pass.inputs)
        bindInput(gl, pass, input,
            input.ctype === 'buffer' ? buffers[bufferIds.indexOf(input.id)] : source);
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer ? buffer.target : null);
    if (buffer) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D,
        buffer.textures[1], 0);
    gl.viewport(0, 0, size.width, size.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    if (buffer) buffer.textures.reverse();
}

/**
 * Draws frames at 60 per second and returns the last one as the URL of a PNG file.
 * @param {{text: string, picture: string, width: number, height: number, frames: number}} wanted
 *     `picture` is the URL of what a webcam shows
 */
export async function draw({ text, picture, width, height, frames }) {
    const size = { width, height };
    const canvas = Object.assign(document.createElement('canvas'), size);
    const gl = floatContext(canvas);
    const source = textureOf(gl, await loadedImage(picture));
    const passes = passesOf(JSON.parse(text)).map((pass) => ({ ...pass, program: linked(gl, pass.code) }));
    const buffers = bufferIds.map(() => bufferOf(gl, width, height));
    for (let frame = 0; frame < frames; ++frame)
        for (const pass of passes) drawPass(gl, pass, buffers, source, frame, size);
    throwOnError(gl);
    return canvas.toDataURL();
}
