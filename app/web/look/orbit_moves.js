// How gestures change an orbit: the rotation of an object, and the place of the camera.

import { viewMatrix } from '../graph/orbit.js';

/**
 * @typedef {{turn: number[], azimuth: number, elevation: number, distance: number}} OrbitPose
 *     degrees, and a factor of the distance (docs/look-format.md)
 */

const nearestOrbit = 0.1;
const farthestOrbit = 10;
const steepestElevation = 90;  // degrees

/** @param {number} degrees */
function roundedDegrees(degrees) {
    return Math.round(degrees * 100) / 100 + 0;
}

/**
 * The product of two matrices of 4 x 4 numbers. Column-major.
 * @param {number[]} a
 * @param {number[]} b
 */
function matrixProduct(a, b) {
    return b.map((_, i) => {
        let sum = 0;
        for (let k = 0; k < 4; k++)
            sum += a[i % 4 + 4 * k] * b[4 * Math.floor(i / 4) + k];
        return sum;
    });
}

/**
 * The inverse of a rotation.
 * @param {number[]} matrix
 */
function transposed(matrix) {
    return matrix.map((_, i) => matrix[4 * (i % 4) + Math.floor(i / 4)]);
}

/**
 * The angles of a rotation about x, then y, then z, in degrees.
 * @param {number[]} m column-major
 */
function anglesOfRotation(m) {
    const isStraight = Math.hypot(m[6], m[10]) < 1e-9;  // x and z have the same axis
    const y = Math.asin(Math.min(Math.max(-m[2], -1), 1));
    const [x, z] = isStraight ? [0, Math.atan2(-m[4], m[5])]
        : [Math.atan2(m[6], m[10]), Math.atan2(m[1], m[0])];
    return [x, y, z].map((angle) => (angle * 180) / Math.PI);
}

/**
 * The object after a drag, as seen by the camera.
 * @param {OrbitPose} pose
 * @param {number} right degrees
 * @param {number} up degrees
 * @returns {OrbitPose}
 */
export function withObjectTurned(pose, right, up) {
    const camera = viewMatrix([-pose.elevation, pose.azimuth, 0]);
    const drag = matrixProduct(viewMatrix([0, right, 0]), viewMatrix([-up, 0, 0]));
    const seen = matrixProduct(matrixProduct(camera, drag), transposed(camera));
    const turn = anglesOfRotation(matrixProduct(seen, viewMatrix(pose.turn)));
    return { ...pose, turn: turn.map(roundedDegrees) };
}

/**
 * The camera after a drag.
 * @param {OrbitPose} pose
 * @param {number} right degrees
 * @param {number} up degrees
 * @returns {OrbitPose}
 */
export function withCameraMoved(pose, right, up) {
    const azimuth = pose.azimuth - right;
    const elevation = Math.min(Math.max(pose.elevation - up, -steepestElevation),
        steepestElevation);
    return { ...pose, azimuth: roundedDegrees(azimuth - 360 * Math.round(azimuth / 360)),
        elevation: roundedDegrees(elevation) };
}

/**
 * The camera after a pinch or scroll.
 * @param {OrbitPose} pose
 * @param {number} factor of the distance
 * @returns {OrbitPose}
 */
export function withDistanceScaled(pose, factor) {
    const distance = Math.min(Math.max(pose.distance * factor, nearestOrbit), farthestOrbit);
    return { ...pose, distance: Math.round(distance * 1000) / 1000 };
}
