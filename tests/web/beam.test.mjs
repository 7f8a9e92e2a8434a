// The beam, its clock and its points.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Beam } from '../../app/web/signals/beam.js';
import { BeamTail } from '../../app/web/signals/beam_tail.js';
import { frameSpan, samplesIn } from '../../app/web/signals/clock.js';
import { chargeOfPoint, sweepPoint, tracePoints } from '../../app/web/signals/points.js';
import { cosineOfTurns, fractionOf, sineOfTurns } from '../../app/web/signals/sine.js';

test('a beam keeps all points while it grows, and white for points without a colour', () => {
    const beam = new Beam();
    for (let i = 0; i < 10000; i++) {
        beam.add(i, 2 * i, 0.5, 0.25);
    }
    assert.equal(beam.tints, null);
    beam.addTinted(-1, -2, 1, 0, 0.25, 0.5, 0.75);
    beam.extend(20000);
    assert.equal(beam.count, 30001);
    for (const i of [0, 4095, 4096, 9999]) {
        assert.deepEqual([...beam.points.subarray(4 * i, 4 * i + 4)], [i, 2 * i, 0.5, 0.25]);
        assert.deepEqual([...beam.tints.subarray(3 * i, 3 * i + 3)], [1, 1, 1]);
    }
    assert.deepEqual([...beam.tints.subarray(30000, 30006)], [0.25, 0.5, 0.75, 1, 1, 1]);
    assert.deepEqual([...beam.tints.subarray(90000, 90003)], [1, 1, 1]);
    beam.clear();
    assert.equal(beam.count, 0);
    assert.equal(beam.tints, null);
});

test('a scaled copy has the same charges, ages and colours', () => {
    const beam = new Beam();
    beam.addTinted(0.5, -0.25, 3, 0.125, 1, 0.5, 0);
    const scaled = new Beam();
    scaled.add(9, 9, 9, 9);
    scaled.copyScaled(beam, 0.5, 2);
    assert.equal(scaled.count, 1);
    assert.deepEqual([...scaled.points.subarray(0, 4)], [0.25, -0.5, 3, 0.125]);
    assert.deepEqual([...scaled.tints.subarray(0, 3)], [1, 0.5, 0]);
});

test('the last point of a frame ages until the next frame with points', () => {
    const tail = new BeamTail();
    const beam = new Beam();
    const empty = new Beam();
    beam.add(0.5, 0.25, 2, 0);
    tail.advance(beam, 0.25, true);
    assert.equal(tail.before(), null);
    tail.advance(empty, 0.25, false);
    tail.advance(empty, 0.5, false);
    assert.deepEqual([...tail.before()], [0.5, 0.25, 2, 0.75]);
    assert.deepEqual([...tail.before(2, 4)], [1, 1, 2, 0.75]);
    tail.advance(beam, 0.25, false);
    assert.equal(tail.before()[3], 1);
    tail.advance(empty, 0.25, true); // a restart
    assert.equal(tail.before(), null);
    tail.advance(beam, 0.25, false);
    assert.equal(tail.before(), null);
});

test('adjoining frames share no sample and skip none, at any rate', () => {
    for (const rate of [44100, 245760, 61440, 8000 / 3]) {
        let next = 0;
        for (let frame = 1; frame <= 600; frame++) {
            const { start, end } = frameSpan(frame, 60);
            const samples = samplesIn(start, end, rate);
            assert.equal(samples.first, next);
            next = samples.end;
        }
        assert.equal(next, Math.floor(10 * rate + 1e-6));
    }
    assert.deepEqual(samplesIn(-1, 0, 48000), { first: 0, end: 0 });
});

test('an instant that rounding puts below its whole number is counted', () => {
    assert.equal(samplesIn(0, 0.29, 100).end, 29); // 0.29 * 100 is 28.999999999999996
    for (let k = 1e11; k < 1e11 + 200; k++) {
        assert.equal(samplesIn(k / 44100, 1e9, 44100).first, k);
    }
});

test('points have the ages of their instants and the charge of full current', () => {
    const beam = new Beam();
    const write = (k, points, at) => points.set([k, -k, chargeOfPoint(100)], at);
    tracePoints(0.5, 0.75, 100, beam, write);
    assert.equal(beam.count, 25);
    for (let i = 0; i < beam.count; i++) {
        const [x, y, charge, age] = beam.points.subarray(4 * i, 4 * i + 4);
        assert.deepEqual([x, y], [50 + i, -50 - i]);
        assert.ok(Math.abs(charge - 4096 * 60 / 100) < 1e-3);
        assert.ok(Math.abs(age - (0.24 - 0.01 * i)) < 1e-7);
    }
    tracePoints(0, 10, 100, beam, write, 7); // a stream of 7 points
    assert.equal(beam.count, 32);
});

test('a sweep goes from left to right, has its full charge and a blanked first point', () => {
    const points = new Float32Array(4);
    let charge = 0;
    for (let index = 0; index < 64; index++) {
        const across = sweepPoint(index, 64, 3, points, 0);
        assert.equal(across, (index + 1) / 64);
        assert.equal(points[0], 2 * across - 1);
        assert.equal(points[2] === 0, index === 0);
        charge += points[2];
    }
    assert.ok(Math.abs(charge - 64 * 3) < 1e-4);
});

test('the sine is that of the C library to 1e-11', () => {
    for (let turns = -3; turns < 3; turns += 0.0013) {
        assert.ok(Math.abs(sineOfTurns(turns) - Math.sin(2 * Math.PI * turns)) < 1e-11);
        assert.ok(Math.abs(cosineOfTurns(turns) - Math.cos(2 * Math.PI * turns)) < 1e-11);
    }
    assert.equal(fractionOf(-0.25), 0.75);
    assert.equal(fractionOf(-3), 0);
    assert.equal(fractionOf(5.5), 0.5);
});
