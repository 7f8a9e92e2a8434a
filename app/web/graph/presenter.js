// Shows the picture of a look on the page's canvas, and reads its pixels.

import { linkedProgram, startProgram, writeUniform } from '../gl/programs.js';
import { makeGlCanvas } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';

const presentVertex = `#version 300 es
void main()
{
    vec2 p = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(p * 2.0 - 1.0, 0.0, 1.0);
}
`;

// IEC 61966-2-1.
const presentFragment = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D picture;
uniform ivec2 shown;
uniform bool is_linear;
uniform bool top_first;
uniform int alpha;  // 0: opaque, 1: its own, 2: transparent where it is black
out vec4 color;
vec3 encoded(vec3 c)
{
    return mix(c * 12.92, 1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055,
               vec3(greaterThan(c, vec3(0.0031308))));
}
void main()
{
    ivec2 size = textureSize(picture, 0);
    ivec2 at = ivec2(gl_FragCoord.xy) * size / shown;
    if (top_first)
        at.y = size.y - 1 - at.y;
    color = clamp(texelFetch(picture, at, 0), 0.0, 1.0);
    if (is_linear)
        color.rgb = encoded(color.rgb);
    if (alpha == 0)
        color.a = 1.0;
    if (alpha == 2) {
        color.a = max(max(color.r, color.g), color.b);
        color.rgb /= max(color.a, 1e-6);
    }
}
`;

/**
 * @typedef {{isLinear: boolean, isTopFirst: boolean, alpha: 'opaque'|'own'|'from-black'}}
 *     PresentedAs
 *     What the texels of the picture hold, and the alpha that is shown. From black, alpha is the
 *     largest component, and the colour is divided by it.
 */

/** Draws a texture onto the canvas, or into bytes. */
export class Presenter {
    /** @param {WebGL2RenderingContext} gl */
    constructor(gl) {
        this.gl = gl;
        this.linked = linkedProgram(gl, startProgram(gl, presentVertex, presentFragment), 'output');
    }

    /**
     * @param {import('../gl/textures.js').GlTexture} picture
     * @param {PresentedAs} as
     * @param {WebGLFramebuffer|null} framebuffer null: the canvas
     * @param {number} width px
     * @param {number} height px
     */
    draw(picture, as, framebuffer, width, height) {
        const gl = this.gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.viewport(0, 0, width, height);
        gl.disable(gl.BLEND);
        gl.useProgram(this.linked.program);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, picture.texture);
        gl.bindSampler(0, null);
        this.write('shown', [width, height]);
        this.write('is_linear', [as.isLinear ? 1 : 0]);
        this.write('top_first', [as.isTopFirst ? 1 : 0]);
        this.write('alpha', [['opaque', 'own', 'from-black'].indexOf(as.alpha)]);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        gl.bindVertexArray(null);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /** @param {string} name @param {number[]} numbers */
    write(name, numbers) {
        const uniform = this.linked.uniforms.get(name);
        if (uniform)
            writeUniform(this.gl, uniform, numbers);
    }

    /**
     * The picture in 8 bits, row 0 at the top.
     * @param {import('../gl/textures.js').GlTexture} picture
     * @param {PresentedAs} as
     * @returns {ImageData}
     */
    read(picture, as) {
        const gl = this.gl;
        const { width, height } = picture;
        const canvas = makeGlCanvas(gl, pixelFormat(gl, 'rgba8'), width, height, false);
        // Rows of pixels are read from the bottom.
        this.draw(picture, { ...as, isTopFirst: !as.isTopFirst }, canvas.framebuffer, width, height);
        const image = new ImageData(width, height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE,
            new Uint8Array(image.data.buffer));
        gl.deleteFramebuffer(canvas.framebuffer);
        gl.deleteTexture(canvas.texture);
        return image;
    }
}
