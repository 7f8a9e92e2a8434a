// Signals against closed forms, and their errors.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Beam } from '../../app/web/signals/beam.js';
import { keyframeMoment } from '../../app/web/signals/drawing/keyframe_order.js';
import { RandomLevels } from '../../app/web/signals/generators/random_levels.js';
import { makeSignal } from '../../app/web/signals/signals.js';

const turn = 2 * Math.PI;
const scopeSettings = { v1: 0.25, o1: 0, coupling1: 'dc', invert1: 'off', v2: 0.25, o2: 0,
    coupling2: 'dc', invert2: 'off', swap: 'off', sdiv: 1 / 600, layout: 'split', trigger: 'auto',
    trigger_source: 'shown', trigger_level: 0, slope: 'rising', holdoff: 0 };
const waves = { ...scopeSettings, mode: 'yt', ch1: 'sine', f1: 2, a1: 0.7, p1: 0, d1: 0, ch2: 'off',
    f2: 3, a2: 0.7, p2: 0, d2: 0, per: 'frame', speed: 0, seed: 1, points: 4096 };
const oneChannel = { amplitude: 0.8, speed: 0, mode: 'xy', points: 4096 };

// The points of a frame. Frame 2 has the instants 4097 to 8192 of 1/4096 of 1/60 s.
function frame(kind, settings, paths, number = 2) {
    const beam = new Beam();
    makeSignal({ kind, settings, paths }).trace((number - 1) / 60, number / 60, beam);
    return Array.from({ length: beam.count }, (_, i) => {
        const [x, y, charge, age] = beam.points.subarray(4 * i, 4 * i + 4);
        return { x, y, charge, age, u: (4097 + i) / 4096 };
    });
}

function near(a, b, tolerance = 1e-6) {
    assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
}

test('a Lissajous figure is two sines, with less current where it is fast', () => {
    const settings = { x: 3, y: 2, phase: 0.25, amplitude: 0.8, speed: 0.6, points: 4096,
        weighting: 'speed' };
    const points = frame('lissajous', settings);
    assert.equal(points.length, 4096);
    for (const { x, y, charge, u } of points) {
        const across = turn * (3.01 * u + 0.25); // 0.6 turns/s are 0.01 turns per 1/60 s
        near(x, 0.8 * Math.sin(across));
        near(y, 0.8 * Math.sin(turn * 2 * u));
        const speed = Math.hypot(3.01 * Math.cos(across), 2 * Math.cos(turn * 2 * u));
        near(charge, 0.3 + 0.7 * 0.05 / (speed / Math.hypot(3.01, 2) + 0.05));
    }
});

test('modulations and harmonics are the sums of their formulas', () => {
    const am = frame('am', { ...oneChannel, carrier: 24, modulator: 2, depth: 0.5 });
    const fm = frame('fm', { ...oneChannel, carrier: 12, modulator: 1, index: 5 });
    const square = frame('harmonics', { ...oneChannel, base: 2, count: 4, falloff: 1,
        shape: 'square' });
    const peak = 2 * Math.SQRT2 / 3; // of sin a + sin(3 a) / 3, at an eighth of a period
    for (let i = 0; i < 4096; i++) {
        const u = am[i].u;
        near(am[i].x, 0.8 * (1 + 0.5 * Math.sin(turn * 2 * u)) / 1.5 * Math.sin(turn * 24 * u));
        near(fm[i].x, 0.8 * Math.sin(turn * 12 * u + 5 * Math.sin(turn * u)));
        const a = turn * 2 * u;
        near(square[i].x, 0.8 / peak * (Math.sin(a) + Math.sin(3 * a) / 3));
        near(square[i].y, square[(i + 4096 - 512) % 4096].x); // a quarter period earlier
    }
});

test('a sweep starts where the wave crosses the trigger level, at any phase', () => {
    for (const slope of ['rising', 'falling']) {
        const settings = { ...waves, p1: 0.3, trigger_level: 0.35, slope };
        const points = frame('waveform', settings);
        const start = points.findIndex(({ charge }) => charge === 0);
        const sign = slope === 'rising' ? 1 : -1;
        near(points[start].x, -1, 2 / 4096);
        near(points[start].y, 0.35, 0.7 * turn * 2 / 4096); // at most one sample later
        assert.ok(sign * (points[start + 9].y - points[start].y) > 0);
        const charge = points.reduce((sum, point) => sum + point.charge, 0);
        near(charge, 4096, 2);
    }
});

test('a sweep starts at the first sample after its time, also after hours', () => {
    const settings = { ...waves, trigger: 'off', sdiv: 0.0005 }; // 6144 / 5 samples
    for (const number of [1, 2, 3, 1000000]) {
        frame('waveform', settings, null, number).forEach(({ charge }, i) => {
            const sample = 4096 * (number - 1) + i;
            const isStart = sample === Math.floor(Math.ceil(sample * 5 / 6144) * 6144 / 5);
            assert.equal(charge === 0, isStart, `sample ${sample}`);
        });
    }
});

test('two traces use half of the screen each, and a scale of the whole one when overlaid', () => {
    const two = { ...waves, ch2: 'square', f2: 1, a2: 1 };
    const split = frame('waveform', two).filter(({ charge }) => charge > 0);
    assert.deepEqual([...new Set(split.map(({ y }) => y).filter((y) => y <= 0))], [0, -1]);
    const upper = split.filter(({ y }) => y > 0).map(({ y }) => y);
    near(Math.max(...upper), 0.5 + 0.35, 1e-5);
    const overlaid = frame('waveform', { ...two, layout: 'overlaid', o2: 2, invert2: 'on' });
    near(Math.min(...overlaid.map(({ y }) => y)), -0.7, 1e-5); // the sine
    near(Math.max(...overlaid.map(({ y }) => y)), 1.5, 1e-5); // 2 of 4 divisions above 1 V
});

