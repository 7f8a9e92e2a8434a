// The rows of sound textures. The program computes the same, see sound_texels_test.cpp.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { soundStream } from '../../app/web/signals/audio_stream.js';
import { makeLissajous } from '../../app/web/signals/generators/lissajous.js';
import { beamStream } from '../../app/web/sound/beam_stream.js';
import { SoundTexels, silentTexels, soundTexels } from '../../app/web/sound/sound_texels.js';
import { soundOf } from './sound_files.mjs';

const rate = 48000;
const silent = () => 0;

function sine(bin, amplitude) { // in the middle of a bin of 2048 samples
    return (i) => amplitude * Math.sin(2 * Math.PI * bin * i / 2048);
}

function texelsOf(left, right, loops = false) {
    const sound = soundOf(rate, 3 * rate, left, right);
    return new SoundTexels(soundStream(sound, { first: 0, end: 0, loops }));
}

function close(value, expected, tolerance) {
    assert.ok(Math.abs(value - expected) <= tolerance, `${value} instead of ${expected}`);
}

test('a wave has the latest samples of left and right, oldest first, centred at 0.5', () => {
    const texels = texelsOf((i) => i / 1024, (i) => i / -2048);
    const rows = texels.rows({ holds: 'wave', columns: 2 }, 1 / 60); // samples 0 to 799
    assert.deepEqual({ ...rows, values: [...rows.values] }, { width: 2, height: 2, values:
        [0.5 + 399 / 1024, 0.5 + 0.5 * 799 / 1024, 0.5 - 399 / 2048, 0.5 - 0.5 * 799 / 2048] });
    const early = texels.rows({ holds: 'wave', columns: 900 }, 1 / 60).values;
    assert.equal(early[99], 0.5); // before the sound
    assert.equal(early[102], 0.5 + 1 / 1024);
    const peaks = texelsOf((i) => (i === 500 ? -0.75 : 0.125), silent);
    assert.deepEqual([...peaks.rows({ holds: 'wave', columns: 1 }, 1 / 60).values], [0.875, 0.5]);
});

test('a spectrum has amplitudes from 0 Hz to half the rate, one row per channel', () => {
    const texels = texelsOf(sine(64, 0.5), sine(512, 0.25));
    const fine = texels.rows({ holds: 'spectrum', columns: 1024 }, 1).values;
    close(fine[64], 0.5, 1e-6);
    close(fine[1024 + 512], 0.25, 1e-6);
    close(fine[63], 0.25, 1e-6); // the neighbours of a Hann window have half the height
    for (const column of [0, 61, 67, 200, 512, 1023, 1024 + 64]) {
        close(fine[column], 0, 1e-6);
    }
    const coarse = texels.rows({ holds: 'spectrum', columns: 256 }, 1).values;
    close(coarse[16], 0.5, 1e-6);
    close(coarse[256 + 128], 0.25, 1e-6);
});

test('the analyser is that of Web Audio: Blackman window, decibels from -100 to -30', () => {
    const texels = texelsOf((i) => sine(64, 0.02)(i) + sine(300, 1.8)(i), silent);
    const levels = texels.rows({ holds: 'analyser', columns: 512 }, 2).values;
    // The mean of both channels is 0.01. A transform divided by its size has half of a real sine.
    const decibels = 20 * Math.log10(0.01 * 0.5 * 0.42);
    close(levels[64], (decibels + 100) / 70, 1e-5);
    assert.equal(levels[300], 1);
    assert.equal(levels[150], 0);
    const ramp = texelsOf((i) => i / 65536, silent);
    const wave = ramp.rows({ holds: 'analyser', columns: 512 }, 1).values.subarray(512);
    assert.equal(wave[3], Math.fround(0.5 + 0.25 * (48000 - 2048 + 3) / 65536));
});

test('the analyser smooths magnitudes by 0.8 per 1/60 s, whatever was read before', () => {
    const sound = soundOf(rate, 2 * rate, (i) => (i < rate ? sine(64, 0.1)(i) : 0));
    const texture = { holds: 'analyser', columns: 512 };
    const texels = new SoundTexels(soundStream(sound, { first: 0, end: 0, loops: false }));
    const inOrder = [...Array(79).keys()].map((frame) => texels.rows(texture, frame / 60));
    const step = 20 * Math.log10(0.8) / 70;
    close(inOrder[78].values[64] - inOrder[68].values[64], 10 * step, 1e-5);
    const atOnce = soundTexels(sound, 68 / 60, texture);
    atOnce.values.forEach((level, i) => close(level, inOrder[68].values[i], 1e-4));
});

test('silence has the levels of a sound of zeros', () => {
    const texels = texelsOf(silent, silent);
    for (const holds of ['wave', 'spectrum', 'analyser']) {
        const texture = { holds, columns: 32 };
        assert.deepEqual(silentTexels(texture), texels.rows(texture, 1));
    }
});

test('the sound of a beam has x on the left and y on the right, without gaps', () => {
    const stream = beamStream(makeLissajous({ x: 2, y: 2, phase: 0.25, amplitude: 0.5, speed: 0,
        points: 4096, weighting: 'constant' }));
    const samples = new Float32Array(2 * 4800); // six blocks
    stream.read(47960, 4800, samples);
    const step = 0.5 * 2 * Math.PI * 120 / 48000; // two periods per 1/60 s
    for (let i = 0; i < 4800; i++) {
        const [x, y] = samples.subarray(2 * i, 2 * i + 2);
        close(Math.hypot(x, y), 0.5, 1e-4);
        if (i > 0) {
            const moved = Math.hypot(x - samples[2 * i - 2], y - samples[2 * i - 1]);
            close(moved, step, 1e-4);
        }
    }
    stream.read(-4, 2, samples);
    assert.deepEqual([...samples.subarray(0, 4)], [0, 0, 0, 0]);
});
