// The clocks of played and of live sound, with a simulated audio device.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Microphone, SoundRing } from '../../app/web/sound/live_sound.js';
import { SmoothClock } from '../../app/web/sound/smooth_clock.js';
import { SoundPlayer } from '../../app/web/sound/sound_player.js';
import { audioSettings } from './audio_settings.mjs';
import { soundOf } from './sound_files.mjs';

const latency = 0.2; // s, from rendering to hearing
const burst = 0.0213; // s, rendered at once

/** A device with its context; `now` is the time in s. */
class Device {
    now = 100;
    nodes = [];

    constructor(t) {
        const device = this;
        // Assignment fails in older versions of Node.js.
        Object.defineProperty(performance, 'now',
            { value: () => 1000 * device.now, configurable: true });
        globalThis.AudioBuffer = class {
            constructor(options) {
                Object.assign(this, options, { duration: options.length / options.sampleRate,
                    channels: [] });
            }

            copyToChannel(samples, channel) {
                this.channels[channel] = samples;
            }
        };
        globalThis.AudioContext = class {
            destination = {};
            state = 'suspended';
            rendered = 0;

            constructor({ sampleRate = 48000 } = {}) {
                this.sampleRate = sampleRate;
                device.context = this;
            }

            get currentTime() {
                return this.state === 'running'
                    ? this.rendered + Math.floor((device.now - this.since) / burst) * burst
                    : this.rendered;
            }

            getOutputTimestamp() {
                return { contextTime: Math.max(this.currentTime - latency, 0),
                    performanceTime: 1000 * device.now };
            }

            async resume() {
                if (device.isBlocked) {
                    return new Promise(() => {});
                }
                this.since = device.now;
                this.state = 'running';
            }

            async suspend() {
                this.rendered = this.currentTime;
                this.state = 'suspended';
            }

            createBufferSource() {
                const node = { playbackRate: {}, connect() {}, disconnect() {},
                    stop() { node.isStopped = true; },
                    start(...times) { node.times = times; } };
                device.nodes.push(node);
                return node;
            }
        };
        t.after(() => {
            delete performance.now;
            delete globalThis.AudioContext;
            delete globalThis.AudioBuffer;
        });
    }

    /** Calls `at` each 1/60 s. */
    run(seconds, at = () => {}) {
        for (let frame = 1; frame <= 60 * seconds; frame++) {
            this.now += 1 / 60;
            at();
        }
    }
}

test('the clock of a sound is that of the heard sample, smooth and never back', async (t) => {
    const device = new Device(t);
    const player = new SoundPlayer(soundOf(48000, 48000, () => 0), audioSettings());
    assert.ok(player.needsClick);
    await player.start();
    assert.ok(!player.needsClick);
    let last = 0;
    device.run(10, () => {
        const seconds = player.seconds();
        const [startedAt] = device.nodes[0].times;
        const heard = device.now - 100 - startedAt - latency;
        assert.ok(seconds >= last && seconds <= last + 0.025);
        assert.ok(Math.abs(seconds - Math.max(heard, 0)) < burst, `${seconds} ${heard}`);
        last = seconds;
    });
    assert.ok(last > 9.7);
});

test('a pause stops the clock, and a restart plays from time 0', async (t) => {
    const device = new Device(t);
    const player = new SoundPlayer(soundOf(48000, 48000, () => 0), audioSettings());
    await player.start();
    device.run(2, () => player.seconds());
    player.setPaused(true);
    const paused = player.seconds();
    device.run(5, () => assert.equal(player.seconds(), paused));
    player.setPaused(false);
    device.run(1, () => player.seconds());
    assert.ok(Math.abs(player.seconds() - paused - 1 + latency + 0.05) < 2 * burst);
    assert.ok(Math.abs(device.nodes[1].times[1] - paused % 1) < 1e-9); // in the loop
    assert.ok(device.nodes[0].isStopped && !device.nodes[1].isStopped);
    player.restart();
    assert.equal(player.seconds(), 0);
    assert.equal(device.nodes[2].times[1], 0);
});

test('a browser that blocks sound needs a click, which starts at a chosen time', async (t) => {
    const device = new Device(t);
    device.isBlocked = true;
    const player = new SoundPlayer(soundOf(48000, 48000, () => 0), audioSettings());
    player.start();
    device.run(1);
    assert.ok(player.needsClick);
    assert.equal(player.seconds(), 0);
    device.isBlocked = false;
    await player.start(3.25);
    assert.ok(!player.needsClick);
    assert.equal(player.seconds(), 3.25);
    assert.equal(device.nodes.pop().times[1], 0.25);
});

