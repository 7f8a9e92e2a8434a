// Sources of pictures that need no browser: raw pictures, sequences and patterns.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { numberOfHalf } from '../../app/web/sources/decoding.js';
import { openSource } from '../../app/web/sources/open_source.js';

function rawPicture(width, height, channels, halfs) {
    const bytes = Buffer.alloc(2 * halfs.length);
    halfs.forEach((half, i) => bytes.writeUInt16LE(half, 2 * i));
    return { width, height, channels, encoding: 'linear',
        halfs: gzipSync(bytes).toString('base64') };
}

const half = { 0: 0x0000, 1: 0x3c00, 2: 0x4000, 3: 0x4200, 4: 0x4400 };
const grey = (value) => rawPicture(1, 1, 1, [half[value]]);

test('half floats have the values of IEEE 754', () => {
    for (const [bits, value] of [
        [0x3c00, 1], [0xc000, -2], [0x3555, 0.333251953125], [0x7bff, 65504], [0x0400, 2 ** -14],
        [0x0001, 2 ** -24], [0x03ff, 1023 * 2 ** -24], [0x8001, -(2 ** -24)],
        [0x7c00, 65504], [0xfc00, -65504], [0x7e00, 0],
    ]) {
        assert.equal(numberOfHalf(bits), value, bits.toString(16));
    }
});

test('a raw picture is shown once, and again for a new context', async () => {
    const media = new Map([['media/a.exr', rawPicture(1, 2, 3, [1, 2, 3, 4, 0, 1].map(
        (value) => half[value]))]]);
    const source = await openSource('media/a.exr,fit=whole', media);
    const picture = source.pictureAt(0);
    assert.deepEqual(picture, { width: 1, height: 2, channels: 3, encoding: 'linear',
        pixels: Float32Array.of(1, 2, 3, 4, 0, 1), isTopFirst: true });
    assert.equal(source.pictureAt(1), null);
    source.refresh();
    assert.equal(source.pictureAt(1), picture);
    assert.equal(source.name, 'a.exr');
    assert.equal(source.settings.fit, 'whole');
    assert.deepEqual(source.naturalSize(), { width: 1, height: 2 });
});

test('a prescaled picture gives its original pixels', async () => {
    const halfs = Array.from({ length: 36 },
        (_, i) => half[(Math.floor(i % 6 / 2) + Math.floor(i / 12)) % 5]);
    const source = await openSource('a.exr,prescaled=2', new Map([
        ['a.exr', rawPicture(6, 6, 1, halfs)]]));
    assert.deepEqual(source.naturalSize(), { width: 3, height: 3 });
    assert.deepEqual([...source.pictureAt(0).pixels], [0, 1, 2, 1, 2, 3, 2, 3, 4]);
});

// The value of the picture that is shown at a time. Null: unchanged.
async function shownAt(source, seconds) {
    await source.prepare(seconds);
    const picture = source.pictureAt(seconds);
    return picture && picture.pixels[0];
}

const numbered = new Map([['m/f_010.exr', grey(2)], ['m/f_008.exr', grey(0)],
    ['m/f_009.exr', grey(1)], ['m/f_0011.exr', grey(4)], ['m/f_7.exr', grey(4)]]);

test('frame N shows picture N of a sequence, which loops', async () => {
    const source = await openSource('m/f_%03d.exr', numbered);
    const shown = [];
    for (const frame of [1, 2, 2, 3, 4, 6, 601]) {
        shown.push(await shownAt(source, frame / 60));
    }
    assert.deepEqual(shown, [0, 1, null, 2, 0, 2, 0]);
});

test('a sequence with loop=off holds its last picture, at its own rate', async () => {
    const source = await openSource('m/f_%03d.exr,loop=off,rate=30', numbered);
    const shown = [];
    for (let frame = 1; frame <= 8; ++frame) {
        shown.push(await shownAt(source, frame / 60));
    }
    assert.deepEqual(shown, [0, null, 1, null, 2, null, null, null]);
});

test('a missing or different picture of a sequence keeps the previous one', async () => {
    const wide = rawPicture(2, 1, 1, [half[0], half[0]]);
    for (const [second, problem] of [
        [['f2', wide], /'f2' is 2 x 1 px. Use pictures of 1 x 1 px/],
        [['f.', wide], /Pictures of 'f%d' are missing. Export/],
    ]) {
        const source = await openSource('f%d', new Map([['f1', grey(1)], second, ['f3', grey(3)]]));
        assert.equal(await shownAt(source, 1 / 60), 1);
        assert.equal(await shownAt(source, 2 / 60), null);
        assert.match(source.problem, problem);
        assert.equal(await shownAt(source, 3 / 60), 3);
    }
});

test('without prepare, a sequence shows a picture when it is decoded', async () => {
    const source = await openSource('m/f_%03d.exr', numbered);
    assert.equal(source.pictureAt(1 / 60).pixels[0], 0);
    assert.equal(source.pictureAt(2 / 60), null);
    await source.prepare(2 / 60);
    assert.equal(source.pictureAt(2 / 60).pixels[0], 1);
});

test('the picture that is shown is not freed before the next one is shown', async (context) => {
    context.after(() => delete globalThis.createImageBitmap);
    globalThis.createImageBitmap = async () => ({ width: 1, height: 1, isClosed: false,
        close() { this.isClosed = true; } });
    const files = Array.from({ length: 9 }, (_, i) => [`f${i + 1}`, new Blob(['picture'])]);
    const source = await openSource('f%d', new Map(files));
    const first = source.pictureAt(1 / 60);
    await source.prepare(5 / 60);
    assert.equal(first.pixels.isClosed, false);
    const fifth = source.pictureAt(5 / 60);
    assert.equal(source.pictureAt(5 / 60), null);
    assert.equal(first.pixels.isClosed, true);
    source.dispose();
    assert.equal(fifth.pixels.isClosed, true);
});

test('the harbour has a new picture six times per second', async () => {
    const source = await openSource('pattern:harbour,fit=integer', new Map());
    const changes = [];
    for (let frame = 1; frame <= 30; ++frame) {
        if (source.pictureAt(frame / 60)) {
            changes.push(frame);
        }
    }
    assert.deepEqual(changes, [1, 10, 20, 30]);
    assert.equal(source.name, 'Harbour');
    assert.deepEqual(source.naturalSize(), { width: 320, height: 240 });
});

test('missing and damaged content is refused with a message', async () => {
    const media = new Map([['a.exr', { ...grey(1), width: 2 }],
        ['b.exr', { ...grey(1), halfs: 'AAAA' }], ['c.txt', new Blob(['no picture'])]]);
    await assert.rejects(openSource('no.png', media), /page does not contain it. Export/);
    await assert.rejects(openSource('no_%d.png', media), /no numbered pictures match/);
    await assert.rejects(openSource('a.exr', media), /'a.exr': its data is damaged/);
    await assert.rejects(openSource('b.exr', media), /'b.exr': its data is damaged/);
    await assert.rejects(openSource('c.txt', media), /does not know its format. Use a PNG/);
});
