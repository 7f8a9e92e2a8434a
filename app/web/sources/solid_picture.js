// Cube maps and volumes in flat pictures: their faces or slices in a column, from top to bottom.

/**
 * RGBA texels, row 0 at the top. Bytes mean n/255.
 * @typedef {{width: number, height: number, texels: Uint8Array|Float32Array}} FlatTexels
 */

const cubeFaceCount = 6;

/**
 * Where the faces are in a cross, in squares from the top left: column, row, and whether it is
 * upside down.
 * @type {[number, number, boolean][]}
 */
const wideCross = [[2, 1, false], [0, 1, false], [1, 0, false], [1, 2, false], [1, 1, false],
    [3, 1, false]];
/** @type {[number, number, boolean][]} */
const highCross = [...wideCross.slice(0, 5), [1, 3, true]];

/**
 * @param {FlatTexels} flat
 * @param {number} side px
 * @param {number} layers
 * @returns {FlatTexels}
 */
function emptyColumn(flat, side, layers) {
    const count = 4 * side * side * layers;
    return { width: side, height: side * layers, texels: flat.texels instanceof Float32Array
        ? new Float32Array(count) : new Uint8Array(count) };
}

/**
 * @param {FlatTexels} flat
 * @param {number} side px
 * @param {[number, number, boolean][]} places of the layers
 * @returns {FlatTexels}
 */
function columnOfSquares(flat, side, places) {
    const made = emptyColumn(flat, side, places.length);
    let at = 0;
    for (const [column, row, isTurned] of places)
        for (let y = 0; y < side; y++)
            for (let x = 0; x < side; x++, at += 4) {
                const left = column * side + (isTurned ? side - 1 - x : x);
                const top = row * side + (isTurned ? side - 1 - y : y);
                const from = 4 * (top * flat.width + left);
                for (let channel = 0; channel < 4; channel++)
                    made.texels[at + channel] = flat.texels[from + channel];
            }
    return made;
}

/**
 * The direction to a texel of a face, OpenGL 4.1, table 3.19.
 * @param {number} face
 * @param {number} u -1 to 1
 * @param {number} v -1 to 1
 */
function cubeDirection(face, u, v) {
    return [[1, -v, -u], [-1, -v, u], [u, 1, v], [u, -1, -v], [u, -v, 1], [-u, -v, -1]][face];
}

/**
 * Adds a bilinear sample at a position in texels. It wraps around horizontally.
 * @param {FlatTexels} flat
 * @param {number} x
 * @param {number} y
 * @param {FlatTexels} made
 * @param {number} at
 */
function writePanoramaSample(flat, x, y, made, at) {
    const left = Math.floor(x - 0.5);
    const top = Math.floor(y - 0.5);
    const right = x - 0.5 - left;
    const low = y - 0.5 - top;
    /** @type {(column: number, row: number, channel: number) => number} */
    const texel = (column, row, channel) => {
        const wrapped = ((column % flat.width) + flat.width) % flat.width;
        const held = Math.min(Math.max(row, 0), flat.height - 1);
        return flat.texels[4 * (held * flat.width + wrapped) + channel];
    };
    const isFloat = made.texels instanceof Float32Array;
    for (let channel = 0; channel < 4; channel++) {
        const high = texel(left, top, channel) * (1 - right)
            + texel(left + 1, top, channel) * right;
        const below = texel(left, top + 1, channel) * (1 - right)
            + texel(left + 1, top + 1, channel) * right;
        const sample = high * (1 - low) + below * low;
        made.texels[at + channel] = isFloat ? sample : Math.round(sample);
    }
}

/**
 * A panorama of 2:1: longitude from left to right, latitude from top to bottom.
 * @param {FlatTexels} flat
 * @returns {FlatTexels}
 */
function cubeOfPanorama(flat) {
    const side = flat.height / 2;
    const made = emptyColumn(flat, side, cubeFaceCount);
    let at = 0;
    for (let face = 0; face < cubeFaceCount; face++)
        for (let y = 0; y < side; y++)
            for (let x = 0; x < side; x++, at += 4) {
                const [dx, dy, dz] = cubeDirection(face, (2 * (x + 0.5)) / side - 1,
                    (2 * (y + 0.5)) / side - 1);
                const longitude = Math.atan2(dx, dz);
                const latitude = Math.atan2(dy, Math.hypot(dx, dz));
                writePanoramaSample(flat, (0.5 + longitude / (2 * Math.PI)) * flat.width,
                    (0.5 - latitude / Math.PI) * flat.height, made, at);
            }
    return made;
}

/**
 * The layers of a cube map in a column.
 * @param {FlatTexels} flat
 * @returns {FlatTexels|null} null: it has no known layout
 */
function cubeColumn(flat) {
    const { width, height } = flat;
    if (cubeFaceCount * width === height)
        return flat;
    if (width === 1 && height === 1)
        return columnOfSquares(flat, 1, new Array(cubeFaceCount).fill([0, 0, false]));
    if (width === cubeFaceCount * height)
        return columnOfSquares(flat, height, wideCross.map((_, face) => [face, 0, false]));
    if (3 * width === 4 * height && width % 4 === 0)
        return columnOfSquares(flat, width / 4, wideCross);
    if (4 * width === 3 * height && width % 3 === 0)
        return columnOfSquares(flat, width / 3, highCross);
    return width === 2 * height && height >= 2 ? cubeOfPanorama(flat) : null;
}

/**
 * The slices of a volume in a column.
 * @param {FlatTexels} flat
 * @returns {FlatTexels|null} null: it has no known layout
 */
function volumeColumn(flat) {
    const { width, height } = flat;
    if (width * width === height)
        return flat;
    return height * height === width
        ? columnOfSquares(flat, height, Array.from({ length: height }, (_, i) => [i, 0, false]))
        : null;
}

/**
 * The layers of a cube map or volume in a column. Throws if the picture has none.
 * @param {FlatTexels} flat
 * @param {'cube'|'volume'} shape
 * @returns {FlatTexels}
 */
export function columnOfLayers(flat, shape) {
    const made = shape === 'cube' ? cubeColumn(flat) : volumeColumn(flat);
    if (made)
        return made;
    const layouts = shape === 'cube' ? 'six squares in a row or column, a cross of 4 x 3 or 3 x 4 '
        + 'squares, or a 2:1 panorama' : 'a row or column of N square slices, each N px wide';
    throw new Error(`A picture of ${flat.width} x ${flat.height} px can't be a ${shape}. `
        + `Use ${layouts}.`);
}

/**
 * Faces of equal size in a column. Throws if they differ.
 * @param {FlatTexels[]} faces
 * @returns {FlatTexels}
 */
export function columnOfFaces(faces) {
    const side = faces[0].width;
    const made = emptyColumn({ ...faces[0], texels: faces.some((face) =>
        face.texels instanceof Float32Array) ? new Float32Array() : faces[0].texels }, side,
    faces.length);
    const isFloat = made.texels instanceof Float32Array;
    faces.forEach((face, layer) => {
        if (face.width !== side || face.height !== side)
            throw new Error(`A face of a cube map is ${face.width} x ${face.height} px. Use `
                + 'squares of the same size.');
        const scale = isFloat && face.texels instanceof Uint8Array ? 1 / 255 : 1;
        for (let i = 0; i < face.texels.length; i++)
            made.texels[layer * face.texels.length + i] = face.texels[i] * scale;
    });
    return made;
}
