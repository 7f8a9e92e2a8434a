// The size of the picture, the pointer on it, and when it becomes smaller.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { wantedFrames } from '../../app/web/player/frames_mode.js';
import { FramePace } from '../../app/web/player/pace.js';
import { placeOnPicture } from '../../app/web/player/pointer.js';
import { fittedSize, wantedSize } from '../../app/web/player/stage_size.js';

test('a picture fills the stage in its shape, at the pixels of the screen', () => {
    const stage = { width: 400, height: 300 };
    assert.deepEqual(fittedSize(stage, 2, 16 / 9, 1), { width: 800, height: 450 });
    assert.deepEqual(fittedSize(stage, 2, 1, 4), { width: 150, height: 150 });
    assert.deepEqual(fittedSize(stage, 1.5, 0, 1), { width: 600, height: 450 });
    const { width, height } = fittedSize({ width: 8000, height: 4500 }, 1, 16 / 9, 1);
    assert.deepEqual([width, height], [2560, 1440]);  // the most that is drawn
});

test('the pointer is on the picture, not on the bars beside it', () => {
    const canvas = { width: 160, height: 90,
        getBoundingClientRect: () =>
            ({ left: 10, top: 20, bottom: 520, width: 320, height: 500 }) };
    // The picture is 320 x 180, from 180 below the element's top.
    const place = (x, y) => placeOnPicture(canvas, { clientX: x, clientY: y });
    assert.deepEqual(place(10, 360), [0, 0]);
    assert.deepEqual(place(330, 180), [1, 1]);
    assert.deepEqual(place(170, 225), [0.5, 0.75]);
});

test('frames that are slow for 1.5 s halve the sides, at most twice', () => {
    const pace = new FramePace();
    const secondsUntilSmaller = (frame) => {
        for (let time = frame; time < 20; time += frame)
            if (pace.note(frame, true)) return time;
        return Infinity;
    };
    assert.equal(secondsUntilSmaller(1 / 30), Infinity);
    assert.ok(Math.abs(pace.framesPerSecond - 30) < 1e-6);
    for (let i = 0; i < 100; i++) assert.ok(!pace.note(2, true));  // hidden, then shown
    assert.equal(secondsUntilSmaller(0.125), 1.5);
    assert.equal(secondsUntilSmaller(0.125), 1.5);
    assert.equal(secondsUntilSmaller(0.125), Infinity);
    assert.equal(pace.halvings, 2);
    pace.reset();
    for (let i = 0; i < 100; i++) assert.ok(!pace.note(0.5, false));  // of a fixed size
    assert.equal(pace.halvings, 0);
});

test('numbers of frames rise, and sizes have two sides', () => {
    assert.deepEqual(['', '?frames=60', '?frames=1,16,60'].map(wantedFrames),
        [[], [60], [1, 16, 60]]);
    for (const text of ['', '0', '-1', '1.5', '16,1', '4,4', '1,', '100001', 'x'])
        assert.throws(() => wantedFrames(`?frames=${text}`), /Use frames=60/, text);
    assert.deepEqual([wantedSize('?bare'), wantedSize('?size=640x360')],
        [null, { width: 640, height: 360 }]);
    for (const text of ['', '640', '0x1', '9000x9', '1x2x3'])
        assert.throws(() => wantedSize(`?size=${text}`), /Use size=640x360/, text);
});