test('the part from start to end is played at its own rate, once without a loop', async (t) => {
    const device = new Device(t);
    const sound = soundOf(4000, 8000, (i) => i / 8192, (i) => -i / 8192, () => 1);
    const settings = audioSettings({ start: 0.5, end: 1.5, loop: 'off' });
    const player = new SoundPlayer(sound, settings);
    await player.start();
    const [node] = device.nodes;
    assert.equal(node.loop, false);
    assert.equal(node.playbackRate.value, 0.5); // browsers need 8000 Hz
    assert.equal(node.buffer.sampleRate, 8000);
    assert.deepEqual(node.buffer.channels, sound.channels.slice(0, 2)
        .map((samples) => samples.subarray(2000, 6000)));
    player.seek(0.75);
    assert.equal(device.nodes[1].times[1] * node.buffer.sampleRate, 3000);
    player.seek(1);
    assert.equal(device.nodes.length, 2); // the sound has ended
    device.run(1, () => player.seconds());
    assert.ok(player.seconds() > 1.5); // the picture continues
});

test('a clock that stops and jumps is followed, but never back', () => {
    const clock = new SmoothClock();
    clock.jump(5);
    assert.equal(clock.follow(4.9, 10), 5);
    assert.equal(clock.follow(5.1, 10.2), 5.1);
    assert.equal(clock.follow(6.1, 11.2), 6.1);
    assert.ok(clock.follow(6.1, 11.25) <= 6.15); // its device stops
    assert.ok(clock.follow(6.1, 12) <= 6.15);
    assert.equal(clock.follow(9, 12.1), 9);
    clock.jump(1);
    assert.equal(clock.seconds, 1);
});

test('live sound is drawn up to samples that have arrived, each once', (t) => {
    const device = new Device(t);
    const microphone = new Microphone(new AudioContext(), { getAudioTracks: () => [] }, 2);
    const drawn = [];
    let sent = 0;
    let end = 0;
    const frame = () => {
        const isBlocked = device.now > 103 && device.now < 103.1; // the page handles no messages
        if (!isBlocked && device.now - 101 > (sent + 1024) / 48000) {
            for (let i = 0; i < 8; i++, sent += 128) {
                microphone.receive([Float32Array.from({ length: 128 }, (_, k) => sent + k)]);
            }
        }
        const next = microphone.seconds();
        assert.ok(next >= end && next < end + 0.04);
        const numberAt = (time) =>
            Math.max(microphone.sound.first + Math.floor(time * 48000 + 1e-6), 0);
        const first = numberAt(end);
        const count = numberAt(next) - first;
        assert.ok(numberAt(next) <= Math.max(sent - 0.025 * 48000, 0)); // for triggers
        const samples = new Float32Array(count);
        microphone.sound.read(first, first + count, 1, samples);
        drawn.push(...samples);
        end = next;
    };
    device.run(1, () => microphone.seconds());
    microphone.startAt(2);
    end = microphone.seconds();
    assert.ok(Math.abs(end - 2) < 1e-4);
    device.run(5, frame);
    assert.ok(end < 7 - 0.025 && end > 7 - 0.1, `${end}`);
    assert.ok(drawn.length > 4.8 * 48000);
    drawn.forEach((sample, i) => assert.equal(sample, i));
});

test('a ring keeps the latest 16 s, repeats missing channels and is silent elsewhere', () => {
    const ring = new SoundRing(1000, 3);
    for (let block = 0; block < 17; block++) {
        const at = (sign) =>
            Float32Array.from({ length: 1000 }, (_, i) => sign * (1000 * block + i));
        ring.write([at(1), at(-1)]);
    }
    assert.equal(ring.count, 17000);
    const samples = new Float32Array(2);
    const read = (first, channel) => {
        ring.read(first, first + 2, channel, samples);
        return [...samples];
    };
    assert.deepEqual(read(16998, 0), [16998, 16999]);
    assert.deepEqual(read(16999, 2), [-16999, 0]);
    assert.deepEqual(read(999, 1), [0, -1000]);
    assert.deepEqual(read(-2, 0), [0, 0]);
});
