// Where a source picture is placed, and the settings of its text.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { placedAspect, placedRaster, placingOf } from '../../app/web/sources/placing.js';
import { foundPrescale, withoutPrescale } from '../../app/web/sources/prescaled.js';
import { parseSource } from '../../app/web/sources/source_settings.js';

const hd = { width: 1280, height: 720 };
const game = { width: 320, height: 240 };

function place(text, picture, viewport) {
    const { width, height, left, top, repeatX, repeatY, shrink } =
        placingOf(picture, parseSource(`a.png,${text}`), viewport);
    return [width, height, left, top, repeatX, repeatY, shrink];
}

test('each fit places a picture of 320 x 240 px in 1280 x 720 px', () => {
    // 240 * 16 / 9 = 426.7 and 320 * 9 / 16 = 180.
    assert.deepEqual(place('fit=stretch', game, hd), [320, 240, 0, 0, 1, 1, 1]);
    assert.deepEqual(place('fit=whole', game, hd), [427, 240, 53, 0, 1, 1, 1]);
    assert.deepEqual(place('fit=crop', game, hd), [320, 180, 0, -30, 1, 1, 1]);
    assert.deepEqual(place('fit=integer', game, hd), [1280, 720, 160, 0, 3, 3, 1]);
});

test('the shape of the picture sets the pixel aspect', () => {
    // 3 rows fit, and 3 * 1.2 columns are rounded. As 4:3, a pixel is 7/6 wide.
    const picture = { width: 256, height: 224 };
    assert.deepEqual(place('fit=integer,aspect=1.2', picture, hd), [1280, 720, 128, 24, 4, 3, 1]);
    assert.deepEqual(place('fit=whole,shape=4:3', picture, hd), [341, 224, 42, 0, 1, 1, 1]);
    const whole = parseSource('a.png,fit=whole,shape=4:3');
    assert.ok(Math.abs(placedAspect(picture, whole) - 7 / 6) < 1e-15);
    assert.equal(placedAspect(picture, { ...whole, fit: 'integer' }), 1);
});

test('a picture that is too large for the viewport is cropped by fit=integer', () => {
    const viewport = { width: 101, height: 90 };
    assert.deepEqual(place('fit=integer', game, viewport), [101, 90, -110, -75, 1, 1, 1]);
});

test('a strip whose border would need too much memory is averaged', () => {
    // 16384 x 16384 px are 8 times 2^25, so 3 x 3 pixels become one: 5461 x 1 in a square.
    const square = { width: 500, height: 500 };
    assert.deepEqual(place('fit=whole', { width: 16384, height: 1 }, square),
        [5461, 5461, 0, 2730, 1, 1, 3]);
});

test('rows and columns have their start and distance in the placed picture', () => {
    const { rows, columns } = placedRaster(game, parseSource('a.png,fit=integer'), hd);
    assert.deepEqual(rows, [0, 1 / 240, 240]);
    assert.deepEqual(columns, [1 / 8, 3 / 1280, 320]);
    const cropped = placedRaster(game, parseSource('a.png,fit=crop'), hd);
    assert.deepEqual(cropped.rows, [-30 / 180, 1 / 180, 240]);
});

test('settings are read from the end of a source', () => {
    const usual = { fit: 'stretch', aspect: 1, shape: null, prescaled: 1, rate: 0, loops: true };
    assert.deepEqual(parseSource('a,b=c.png,fit=crop,rate=12.5,loop=off'),
        { ...usual, content: 'a,b=c.png', fit: 'crop', rate: 12.5, loops: false });
    assert.deepEqual(parseSource('pattern:harbour,fit=whole,size=320x240i,prescaled=auto'),
        { ...usual, content: 'pattern:harbour,size=320x240i', fit: 'whole', prescaled: 0 });
    assert.equal(parseSource('pattern:a,b,fit=crop,c=1').content, 'pattern:a,b,c=1');
    assert.deepEqual(parseSource('a.png,shape=4:3,fit=whole,fit=crop'),
        { ...usual, content: 'a.png', fit: 'whole', shape: [4, 3] });
});

test('wrong settings are refused with a message', () => {
    for (const [text, message] of [
        ['a.png,fit=x', /unknown fit 'x'; use one of: stretch, whole, crop, integer/],
        ['a.png,aspect=17', /'aspect=17': expected a number from 0.0625 to 16/],
        ['a.png,aspect=1 ', /expected a number/],
        ['a.png,rate=-1', /from 0 to 1000/],
        ['a.png,shape=40:1', /expected 'square' or a ratio/],
        ['a.png,shape=4:3,aspect=2', /not both/],
        ['a.png,prescaled=9', /from 1 to 8/],
        ['a.png,loop=yes', /expected 'on' or 'off'/],
        [',fit=crop', /must be a file/],
    ]) {
        assert.throws(() => parseSource(text), message, text);
    }
});

test('nearest-neighbour scaling by an integer is found and removed', () => {
    const value = (x, y, i) => (x * 7 + y * 3 + i * 5 + (x * y) % 4) % 11;
    const pixels = (width, height, times) => Float32Array.from({ length: width * height * 3 },
        (_, i) => value(Math.floor(Math.floor(i / 3) % width / times),
            Math.floor(Math.floor(i / 3) / width / times), i % 3));
    const original = { width: 12, height: 10, channels: 3, pixels: pixels(12, 10, 1) };
    for (const times of [2, 3, 6, 8]) {
        const width = 12 * times;
        const height = 10 * times;
        const large = { width, height, channels: 3, pixels: pixels(width, height, times) };
        assert.equal(foundPrescale(large), times);
        assert.deepEqual(withoutPrescale(large, times), original);
        large.pixels[3 * (width + 1)] += 1;  // one pixel differs
        assert.equal(foundPrescale(large), 1);
    }
    assert.equal(foundPrescale(original), 1);
});

test('the middle pixel of each block is taken, and a rest is dropped', () => {
    const pixels = Float32Array.from({ length: 35 }, (_, i) => i);
    const made = withoutPrescale({ width: 7, height: 5, channels: 1, pixels }, 2);
    assert.deepEqual(made, { width: 3, height: 2, channels: 1,
        pixels: Float32Array.of(8, 10, 12, 22, 24, 26) });
});
