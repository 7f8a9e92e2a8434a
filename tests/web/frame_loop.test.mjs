// Which time spans the frames of a page draw.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { FrameLoop } from '../../app/web/player/frame_loop.js';

/** A loop whose drawing notes the spans of its frames. `heard` is the time of the sound. */
function notedLoop({ settleFrames = 4, parameters = [] } = {}) {
    const log = { spans: [], presented: 0, cleared: 0, values: [] };
    const values = new Map(parameters.map((one) => [one.name, [1]]));
    const sound = { heard: null, seconds: () => sound.heard };
    const drawing = {
        settleFrames, isLost: false,
        draw: ({ number, start, end, now }, numbers) => {
            log.spans.push([number, start, end, now]);
            log.values.push(new Map(numbers));
        },
        present: () => log.presented++,
        clearHistory: () => log.cleared++,
        updateConstants: () => false,
    };
    const content = { sound, source: null, setPaused: () => {}, restart: () => {} };
    return { loop: new FrameLoop(drawing, content, values, parameters), log, sound, drawing };
}

test('a playing sound is the clock: its spans adjoin, and none is empty', () => {
    const { loop, log, sound } = notedLoop();
    for (const heard of [0.01, 0.013, 0.013, 0.1, 0.1, 0.19]) {
        sound.heard = heard;
        loop.drawLive(1);
    }
    assert.deepEqual(log.spans.map(([number, start, end]) => [number, start, end]),
        [[1, 0, 0.01], [2, 0.01, 0.013], [3, 0.013, 0.1], [4, 0.1, 0.19]]);
    assert.equal(log.presented, 4);
});

test('a jump of the sound draws only its last 1/60 s', () => {
    const { loop, log, sound } = notedLoop();
    for (const heard of [0.05, 3, 0.5]) {
        sound.heard = heard;
        loop.drawLive(1);
    }
    assert.deepEqual(log.spans.map(([, start, end]) => [start, end]),
        [[0, 0.05], [3 - 1 / 60, 3], [0.5 - 1 / 60, 0.5]]);
});

test('before a sound starts, its first frame is shown', () => {
    const { loop, log, sound } = notedLoop();
    for (const heard of [0, 0, 0.01, 0.03]) {
        sound.heard = heard;
        loop.drawLive(1);
    }
    assert.deepEqual(log.spans.map(([, start, end]) => [start, end]),
        [[0, 1 / 60], [1 / 60, 0.03]]);
});

test('without a sound, time passes at most 1/20 s per frame', () => {
    const { loop, log } = notedLoop();
    for (const elapsed of [0.01, 0, 3, 0.02]) loop.drawLive(elapsed);
    assert.deepEqual(log.spans.map(([, , end]) => end.toFixed(6)),
        ['0.010000', '0.060000', '0.080000']);
});

test('a change while paused draws the latest frames again', () => {
    const { loop, log } = notedLoop();
    for (let i = 0; i < 300; i++) loop.drawLive(1 / 64);
    const latest = log.spans.slice(-4).map((span) => [...span.slice(0, 3), 300 / 64]);
    loop.setPaused(true);
    loop.drawLive(1);
    assert.equal(log.spans.length, 300);
    loop.invalidate();
    for (let i = 0; i < 5; i++) loop.drawLive(1);
    assert.deepEqual(log.spans.slice(300), latest);
    assert.deepEqual([log.presented, log.cleared], [301, 1]);
    loop.setPaused(false);
    loop.drawLive(1 / 64);
    assert.deepEqual(log.spans[304].slice(0, 2), [301, 300 / 64]);
});

test('many frames are drawn again in parts, and a restart while paused shows frame 1', () => {
    const { loop, log } = notedLoop({ settleFrames: 20 });
    for (let i = 0; i < 12; i++) loop.drawLive(1 / 64);
    loop.replay();
    loop.drawLive(1);
    assert.deepEqual([log.spans.length, log.presented], [20, 12]);
    loop.drawLive(1);
    assert.deepEqual([log.spans.length, log.presented], [24, 13]);
    loop.setPaused(true);
    loop.restart();
    for (let i = 0; i < 3; i++) loop.drawLive(1);
    assert.deepEqual(log.spans.slice(24), [[1, 0, 1 / 60, 1 / 60]]);
});

test('events are on in one frame, and a lost context draws nothing', () => {
    const { loop, log, drawing } = notedLoop({ parameters: [{ name: 'flash', type: 'event' }] });
    loop.drawLive(0.01);
    drawing.isLost = true;
    loop.drawLive(0.01);
    drawing.isLost = false;
    loop.drawLive(0.01);
    assert.deepEqual(log.values.map((values) => values.get('flash')), [[1], [0]]);
});
