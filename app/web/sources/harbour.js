// The test picture 'harbour': a harbour at dusk in 320 x 240 pixels and sixteen colours.

import { IndexCanvas, canvasLayer } from './index_canvas.js';
import { harbourPaint, harbourPalette, harbourBoat, harbourCat } from './harbour_art.js';
import { drawHarbourSky, drawHarbourDistance, drawHarbourLighthouse } from './harbour_scenery.js';
import { drawHarbourWalls, drawHarbourShore, drawHarbourThings } from './harbour_scenery.js';
import { harbourWidth, harbourHeight, harbourHorizon, harbourQuay } from './harbour_scenery.js';
import { PaletteScaler } from './palette_scaler.js';
import { patternHash, patternHashShare } from './pattern_hash.js';

/** @typedef {import('./source.js').SourcePicture} SourcePicture */

/**
 * A star in front of which nothing stands.
 * @typedef {object} HarbourStar
 * @property {number} x
 * @property {number} y
 * @property {number} color
 * @property {number} phase Of its twinkling, 0 to 10.
 */

const harbourTau = 2 * Math.PI;

/**
 * @param {IndexCanvas} distance What hides the stars, on a canvas that is otherwise 255.
 * @returns {HarbourStar[]}
 */
function visibleStars(distance) {
    const { cream, foam } = harbourPaint;
    const stars = Array.from({ length: 70 }, (_, i) => ({
        x: Math.trunc(320 * patternHashShare(i, 1)),
        y: Math.trunc(72 * patternHashShare(i, 2) * patternHashShare(i, 3)),
        color: i % 3 === 0 ? cream : foam,
        phase: patternHash(i, 4) % 11,
    }));
    return stars.filter(({ x, y }) => distance.at(x, y) === 255);
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} y
 * @param {number} tick
 */
function drawWaves(canvas, y, tick) {
    const { plum, sea, cream, peach, orange } = harbourPaint;
    const down = (y - harbourHorizon) / (harbourQuay - harbourHorizon);
    // Short waves: longer and more widely spaced in the foreground.
    const length = 3 + Math.trunc(9 * down);
    const slow = Math.trunc(tick / 3);
    for (let i = 0; i < 11; ++i) {
        const key = y * 16 + i;
        if (patternHashShare(key, slow) <= 0.34) {
            const x = Math.trunc(340 * patternHashShare(key, 5)) - 10 + slow % 2;
            canvas.rectangle(x, y, length, 1, i % 4 === 0 ? plum : sea);
        }
    }
    // The reflection of the sun on the water.
    const spread = 24 + 26 * down;
    const now = Math.trunc(tick / 2);
    for (let i = 0; i < 9; ++i) {
        const key = y * 32 + i;
        if (patternHashShare(key, now, 2) >= 0.25 + 0.4 * down) {
            const off = patternHashShare(key, now) + patternHashShare(key, now, 1) - 1;
            const away = Math.abs(off);
            canvas.rectangle(118 + Math.trunc(spread * off), y, length, 1,
                away < 0.25 ? cream : away < 0.5 ? peach : orange);
        }
    }
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} tick
 */
function drawGulls(canvas, tick) {
    const { night } = harbourPaint;
    [[66, 62], [79, 55], [93, 64], [214, 74]].forEach(([x, y], i) => {
        const isUp = (Math.trunc(tick / 2) + i) % 4 !== 0;
        canvas.set(x, y, night);
        for (const side of [-1, 1]) {
            canvas.set(x + side, y - 1, night);
            canvas.set(x + 2 * side, isUp ? y - 2 : y - 1, night);
            canvas.set(x + 3 * side, isUp ? y - 2 : y, night);
        }
    });
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} tick
 */
function drawLightBeam(canvas, tick) {
    const turn = Math.sin(tick * harbourTau / 48);
    for (let column = 4; column < 150; ++column) {
        const half = 1 + Math.trunc(column / 9);
        const x = 282 - column;
        const middle = 69 - Math.trunc(column * 0.22 * turn);
        for (let row = -half; row <= half; ++row) {
            const y = middle + row;
            const share = 0.5 * (1 - column / 150) * (1 - Math.abs(row) / (half + 1));
            if (y >= 0 && y < harbourHorizon) {
                canvas.dithered(x, y, canvas.at(x, y), harbourPaint.peach, share);
            }
        }
    }
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} tick
 */
function drawBoat(canvas, tick) {
    const { wood, violet } = harbourPaint;
    const bob = Math.round(Math.sin(tick * harbourTau / 18));
    canvas.sprite(176, 137 + bob, harbourBoat);
    for (let row = 0; row < 14; ++row) {  // reflection in the water
        const left = 179 + Math.trunc(row / 2) + (row + Math.trunc(tick / 2)) % 2;
        for (let column = 0; column < 18 - row; ++column) {
            if ((row * 7 + column * 3 + tick) % 5 !== 0 && row % 3 !== 1) {
                canvas.set(left + column, 162 + bob + row, row < 4 ? wood : violet);
            }
        }
    }
}

