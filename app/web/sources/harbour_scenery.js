// The parts of the test picture 'harbour' that do not move.

import { harbourPaint, harbourBarrel, harbourFlowers } from './harbour_art.js';
import { patternHash, patternHashShare } from './pattern_hash.js';

/** @typedef {import('./index_canvas.js').IndexCanvas} IndexCanvas */

export const harbourWidth = 320;
export const harbourHeight = 240;
export const harbourHorizon = 146;
/** The edge between water and stones. */
export const harbourQuay = 204;

const lighthouseX = 282;
const lighthouseTop = 64;
const houseX = 6;
const houseTop = 132;

/** @param {IndexCanvas} canvas */
export function drawHarbourSky(canvas) {
    const { indigo, violet, plum, rose, orange, peach } = harbourPaint;
    const steps = [indigo, violet, plum, rose, orange, peach];
    for (let y = 0; y < harbourHorizon; ++y) {
        const down = Math.pow(y / harbourHorizon, 1.15) * 5;
        const step = Math.min(4, Math.trunc(down));
        for (let x = 0; x < canvas.width; ++x) {
            canvas.dithered(x, y, steps[step], steps[step + 1], down - step);
        }
    }
}

/** @param {IndexCanvas} canvas */
function drawMoonAndSun(canvas) {
    const { cream, peach } = harbourPaint;
    for (let y = -11; y <= 11; ++y) {
        for (let x = -11; x <= 11; ++x) {
            const isInCrescent = Math.sqrt(x * x + y * y) < 11.4 &&
                Math.sqrt((x + 5) * (x + 5) + (y + 3) * (y + 3)) > 10.2;
            if (isInCrescent) {
                canvas.set(262 + x, 30 + y, cream);
            }
        }
    }
    const radius = 33;
    for (let row = -radius; row <= radius; ++row) {
        const half = Math.trunc(Math.sqrt(radius * radius - row * row));
        // Bars of haze, wider towards the horizon.
        const isHaze = row > -4 && (row + 4) % 7 < 1 + Math.trunc((row + 4) / 9);
        const share = Math.min(Math.max((row + 22) / 40, 0), 1);
        for (let column = -half; !isHaze && column <= half; ++column) {
            canvas.dithered(118 + column, 128 + row, cream, peach, share);
        }
    }
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} x
 * @param {number} y
 * @param {number} length
 * @param {number} color
 */
function drawCloud(canvas, x, y, length, color) {
    for (let row = 0; row < 4; ++row) {
        const inset = Math.abs(row - 2) * Math.trunc(length / 7) + row;
        for (let column = inset; column < length - inset; ++column) {
            if (row > 0 || column % 5 !== 0) {
                canvas.set(x + column, y + row, color);
            }
        }
    }
}

/**
 * The height of a hill: five octaves of value noise.
 * @param {number} x
 * @param {number} key
 * @returns {number}
 */
function ridgeHeight(x, key) {
    let height = 0;
    let scale = 1;
    for (let step = 64; step >= 4; step /= 2) {
        const position = x / step;
        const left = Math.trunc(position);
        const low = patternHashShare(left, key, step);
        const high = patternHashShare(left + 1, key, step);
        height += scale * (low + (high - low) * (position - left));
        scale *= 0.5;
    }
    return height;
}

/** @param {IndexCanvas} canvas */
function drawHills(canvas) {
    const { plum, rose, violet } = harbourPaint;
    for (let x = 0; x < canvas.width; ++x) {
        const farSide = Math.abs(x - 118) / 200;  // lower at the sun
        const farTop = harbourHorizon -
            Math.trunc(8 + 20 * farSide * ridgeHeight(x, 7) + 6 * ridgeHeight(x, 7));
        for (let y = farTop; y < harbourHorizon; ++y) {
            const share = 0.55 * (y - farTop) / (harbourHorizon - farTop);
            canvas.dithered(x, y, plum, rose, share);
        }
        const nearSide = Math.max(0, Math.abs(x - 130) / 190 - 0.3);
        const nearTop = harbourHorizon - Math.trunc(34 * nearSide * ridgeHeight(x, 19));
        for (let y = nearTop; y < harbourHorizon; ++y) {
            canvas.set(x, y, violet);
        }
    }
}

