// Segments of the beam and their merging.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Beam } from '../../app/web/signals/beam.js';
import { BeamTail } from '../../app/web/signals/beam_tail.js';
import { frameSpan } from '../../app/web/signals/clock.js';
import { mergeSegments } from '../../app/web/signals/merge_segments.js';
import { SegmentBuffer, makeSegments } from '../../app/web/signals/segments.js';
import { makeSignal } from '../../app/web/signals/signals.js';

function beamOf(points) {
    const beam = new Beam();
    points.forEach((point) => beam.add(...point));
    return beam;
}

function segmentsOf(beam, before = null, spot = null) {
    const buffer = new SegmentBuffer();
    makeSegments(beam, before && new Float32Array(before), buffer);
    if (spot) {
        mergeSegments(buffer, spot);
    }
    return Array.from({ length: buffer.count },
        (_, i) => [...buffer.segments.subarray(8 * i, 8 * i + 8)]);
}

const chargeOf = (segments) => segments.reduce((sum, [, , , , a, b]) => sum + 0.5 * (a + b), 0);

test('points are connected with each other and with the previous frame', () => {
    const beam = beamOf([[0, 0, 1, 0.5], [1, 0, 2, 0.25], [1, 1, 3, 0]]);
    assert.deepEqual(segmentsOf(beam), [
        [0, 0, 1, 0, 2, 2, 0.5, 0.25], [1, 0, 1, 1, 2, 3, 0.25, 0]]);
    assert.deepEqual(segmentsOf(beam, [-1, 0, 4, 0.75])[0], [-1, 0, 0, 0, 1, 1, 0.75, 0.5]);
});

test('the beam is dark to blanked points and around points that are not finite', () => {
    assert.deepEqual(segmentsOf(beamOf([[0, 0, 1, 3], [1, 0, 0, 2], [2, 0, 1, 1]])),
        [[1, 0, 2, 0, 1, 1, 2, 1]]);
    for (const bad of [[NaN, 0, 1, 2], [1, Infinity, 1, 2], [1, 0, NaN, 2], [1, 0, 1, NaN]]) {
        const beam = beamOf([[0, 0, 1, 4], [0, 1, 1, 3], bad, [2, 0, 1, 1], [3, 0, 1, 0]]);
        assert.deepEqual(segmentsOf(beam).map(([x0, , x1]) => [x0, x1]), [[0, 0], [2, 3]]);
    }
});

test('the start charge is scaled to the duration of the segment', () => {
    // Three times the charge in 0.5 s as before in 0.25 s: 1.5 times the current.
    const beam = beamOf([[0, 0, 1, 1], [1, 0, 1, 0.75], [2, 0, 3, 0.25]]);
    assert.deepEqual(segmentsOf(beam)[1], [1, 0, 2, 0, 2, 3, 0.75, 0.25]);
    // The same current in uneven steps, apart from roundings.
    const uneven = segmentsOf(beamOf([[0, 0, 1, 1], [1, 0, 0.1, 0.9], [2, 0, 0.2, 0.7]]))[1];
    assert.equal(uneven[4], Math.fround(0.2));
});

test('a segment has the colour of its end, and another colour is not merged', () => {
    const beam = new Beam();
    for (let i = 0; i <= 8; i++) {
        beam.addTinted(i / 8, 0, 1, 1 - i / 8, 1, i === 5 ? 0.5 : 1, i / 16 < 0.25 ? 1 : 0);
    }
    const buffer = new SegmentBuffer();
    makeSegments(beam, null, buffer);
    assert.equal(buffer.count, 8);
    assert.equal(buffer.tints[3 * 4 + 1], 0.5);
    mergeSegments(buffer, { across: 0, up: 0 });
    const ends = Array.from({ length: buffer.count }, (_, i) => buffer.segments[8 * i + 2]);
    assert.deepEqual(ends, [3 / 8, 4 / 8, 5 / 8, 1]);
    assert.deepEqual([...buffer.tints.subarray(0, 12)], [1, 1, 1, 1, 1, 0, 1, 0.5, 0, 1, 1, 0]);
    makeSegments(beamOf([[0, 0, 1, 1], [1, 0, 1, 0]]), null, buffer);
    assert.equal(buffer.tints, null);
});

// From x = -0.5 to 0.5 in 1 s, with a total charge of 8.
function straight(pieces, change = () => {}) {
    const points = Array.from({ length: pieces + 1 }, (_, i) =>
        [i / pieces - 0.5, 0.25 * i / pieces, 8 / pieces, 1 - i / pieces]);
    change(points);
    return beamOf(points);
}

test('a straight path at constant speed becomes one segment with the charge and the time', () => {
    for (const pieces of [1, 2, 64, 4096]) {
        assert.deepEqual(segmentsOf(straight(pieces), null, { across: 0, up: 0 }),
            [[-0.5, 0, 0.5, 0.25, 8, 8, 1, 0]]);
    }
});