/**
 * @param {IndexCanvas} canvas
 * @param {number} tick
 */
function drawSmoke(canvas, tick) {
    const { stone, plum } = harbourPaint;
    for (let i = 0; i < 5; ++i) {
        const age = (i * 4 + tick * 0.5) % 20;
        canvas.disc(23 + age * 0.9 + 2 * Math.sin(age * 0.7 + i), 90 - age * 1.6, 1 + age / 6,
            age < 10 ? stone : plum);
    }
}

/** @param {IndexCanvas} canvas */
function drawLanternLight(canvas) {
    for (let row = -26; row <= 26; ++row) {
        for (let column = -26; column <= 26; ++column) {
            const away = Math.sqrt(row * row + column * column) / 26;
            if (away < 1) {
                const x = 96 + column;
                const y = 146 + row;
                canvas.dithered(x, y, canvas.at(x, y), harbourPaint.orange,
                    0.55 * (1 - away) * (1 - away));
            }
        }
    }
}

/**
 * The tail hangs over the edge, and its tip sways.
 * @param {IndexCanvas} canvas
 * @param {number} tick
 */
function drawCat(canvas, tick) {
    const { night, wood, orange } = harbourPaint;
    const sway = Math.sin(tick * harbourTau / 15);
    for (const isOutline of [true, false]) {
        for (let i = 0; i < 19; ++i) {
            const along = 162 + Math.trunc(i / 2) + Math.round(sway * i * i / 90);
            const down = harbourQuay + 2 + Math.round(i - 0.028 * i * i);
            if (isOutline) {
                canvas.rectangle(along - 1, down - 1, 5, 3, night);
            } else {
                canvas.rectangle(along, down, 3, 1, i % 6 < 2 ? wood : orange);
            }
        }
    }
    canvas.sprite(150, harbourQuay - 18, harbourCat);
}

/** Draws the harbour. What does not move is drawn once. */
export class HarbourPainter {
    /**
     * @param {number} width px
     * @param {number} height px
     */
    constructor(width = harbourWidth, height = harbourHeight) {
        this.width = width;
        this.height = height;
        const native = { width: harbourWidth, height: harbourHeight };
        this.scaler = new PaletteScaler(harbourPalette, native, { width, height });
        this.canvas = new IndexCanvas(harbourWidth, harbourHeight);
        this.backdrop = new IndexCanvas(harbourWidth, harbourHeight);
        this.backdrop.pixels.fill(255);
        drawHarbourDistance(this.backdrop);
        this.stars = visibleStars(this.backdrop);
        drawHarbourSky(this.backdrop);
        drawHarbourDistance(this.backdrop);
        /** @param {(canvas: IndexCanvas) => void} draw */
        const layer = (draw) => canvasLayer(harbourWidth, harbourHeight, draw);
        this.lighthouse = layer(drawHarbourLighthouse);
        this.walls = layer(drawHarbourWalls);
        this.shore = layer(drawHarbourShore);
        this.things = layer(drawHarbourThings);
    }

    /**
     * Pictures with the same number are equal. Six numbers per second.
     * @param {number} seconds
     * @returns {number}
     */
    numberAt(seconds) {
        return Math.floor(seconds * 6 + 1e-6);
    }

    /**
     * RGB bytes at whole multiples of 320 x 240, floats at other sizes. The next call reuses them.
     * @param {number} seconds
     * @returns {SourcePicture}
     */
    pictureAt(seconds) {
        this.draw(this.numberAt(seconds));
        return {
            width: this.width,
            height: this.height,
            channels: 3,
            encoding: 'display',
            pixels: this.scaler.colorsOf(this.canvas),
            isTopFirst: true,
        };
    }

    /** @param {number} tick */
    draw(tick) {
        const { canvas } = this;
        canvas.pixels.set(this.backdrop.pixels);
        for (const { x, y, color, phase } of this.stars) {
            const twinkles = (Math.trunc(tick / 2) + phase) % 11 === 0;
            canvas.set(x, y, twinkles ? harbourPaint.plum : color);
        }
        for (let y = harbourHorizon; y < harbourQuay; ++y) {
            drawWaves(canvas, y, tick);
        }
        drawGulls(canvas, tick);
        drawLightBeam(canvas, tick);
        canvas.stamp(this.lighthouse);
        drawBoat(canvas, tick);
        canvas.stamp(this.walls);
        drawSmoke(canvas, tick);
        canvas.stamp(this.shore);
        drawLanternLight(canvas);
        canvas.stamp(this.things);
        drawCat(canvas, tick);
    }
}
