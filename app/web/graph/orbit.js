// Matrices of an orbit, docs/look-format.md.

/** @param {number} degrees */
function orbitRadians(degrees) {
    return (degrees * Math.PI) / 180;
}

/**
 * A rotation of the object about x, then y, then z. Column-major.
 * @param {number[]} degrees
 * @returns {number[]}
 */
export function viewMatrix(degrees) {
    const [a, b, c] = degrees.map((one) => Math.cos(orbitRadians(one)));
    const [sa, sb, sc] = degrees.map((one) => Math.sin(orbitRadians(one)));
    return [
        c * b, sc * b, -sb, 0,
        c * sb * sa - sc * a, sc * sb * sa + c * a, b * sa, 0,
        c * sb * a + sc * sa, sc * sb * a - c * sa, b * a, 0,
        0, 0, 0, 1,
    ];
}

/**
 * The camera's rotation multiplied by its distance: azimuth about y after elevation about x.
 * @param {number} azimuth degrees
 * @param {number} elevation degrees
 * @param {number} distance factor
 * @returns {number[]}
 */
export function cameraMatrix(azimuth, elevation, distance) {
    const matrix = viewMatrix([-elevation, azimuth, 0]);
    return matrix.map((number, i) => (i < 12 ? number * distance : number));
}
