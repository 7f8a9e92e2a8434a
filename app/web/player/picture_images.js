// The pictures of a look as textures.

import { makeGlCanvas } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';

/**
 * @typedef {import('../look/types.js').LookDescription} PicturedLook
 * @typedef {import('../look/types.js').ImageDescription} ImageEntry
 * @typedef {import('../sources/source.js').SourcePicture} ImagePicture
 */

/**
 * Whether an input reads mip levels of an image.
 * @param {PicturedLook} look
 * @param {string} name
 */
function readsLevels(look, name) {
    return look.passes.some((pass) => pass.inputs.some((input) =>
        input.from === 'image' && input.name === name && input.mipmap));
}

/**
 * A picture of a look as a texture, encoded as its look expects.
 * @param {import('../graph/renderer.js').Renderer} renderer
 * @param {string} name of the image or of a parameter
 * @param {ImagePicture} picture
 */
export function imageTexture(renderer, name, picture) {
    const { look, gl } = renderer;
    const declared = look.images.find((one) => one.name === name);
    if (declared && declared.shape !== 'flat')
        throw new Error(`A page can't draw the picture '${name}': it is a ${declared.shape}.`);
    const format = pixelFormat(gl, declared ? declared.format : 'rgba32f');
    const canvas = makeGlCanvas(gl, format, picture.width, picture.height,
        readsLevels(look, name));
    const wanted = (declared && declared.encoding) || (look.source && look.source.encoding)
        || 'linear';
    // Targets of this format encode what is drawn.
    const isSrgb = format.internal === gl.SRGB8_ALPHA8;
    const placer = /** @type {import('../graph/source_texture.js').PicturePlacer} */ (renderer.placer);
    placer.draw(picture, canvas, {
        placing: { width: picture.width, height: picture.height, left: 0, top: 0, repeatX: 1,
            repeatY: 1, shrink: 1 },
        encoding: isSrgb ? 'linear' : declared && declared.linear ? null : wanted,
        isTopFirst: !!declared && declared.rows === 'top-first',
    });
    return canvas;
}
