// The keys that a look reads: a texture with a texel for each key.

import { pixelFormat } from '../gl/formats.js';
import { makeTexture } from '../gl/textures.js';

const keyCount = 256;
const keyRows = 3;  // down, pressed since the previous frame, pressed an odd number of times

/**
 * Whether a key is for the look: not for a control of the page, and not for the browser.
 * @param {KeyboardEvent} event
 */
function isForLook(event) {
    const isOfControl = event.target instanceof Element
        && !!event.target.closest('input, select, textarea, button, [contenteditable]');
    return !event.repeat && !isOfControl && !event.ctrlKey && !event.metaKey
        && !/^F\d/.test(event.key);
}

/** The state of the keys by their `keyCode`. */
export class KeyboardKeys {
    #texels = new Uint8Array(4 * keyCount * keyRows);
    #isChanged = true;

    constructor() {
        window.addEventListener('keydown', (event) => {
            if (isForLook(event))
                this.#press(event.keyCode);
        });
        window.addEventListener('keyup', (event) => this.#write(0, event.keyCode, false));
        window.addEventListener('blur', () => {
            for (let code = 0; code < keyCount; code++)
                this.#write(0, code, false);
        });
    }

    /** @param {number} code */
    #press(code) {
        if (code >= keyCount)
            return;
        this.#write(0, code, true);
        this.#write(1, code, true);
        this.#write(2, code, this.#texels[4 * (2 * keyCount + code)] === 0);
    }

    /**
     * @param {number} row
     * @param {number} code
     * @param {boolean} isOn
     */
    #write(row, code, isOn) {
        if (code >= keyCount)
            return;
        const at = 4 * (row * keyCount + code);
        this.#texels.fill(isOn ? 255 : 0, at, at + 4);
        this.#isChanged = true;
    }

    /**
     * Uploads the keys.
     * @param {WebGL2RenderingContext} gl
     * @param {Map<string, import('../gl/textures.js').GlTexture>} textures by name
     */
    update(gl, textures) {
        let texture = textures.get('keyboard');
        if (texture && !this.#isChanged)
            return;
        texture = texture || makeTexture(gl, pixelFormat(gl, 'rgba8'), keyCount, keyRows, false);
        textures.set('keyboard', texture);
        gl.bindTexture(gl.TEXTURE_2D, texture.texture);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, keyCount, keyRows, gl.RGBA, gl.UNSIGNED_BYTE,
            this.#texels);
        this.#isChanged = false;
    }

    /** Call after each frame: a press is new in one frame only. */
    endFrame() {
        for (let code = 0; code < keyCount; code++)
            if (this.#texels[4 * (keyCount + code)] !== 0)
                this.#write(1, code, false);
    }
}