test('bends, changes of speed, changes of current and blanked moves separate segments', () => {
    const unknown = { across: 0, up: 0 };
    const count = (change) => segmentsOf(straight(8, change), null, unknown).length;
    assert.ok(count((points) => { points[4][1] += 4e-6; }) > 1);
    assert.ok(count((points) => { points[4][0] += 4e-6; }) > 1);
    assert.ok(count((points) => { points[6][3] += 0.03; }) > 1);
    assert.ok(count((points) => { points[5][2] *= 1.02; }) > 1);
    assert.equal(count((points) => { points[6][2] = 0; }), 2);
});

const sigma = 0.002;

function figure(count) {
    return beamOf(Array.from({ length: count }, (_, i) => {
        const turn = 2 * Math.PI * (i + 1) / count;
        return [0.84 * Math.sin(5 * turn + 0.5), 0.84 * Math.sin(4 * turn), 4096 / count,
            (1 - (i + 1) / count) / 60];
    }));
}

// The largest distance of a point from the merged path at equal charge.
// It is relative to 0.01 sigma, or to 0.05 sigma on a segment of up to half a sigma.
function farthest(beam, merged) {
    let most = 0;
    let charge = 0;
    let before = 0;
    let at = 0;
    for (let k = 1; k < beam.count; k++) {
        const [x, y, added] = beam.points.subarray(4 * k, 4 * k + 4);
        charge += added;
        while (at + 1 < merged.length && before + merged[at][5] < charge) {
            before += merged[at++][5];
        }
        const [x0, y0, x1, y1, , whole] = merged[at];
        const share = (charge - before) / whole;
        const off = Math.hypot(x0 + share * (x1 - x0) - x, y0 + share * (y1 - y0) - y);
        const isLong = Math.hypot(x1 - x0, y1 - y0) > 0.5 * sigma;
        most = Math.max(most, off / (sigma * (isLong ? 0.01 : 0.05)));
    }
    return most;
}

test('merging keeps the charge, the path within its tolerance, the ends and the time', () => {
    for (const count of [512, 4096, 65536]) {
        const beam = figure(count);
        const merged = segmentsOf(beam, null, { across: sigma, up: sigma });
        assert.ok(Math.abs(chargeOf(merged) / (4096 * (count - 1) / count) - 1) < 1e-6);
        assert.ok(farthest(beam, merged) < 1.02);
        assert.deepEqual(merged[0].slice(0, 2), [...beam.points.subarray(0, 2)]);
        assert.equal(merged[0][6], beam.points[3]);
        const end = beam.points.subarray(4 * count - 4, 4 * count - 2);
        assert.deepEqual(merged.at(-1).slice(2, 4), [...end]);
        assert.equal(merged.at(-1)[7], 0);
        merged.slice(1).forEach(([x0, y0, , , , , age], i) => {
            assert.deepEqual([x0, y0, age], [merged[i][2], merged[i][3], merged[i][7]]);
        });
    }
});

test('a changing current ends a segment when it has changed by 1 %', () => {
    const count = 2000; // by a factor of e in total
    const beam = beamOf(Array.from({ length: count }, (_, k) =>
        [1e-6 * k / count, 0, Math.exp(k / count), (1 - (k + 1) / count) / 60]));
    const merged = segmentsOf(beam, null, { across: sigma, up: sigma });
    // Relative to the mean of a segment the current deviates by half of its change.
    // It changes by 0.01 in a segment, plus or minus two samples and 0.001 of rounding of ages.
    assert.ok(merged.length >= 83 && merged.length <= 111);
    assert.ok(Math.abs(chargeOf(merged) / chargeOf(segmentsOf(beam)) - 1) < 1e-6);
});

test('merged segments of the second frame are as many as in the program', () => {
    // Counts of make_segments() and merge_segments() for the signals of make_signal().
    const lissajous = { kind: 'lissajous', settings: { x: 3, y: 2, phase: 0.25, amplitude: 0.8,
        speed: 0, points: 4096, weighting: 'constant' } };
    const fm = { kind: 'fm', settings: { carrier: 12, modulator: 1, index: 5, amplitude: 0.8,
        speed: 0, mode: 'yt', points: 4096 } };
    const expected = [[lissajous, 0, 0, 3966], [lissajous, 0.002, 0.002, 1522],
        [lissajous, 0.01, 0.003, 782], [lissajous, 0.005, 0, 3206], [fm, 0, 0, 4057],
        [fm, 0.002, 0.002, 3863], [fm, 0.01, 0.003, 3707]];
    for (const [spec, across, up, count] of expected) {
        const signal = makeSignal(spec);
        const tail = new BeamTail();
        const beam = new Beam();
        const buffer = new SegmentBuffer();
        for (const frame of [1, 2]) {
            const { start, end } = frameSpan(frame, 60);
            beam.clear();
            signal.trace(start, end, beam);
            tail.advance(beam, 1 / 60, frame === 1);
            makeSegments(beam, tail.before(), buffer);
            mergeSegments(buffer, { across, up });
        }
        assert.equal(buffer.count, count);
    }
});