/**
 * What hides the stars, and the sea without waves.
 * @param {IndexCanvas} canvas
 */
export function drawHarbourDistance(canvas) {
    const { rose, plum, orange, peach, sea, deepSea } = harbourPaint;
    drawMoonAndSun(canvas);
    drawCloud(canvas, 22, 84, 60, rose);
    drawCloud(canvas, 138, 70, 84, plum);
    drawCloud(canvas, 168, 96, 66, orange);
    drawCloud(canvas, 58, 108, 46, peach);
    drawHills(canvas);
    for (let y = harbourHorizon; y < harbourQuay; ++y) {
        const down = (y - harbourHorizon) / (harbourQuay - harbourHorizon);
        for (let x = 0; x < canvas.width; ++x) {
            canvas.dithered(x, y, sea, deepSea, 0.15 + 0.9 * down);
        }
    }
}

/** @param {IndexCanvas} canvas */
function drawLighthouseTower(canvas) {
    const { red, violet, cream, stone } = harbourPaint;
    for (let row = 12; row < 72; ++row) {  // wider at the bottom
        const half = 7 + Math.trunc(row / 14);
        const isRed = Math.trunc(row / 12) % 2 === 0;
        for (let column = -half; column <= half; ++column) {
            const round = column / half;
            const share = Math.max(0, isRed ? round : 0.2 + round);
            canvas.dithered(lighthouseX + column, lighthouseTop + row, isRed ? red : cream,
                isRed ? violet : stone, share);
        }
    }
}

/** @param {IndexCanvas} canvas */
export function drawHarbourLighthouse(canvas) {
    const { shade, night, peach, cream, red } = harbourPaint;
    const x = lighthouseX;
    const top = lighthouseTop;
    for (let row = 0; row < 46; ++row) {  // the rock
        const half = 8 + Math.trunc(row / 2) + Math.trunc(7 * ridgeHeight(row * 3 + 40, 3));
        for (let column = -half; column <= half; ++column) {
            const share = 0.25 + 0.5 * (column + half) / (2 * half) +
                0.2 * (Math.trunc(row / 5) % 2);
            canvas.dithered(x + column, 132 + row, shade, night, share);
        }
    }
    drawLighthouseTower(canvas);
    canvas.rectangle(x - 2, top + 34, 4, 5, night);
    canvas.rectangle(x - 2, top + 58, 5, 9, night);
    canvas.rectangle(x - 9, top + 11, 19, 2, night);  // the gallery
    for (let column = -9; column <= 9; column += 3) {
        canvas.set(x + column, top + 10, night);
    }
    canvas.rectangle(x - 9, top + 9, 19, 1, night);
    canvas.rectangle(x - 5, top + 1, 11, 8, peach);  // the lamp
    canvas.rectangle(x - 2, top + 2, 5, 6, cream);
    for (const column of [-5, -2, 2, 5]) {
        canvas.rectangle(x + column, top + 1, 1, 8, night);
    }
    for (let row = 0; row < 6; ++row) {
        canvas.rectangle(x - row, top - 5 + row, 2 * row + 1, 1, red);
    }
    canvas.rectangle(x, top - 10, 1, 6, night);
}

/** @param {IndexCanvas} canvas */
export function drawHarbourWalls(canvas) {
    const { plum, violet, night, red, shade } = harbourPaint;
    for (let row = 0; row < 74; ++row) {
        for (let column = 0; column < 66; ++column) {
            canvas.dithered(houseX + column, houseTop + row, plum, violet,
                0.3 + 0.5 * column / 66);
        }
    }
    for (let row = 0; row < 26; ++row) {  // the roof
        for (let column = -6 + Math.trunc(row / 3); column < 72 - row; ++column) {
            const isGap = row % 4 === 0 || (column + row) % 9 === 0;
            canvas.set(houseX + column, houseTop - row, isGap ? night : red);
        }
    }
    canvas.rectangle(houseX + 12, houseTop - 36, 9, 24, shade);
    canvas.rectangle(houseX + 11, houseTop - 38, 11, 3, night);
}

