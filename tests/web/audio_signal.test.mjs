// Signals that draw a sound.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { makeAudioSignal } from '../../app/web/signals/audio_signal.js';
import { Beam } from '../../app/web/signals/beam.js';
import { frameSpan } from '../../app/web/signals/clock.js';
import { SoundRing } from '../../app/web/sound/live_sound.js';
import { audioSettings } from './audio_settings.mjs';
import { soundOf } from './sound_files.mjs';

const chargePerSecond = 4096 * 60;

function beamOf(signal, start, end, beam = new Beam()) {
    signal.trace(start, end, beam);
    return beam;
}

function signalOf(sound, changed) {
    return makeAudioSignal(audioSettings(changed), { sound });
}

function component(beam, index) {
    return Array.from({ length: beam.count }, (_, i) => beam.points[4 * i + index]);
}

// Ends of adjoining spans of irregular length, as animation frames have; some have no sample.
function irregularTimes(end) {
    const times = [0];
    for (let i = 1; times[times.length - 1] < end; i++) {
        const step = i % 7 === 0 ? 1e-6 : i % 5 === 0 ? 0.11 : 0.004 + 0.03 * ((i * 0.618) % 1);
        times.push(times[times.length - 1] + step);
    }
    return times;
}

function tracedInPieces(signal, times) {
    const beam = new Beam();
    for (let i = 1; i < times.length; i++) {
        beamOf(signal, times[i - 1], times[i], beam);
    }
    return beam;
}

test('each sample is drawn exactly once over irregular frames, in a loop too', () => {
    for (const rate of [44100, 48000, 8000]) {
        const frames = 20011;
        const sound = soundOf(rate, frames, (i) => i / 32768, (i) => -i / 32768);
        for (const loop of ['off', 'on']) {
            const signal = signalOf(sound, { upsample: 1, loop, start: 11 / rate });
            const beam = tracedInPieces(signal, irregularTimes(3));
            const length = frames - 11;
            const end = irregularTimes(3).pop();
            assert.equal(beam.count, loop === 'off' ? length : Math.floor(end * rate));
            component(beam, 0).forEach((x, i) => assert.equal(x, (11 + i % length) / 32768));
            component(beam, 1).forEach((y, i) => assert.equal(y, -(11 + i % length) / 32768));
        }
    }
});

test('the points of all modes do not depend on the division into frames', () => {
    const sound = soundOf(8000, 9000, (i) => 0.6 * Math.sin(i * 0.0764), (i) => (i % 90) / 100);
    const modes = [{ coupling1: 'ac' }, { intensity: 2, r: 1, auto_gain: 'on' },
        { mode: 'waveform' }, { mode: 'waveform', channel: 'both', trigger_source: '2' },
        { mode: 'spectrum' }, { mode: 'radial' }];
    for (const changed of modes) {
        const pieces = tracedInPieces(signalOf(sound, changed), irregularTimes(1.5));
        const whole = beamOf(signalOf(sound, changed), 0, irregularTimes(1.5).pop());
        assert.equal(pieces.count, whole.count);
        for (const index of [0, 1, 2]) {
            assert.deepEqual(component(pieces, index), component(whole, index));
        }
        assert.deepEqual(pieces.tints?.subarray(0, 3 * pieces.count),
            whole.tints?.subarray(0, 3 * whole.count));
    }
});

test('samples in between lie on the circle, ages end at 0 and the charge is constant', () => {
    const at = (phase) => (i) => 0.5 * Math.sin(2 * Math.PI * (i / 48 + phase));
    const sound = soundOf(48000, 240, at(0), at(0.25));
    const beam = beamOf(signalOf(sound, { upsample: 4 }), 0.5, 0.75);
    assert.equal(beam.count, 48000);
    const y = component(beam, 1);
    component(beam, 0).forEach((x, i) => assert.ok(Math.abs(Math.hypot(x, y[i]) - 0.5) < 1e-3));
    component(beam, 2).forEach((charge) => assert.equal(charge, Math.fround(60 * 4096 / 192000)));
    component(beam, 3).forEach((age, i) =>
        assert.ok(Math.abs(age - (47999 - i) / 192000) < 1e-7));
});

