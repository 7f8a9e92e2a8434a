// Signals of the page against those of the program, at 4096 instants per frame for 12 frames.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { makeSignal } from '../../app/web/signals/signals.js';
import { beamOfPage, beamOfProgram, defaultSettings, program, withFolder }
    from './program_beam.mjs';

const seconds = 0.2;
const rate = 4096 * 60;
const skip = program ? false : 'AFTERGLOW is not set';
const defaults = program ? defaultSettings() : {};

// The largest difference. Sines of the C++ library and of the browser differ by 1e-16.
function difference(spec, text) {
    const page = beamOfPage(makeSignal(spec), seconds, rate);
    const reference = beamOfProgram(text, seconds, rate);
    assert.equal(page.length, reference.length, text);
    return reference.reduce((most, value, i) =>
        Math.max(most, Math.abs(value - page[i]) / Math.max(1, Math.abs(value))), 0);
}

function programText(kind, settings) {
    const pairs = Object.entries(settings).map(([key, value]) => `${key}=${value}`);
    return pairs.length > 0 ? `${kind}:${pairs.join(',')}` : kind;
}

const generators = [
    ['lissajous', { x: 5, y: 4, speed: 0.05, points: 1024 }],
    ['lissajous', { x: 1.7, y: -2.3, weighting: 'speed', points: 777 }],
    ['waveform', {}],
    ['waveform', { mode: 'xy', speed: 0.7, swap: 'on', invert2: 'on', o1: 1, v1: 0.3 }],
    ['waveform', { ch1: 'noise', ch2: 'triangle', seed: 77, p1: -300.2, f1: 33 }],
    ['waveform', { layout: 'overlaid', ch1: 'square', a2: 0.2, d2: 0.3, coupling2: 'ac' }],
    ['waveform', { trigger: 'normal', trigger_level: 0.5, slope: 'falling', holdoff: 0.013,
        f1: 1.37, speed: 1.3 }],
    ['waveform', { trigger: 'single', trigger_level: 0.2, d1: 0.1 }],
    ['waveform', { trigger: 'normal', trigger_level: 0.9 }],
    ['waveform', { mode: 'xy', ch1: 'noise', ch2: 'noise', seed: 1000000 }],
    ['waveform', { trigger_source: '2', ch2: 'triangle', trigger_level: 0.3, invert2: 'on',
        o1: 1.5, o2: -0.5 }],
    ['waveform', { ch1: 'off', ch2: 'saw', f2: 440, per: 'second', sdiv: 0.001 }],
    ['waveform', { trigger: 'off', coupling1: 'gnd', sdiv: 0.011 }],
    ['harmonics', { shape: 'triangle', falloff: 2, count: 9, speed: 0.37 }],
    ['harmonics', { shape: 'square', count: 64, mode: 'xy', base: 1.3 }],
    ['am', { speed: -0.3, modulator: 1.5, points: 1000 }],
    ['am', { mode: 'xy', depth: 1 }],
    ['fm', { speed: 0.25, carrier: 7.7 }],
    ['fm', { mode: 'xy', index: 20 }],
];

test('generators draw the points of the program in all modes', { skip }, () => {
    for (const [kind, changed] of generators) {
        const settings = { ...defaults[kind], ...changed };
        const text = programText(kind, changed);
        assert.ok(difference({ kind, settings }, text) < 1e-6, text);
    }
});

const flat = { at: [0, 0], scale: 1, turn: [0, 0, 0], spin: [0, 0, 0], perspective: 0, current: 1,
    speed: 1, dwell_seconds: 0 };

test('a text is drawn as by the program while it turns', { skip }, () => {
    const size = 0.3; // the letter L is two thirds as wide as it is high
    const corners = [[-size / 3, size / 2], [-size / 3, -size / 2], [size / 3, -size / 2]];
    const points = corners.flatMap(([x, y]) => [x, y, 0, 1]);
    const item = { ...flat, paths: [{ points, smooth: false }], spin: [0, 90, 0], perspective: 3 };
    const paths = { items: [item], beam_speed: 200, move_speed: 5000, move_current: 0,
        refresh: 60 };
    const spec = { kind: 'text', settings: defaults.text, paths };
    assert.ok(difference(spec, 'text:L,size=0.3,spin=90,beam_speed=200') < 1e-6);
});

test('a scene is drawn as by the program with its moves, dwells and rotation', { skip }, () => {
    const triangle = [[-0.1, -0.1], [0, 0.2], [0.1, -0.1]];
    const file = { format: 'afterglow-scene', version: 1, beam_speed: 90, refresh: 50,
        move_speed: 40, moves: 'visible', move_intensity: 0.2, items: [
            { shape: 'polyline', points: triangle, turn: [10, 20, 30], spin: [3, 40, -7],
                perspective: 1, at: [0.4, -0.1], scale: 2, dwell: 300, intensity: 0.7 },
            { shape: 'line', from: [-0.5, 0, 0.1], to: [-0.5, 0.5, 0.3], speed: 0.4,
                perspective: 0.31 }] };
    const path = (corners) => ({ points: corners.flatMap(([x, y, z = 0]) => [x, y, z, 1]),
        smooth: false });
    const items = [{ ...flat, paths: [path(triangle)], turn: [10, 20, 30], spin: [3, 40, -7],
        perspective: 1, at: [0.4, -0.1], scale: 2, dwell_seconds: 300e-6, current: 0.7 },
    { ...flat, paths: [path([[-0.5, 0, 0.1], [-0.5, 0.5, 0.3]])], speed: 0.4,
        perspective: 0.31 }];
    const paths = { items, beam_speed: 90, move_speed: 40, move_current: 0.2, refresh: 50 };
    withFolder((folder) => {
        const name = join(folder, 'scene.json');
        writeFileSync(name, JSON.stringify(file));
        const spec = { kind: 'scene', settings: defaults.scene, paths };
        assert.ok(difference(spec, `scene:${name}`) < 1e-6);
    });
});

test('a drawing morphs as in the program in each order of its keyframes', { skip }, () => {
    const a = [-0.5, 0, 0.5, 0.25];
    const b = [0.1, -0.75, -0.25, 0.5];
    const strokes = '[L-0.5 0 0.5 0.25][L0.1 -0.75 -0.25 0.5]';
    const steps = { loop: [[a, b], [b, a]], once: [[a, b]], still: [[b, b]] };
    for (const [play, lines] of Object.entries(steps)) {
        const paths = { steps: lines.map(([from, to]) => [{ from, to }]), loops: play === 'loop',
            hold_seconds: 0.04, morph_seconds: 0.07, eased: true, spin: 30, beam_speed: 300,
            refresh: 80 };
        const text = `drawing:strokes="${strokes}",play=${play},keyframe=2,hold=0.04,morph=0.07,` +
            'spin=30,beam_speed=300,refresh=80';
        const spec = { kind: 'drawing', settings: defaults.drawing, paths };
        assert.ok(difference(spec, text) < 1e-6, play);
    }
});