/** @param {IndexCanvas} canvas */
function drawWindowsAndDoor(canvas) {
    const { night, cream, orange, wood, stone, peach } = harbourPaint;
    for (const [left, up] of [[10, 14], [40, 14], [10, 44]]) {
        const x = houseX + left;
        const y = houseTop + up;
        canvas.rectangle(x - 1, y - 1, 18, 18, night);
        for (let row = 0; row < 16; ++row) {
            for (let column = 0; column < 16; ++column) {
                canvas.dithered(x + column, y + row, cream, orange, row / 18);
            }
        }
        canvas.rectangle(x + 7, y, 2, 16, wood);
        canvas.rectangle(x, y + 7, 16, 2, wood);
        canvas.rectangle(x - 2, y + 17, 20, 2, stone);
    }
    canvas.sprite(houseX + 12, houseTop + 30, harbourFlowers);
    canvas.sprite(houseX + 42, houseTop + 30, harbourFlowers);
    canvas.rectangle(houseX + 39, houseTop + 42, 18, 32, wood);  // the door
    canvas.rectangle(houseX + 41, houseTop + 44, 14, 30, night);
    canvas.rectangle(houseX + 42, houseTop + 45, 12, 29, wood);
    canvas.set(houseX + 51, houseTop + 60, peach);
}

/** @param {IndexCanvas} canvas */
function drawQuay(canvas) {
    const { night, shade, stone, rose, orange } = harbourPaint;
    for (let y = harbourQuay; y < canvas.height; ++y) {
        const down = y - harbourQuay;
        const row = Math.trunc(down / 9);
        for (let x = 0; x < canvas.width; ++x) {
            const along = x + (row % 2) * 13 + patternHash(row) % 5;
            if (down % 9 === 8 || along % 26 === 0) {
                canvas.set(x, y, night);  // a joint
                continue;
            }
            const brick = Math.trunc(along / 26) * 64 + row;
            canvas.dithered(x, y, patternHashShare(brick) < 0.5 ? shade : stone, shade,
                0.35 + 0.016 * down);
        }
    }
    canvas.rectangle(0, harbourQuay, canvas.width, 1, rose);  // light on the edge
    for (let x = 0; x < canvas.width; ++x) {
        if (patternHashShare(x, 77) < 0.3) {
            canvas.set(x, harbourQuay + 1, orange);
        }
    }
}

/**
 * What hides the smoke and the water.
 * @param {IndexCanvas} canvas
 */
export function drawHarbourShore(canvas) {
    drawWindowsAndDoor(canvas);
    drawQuay(canvas);
}

/**
 * The lantern without its light, barrels, a bollard and its rope.
 * @param {IndexCanvas} canvas
 */
export function drawHarbourThings(canvas) {
    const { night, peach, cream, shade, stone, wood } = harbourPaint;
    canvas.rectangle(95, 152, 3, 55, night);
    canvas.rectangle(93, 204, 7, 4, night);
    canvas.rectangle(91, 140, 11, 12, night);
    canvas.rectangle(92, 141, 9, 10, peach);
    canvas.rectangle(94, 142, 5, 8, cream);
    canvas.rectangle(93, 138, 7, 2, night);
    canvas.rectangle(96, 136, 1, 2, night);
    const y = harbourQuay;
    canvas.sprite(214, y - 9, harbourBarrel);
    canvas.sprite(231, y - 5, harbourBarrel);
    canvas.rectangle(252, y - 12, 10, 16, night);
    canvas.rectangle(253, y - 11, 8, 14, shade);
    canvas.rectangle(250, y - 14, 14, 4, night);
    canvas.rectangle(251, y - 13, 12, 2, stone);
    for (let i = 0; i < 40; ++i) {
        const sag = Math.round(0.012 * i * (40 - i));
        canvas.set(264 + i, y - 6 + sag, peach);
        canvas.set(264 + i, y - 5 + sag, wood);
    }
}
