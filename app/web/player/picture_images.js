// The pictures of a look as textures.

import { deleteGlCanvas, makeGlCanvas, makeSolidTexture, updateLevels } from '../gl/textures.js';
import { pixelFormat } from '../gl/formats.js';
import { supportedFormat } from '../graph/targets.js';
import { columnOfFaces, columnOfLayers } from '../sources/solid_picture.js';

/**
 * @typedef {import('../look/types.js').LookDescription} PicturedLook
 * @typedef {import('../look/types.js').ImageDescription} ImageEntry
 * @typedef {import('../sources/source.js').SourcePicture} ImagePicture
 * @typedef {import('../graph/source_texture.js').PicturePlacer} ImagePlacer
 * @typedef {import('../gl/textures.js').GlTexture} ImageTexture
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
 * The faces or slices of pictures in a column, as one picture.
 * @param {ImagePlacer} placer
 * @param {ImagePicture[]} pictures one, or six faces
 * @param {'cube'|'volume'} shape
 * @returns {ImagePicture}
 */
function columnOfPictures(placer, pictures, shape) {
    const flat = pictures.map((picture) => ({ width: picture.width, height: picture.height,
        texels: placer.texelsOf(picture) }));
    const { width, height, texels } = flat.length > 1 ? columnOfFaces(flat)
        : columnOfLayers(flat[0], shape);
    return { width, height, channels: 4, encoding: pictures[0].encoding, pixels: texels,
        isTopFirst: true };
}

/**
 * Copies the layers in a column to a cube map or volume.
 * @param {WebGL2RenderingContext} gl
 * @param {import('../gl/textures.js').GlCanvas} column
 * @param {'cube'|'volume'} shape
 * @param {boolean} isMipmapped
 * @returns {ImageTexture}
 */
function solidOfColumn(gl, column, shape, isMipmapped) {
    const side = column.width;
    const made = makeSolidTexture(gl, column.format, side, shape, isMipmapped);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, column.framebuffer);
    for (let layer = 0; layer < column.height / side; layer++)
        if (shape === 'cube')
            gl.copyTexSubImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + layer, 0, 0, 0, 0,
                layer * side, side, side);
        else
            gl.copyTexSubImage3D(gl.TEXTURE_3D, 0, 0, 0, layer, 0, layer * side, side, side);
    updateLevels(gl, made);
    return made;
}

/**
 * A picture of a look as a texture, encoded as its look expects.
 * @param {import('../graph/renderer.js').Renderer} renderer
 * @param {string} name of the image or of a parameter
 * @param {ImagePicture[]} pictures one, or the six faces of a cube
 * @returns {ImageTexture}
 */
export function imageTexture(renderer, name, pictures) {
    const { look, gl } = renderer;
    const placer = /** @type {ImagePlacer} */ (renderer.placer);
    const declared = look.images.find((one) => one.name === name);
    const shape = declared ? declared.shape : 'flat';
    const picture = shape === 'flat' ? pictures[0] : columnOfPictures(placer, pictures, shape);
    const { width, height } = picture;
    const format = pixelFormat(gl, supportedFormat(renderer.context,
        declared ? declared.format : 'rgba32f', false, true));
    const isMipmapped = readsLevels(look, name);
    const canvas = makeGlCanvas(gl, format, width, height, isMipmapped && shape === 'flat');
    const wanted = (declared && declared.encoding) || look.source_encoding;
    // Targets of this format encode what is drawn.
    const isSrgb = format.internal === gl.SRGB8_ALPHA8;
    placer.draw(picture, canvas, {
        placing: { width, height, left: 0, top: 0, repeatX: 1, repeatY: 1, shrink: 1 },
        encoding: isSrgb ? 'linear' : declared && declared.linear ? null : wanted,
        isTopFirst: !!declared && declared.rows === 'top-first',
    });
    if (shape === 'flat')
        return canvas;
    const solid = solidOfColumn(gl, canvas, shape, isMipmapped);
    deleteGlCanvas(gl, canvas);
    return solid;
}