test('channels control position, current and colour, which are linear between samples', () => {
    const rate = 6000;
    const stair = (channel) => (i) => 0.1 * channel + 0.0001 * i;
    const sound = soundOf(rate, 600, ...[1, 2, 3, 4, 5].map(stair));
    const { start, end } = frameSpan(2, 60);
    const map = { x: 5, y: 4, intensity: 3, r: 2, g: 1, b: 0, upsample: 4, level: 0.5 };
    const beam = beamOf(signalOf(sound, map), start, end);
    assert.equal(beam.count, 400);
    const full = chargePerSecond / (4 * rate);
    for (let i = 0; i < 400; i++) {
        const value = (channel) => 0.1 * channel + 0.0001 * (100 + i / 4);
        const [x, y, charge] = beam.points.subarray(4 * i, 4 * i + 3);
        const [r, g, b] = beam.tints.subarray(3 * i, 3 * i + 3);
        assert.ok(Math.abs(x - 0.5 * value(5)) < 1e-4 && Math.abs(y - 0.5 * value(4)) < 1e-4);
        assert.ok(Math.abs(charge / full - value(3)) < 1e-6);
        assert.ok(Math.abs(r - value(2)) < 1e-6 && Math.abs(g - value(1)) < 1e-6);
        assert.equal(b, 0);
    }
    assert.equal(beamOf(signalOf(sound, { x: 0 }), start, end).tints, null);
});

test('a negative intensity blanks the beam, and mono is on both axes', () => {
    const sound = soundOf(6000, 600, (i) => (i % 2 === 0 ? 0.25 : -0.25));
    const beam = beamOf(signalOf(sound, { intensity: 1, upsample: 1 }), 0, 0.01);
    const full = Math.fround(chargePerSecond / 6000);
    assert.deepEqual(component(beam, 2), Array.from({ length: 60 }, (_, i) =>
        (i % 2 === 0 ? 0.25 * full : 0)));
    assert.deepEqual(component(beam, 0), component(beam, 1));
});

test('a sound that never crosses the trigger level sweeps at once and continuously', () => {
    const sound = soundOf(8000, 8000, () => 0.5);
    for (const start of [0, 30.5]) { // s; a sweep takes 0.02 s
        const beam = beamOf(signalOf(sound, { mode: 'waveform' }), start, start + 1);
        const dark = component(beam, 2).filter((charge) => charge === 0).length;
        assert.equal(dark, 50); // retraces
        component(beam, 1).forEach((y) => assert.ok(Math.abs(y - 0.5) < 1e-6));
    }
});

test('errors name the setting, its value and what to do', () => {
    const sound = soundOf(1000, 2000, () => 0);
    const cases = [
        [{ start: 5 }, /'start' is 5 s, but the sound is only 2 s long\. Use/],
        [{ start: 1, end: 1 }, /'end' is 1 s, but 'start' is 1 s\. Use a later end/],
        [{ intensity: 3 }, /'intensity' is channel 3, but the sound has only 1 channel\. Use/],
        [{ y: 3 }, /'y' is channel 3/],
        [{ mode: 'spectrum', low: 500, high: 100 }, /'high' must be above 'low'/],
        [{ mode: 'radial', floor: -10, ceiling: -20 }, /'ceiling' must be above 'floor'/],
    ];
    for (const [changed, message] of cases) {
        assert.throws(() => signalOf(sound, changed), { message });
    }
    assert.throws(() => signalOf(undefined, {}), /no sound to draw\. Open/);
});

test('live sound that arrives just in time is drawn like a file with the same samples', () => {
    const sound = soundOf(8000, 20000, (i) => 0.6 * Math.sin(i * 0.0764),
        (i) => 0.3 * Math.sin(i * 0.1657));
    const modes = [{}, { coupling1: 'ac' }, { mode: 'waveform', channel: 'both', sdiv: 0.01 },
        { mode: 'waveform', trigger: 'normal', trigger_level: 0.1, sdiv: 0.003 },
        { mode: 'spectrum' }, { mode: 'radial' }];
    for (const changed of modes) {
        const file = signalOf(sound, { loop: 'off', ...changed });
        const live = new SoundRing(8000, 2);
        live.write([new Float32Array(8000)]); // the device was opened 1 s before time 0
        live.first = 8000;
        const signal = makeAudioSignal(audioSettings(changed), { live });
        for (let frame = 1; frame <= 120; frame++) {
            const { start, end } = frameSpan(frame, 60);
            const received = live.count - 8000;
            const arrived = Math.floor((end + 0.025) * 8000);
            live.write(sound.channels.map((samples) => samples.subarray(received, arrived)));
            const drawn = beamOf(signal, start, end);
            const expected = beamOf(file, start, end);
            assert.equal(drawn.count, expected.count);
            assert.deepEqual(drawn.points.subarray(0, 4 * drawn.count),
                expected.points.subarray(0, 4 * drawn.count));
        }
    }
});