test('a scope that waits for a trigger is dark', () => {
    const settings = { ...waves, trigger: 'normal', trigger_level: 0.8 };
    assert.ok(frame('waveform', settings).every(({ charge, x }) => charge === 0 && x === -1));
    const once = { ...waves, trigger: 'single' }; // 1/60 s from time 0
    assert.ok(frame('waveform', once).every(({ charge }) => charge === 0));
});

test('noise is that of SplitMix64', () => {
    // Outputs of the reference implementation for seed 1234567 (rosettacode.org, Splitmix64).
    const outputs = [6457827717110365317n, 3203168211198807973n, 9817491932198370423n,
        4593380528125082431n, 16408922859458223821n];
    outputs.forEach((output, i) => {
        const level = Number(output >> 11n) / 2 ** 52 - 1;
        assert.equal(new RandomLevels(i + 1).at(1234567), level);
    });
    // The first output for seed 2^64 - 1.
    assert.equal(new RandomLevels(1).at(-1), Number(0xe4d971771b652c20n >> 11n) / 2 ** 52 - 1);
});

const line = { at: [0.1, 0], scale: 2, turn: [0, 0, 90], spin: [0, 0, 0], perspective: 0,
    current: 0.5, speed: 1, dwell_seconds: 0.001,
    paths: [{ points: [0, 0, 0, 1, 0.125, 0, 0, 1, 0.25, 0, 0, 1], smooth: false }] };
const scene = { items: [line], beam_speed: 100, move_speed: 5000, move_current: 0, refresh: 60 };

test('a scene takes its time, is redrawn at its rate and has its charge', () => {
    const points = frame('scene', { points: 4096 }, scene);
    const charge = points.reduce((sum, point) => sum + point.charge, 0);
    // A line of 0.5 at 100 half screens/s, and three dwells of 1 ms, at half current.
    near(charge, 0.5 * (0.005 + 0.003) * 4096 * 60, 1e-2);
    const lit = points.filter((point) => point.charge > 0);
    near(lit[0].y, 0);
    near(lit.at(-1).y, 0.5); // twice 0.25, turned upwards
    assert.ok(lit.every(({ x }) => Math.abs(x - 0.1) < 1e-6));
    near(lit.at(-1).age, 1 / 60 - 0.008, 1e-7);
});

test('a smooth path dwells at its ends only', () => {
    const smooth = { ...line, paths: [{ ...line.paths[0], smooth: true }] };
    const points = frame('scene', { points: 4096 }, { ...scene, items: [smooth] });
    const charge = points.reduce((sum, point) => sum + point.charge, 0);
    near(charge, 0.5 * (0.005 + 0.002) * 4096 * 60, 1e-2);
});

test('frames contain each point of endless drawings once', () => {
    // There and back in 1/60 s without waiting. Drawings and frames end together.
    const paths = { ...scene, beam_speed: 60, move_speed: 60, move_current: 1, refresh: 0,
        items: [{ ...line, dwell_seconds: 0, current: 1, speed: 1 }] };
    const signal = makeSignal({ kind: 'scene', settings: { points: 64 }, paths });
    const beam = new Beam();
    for (let number = 1; number <= 3000; number++) {
        beam.clear();
        signal.trace((number - 1) / 60, number / 60, beam);
        assert.equal(beam.count, 64, `frame ${number}`);
    }
});

test('keyframes are held, morph with ease, and loop or stay', () => {
    const timing = { steps: 2, loops: true, holdSeconds: 1, morphSeconds: 2, isEased: true };
    assert.deepEqual(keyframeMoment(timing, 0.9), { step: 0, share: 0 });
    assert.deepEqual(keyframeMoment(timing, 1.5), { step: 0, share: 0.15625 }); // 3/16 - 2/64
    assert.deepEqual(keyframeMoment(timing, 5), { step: 1, share: 0.5 });
    assert.deepEqual(keyframeMoment(timing, 6.5), { step: 0, share: 0 });
    const once = { ...timing, loops: false, isEased: false };
    assert.deepEqual(keyframeMoment(once, 4.5), { step: 1, share: 0.25 });
    assert.deepEqual(keyframeMoment(once, 60), { step: 1, share: 1 });
    const still = { ...timing, holdSeconds: 0, morphSeconds: 0 };
    assert.deepEqual(keyframeMoment(still, 60), { step: 0, share: 0 });
});

test('an impossible signal is refused with what to do', () => {
    const refused = (spec, pattern) => assert.throws(() => makeSignal(spec), pattern);
    refused({ kind: 'stdin', settings: {} }, /can't draw the signal 'stdin'.*lissajous/);
    refused({ kind: 'toString', settings: {} }, /can't draw the signal 'toString'/);
    refused({ kind: 'microphone', settings: {} }, /No audio input is open.*microphone/);
    refused({ kind: 'text', settings: {} }, /no lines for this text/);
    refused({ kind: 'lissajous', settings: { x: 'a' } }, /'speed'.*not a number/);
    const empty = { items: [], beam_speed: 1, move_speed: 1, move_current: 0, refresh: 60 };
    refused({ kind: 'scene', settings: { points: 64 }, paths: empty }, /nothing to draw/);
});
