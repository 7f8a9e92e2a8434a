// Two wave generators on a two-channel scope: over time, or one against the other.
import { Scope } from '../scope/scope.js';
import { scopeControls } from '../scope/scope_controls.js';
import { NO_SWEEPS, PeriodicSweeps } from '../scope/sweeps.js';
import { numberSetting } from '../signal.js';
import { phaseOfCrossing, waveOfShape } from './shape.js';

/** A function generator, connected to a channel of the scope. */
class WaveGenerator {
    /** The coupling of its channel. @type {'dc' | 'ac' | 'gnd'} */
    coupling = 'dc';

    /**
     * @param {import('../signal.js').SignalSettings} settings
     * @param {'1' | '2'} number
     */
    constructor(settings, number) {
        const unit = settings.per === 'second' ? 1 : 60;
        this.shape = String(settings[`ch${number}`]);
        this.hertz = numberSetting(settings, `f${number}`) * unit;
        this.amplitude = numberSetting(settings, `a${number}`); // V
        this.mean = numberSetting(settings, `d${number}`); // V
        this.phase = numberSetting(settings, `p${number}`); // turns
        const seed = 2 * numberSetting(settings, 'seed') + (number === '2' ? 1 : 0);
        this.wave = waveOfShape(this.shape, seed);
    }

    get isOn() {
        return this.shape !== 'off';
    }

    /** Voltage that is added to the wave. */
    get added() {
        return this.coupling === 'dc' ? this.mean : 0;
    }

    /**
     * @param {number} seconds
     * @param {number} scrolled turns
     * @returns {number} V
     */
    at(seconds, scrolled) {
        if (this.coupling === 'gnd' || !this.isOn) {
            return 0;
        }
        const turns = this.hertz * seconds + this.phase + scrolled;
        return this.added + this.amplitude * this.wave(turns);
    }
}

/**
 * @param {import('../signal.js').SignalSettings} settings
 * @returns {import('../signal.js').Signal}
 */
export function makeWaveform(settings) {
    const controls = scopeControls(settings);
    const inputs = [new WaveGenerator(settings, '1'), new WaveGenerator(settings, '2')];
    if (controls.isSwapped) {
        inputs.reverse();
    }
    inputs.forEach((input, i) => {
        input.coupling = controls.channels[i].coupling;
    });
    const [first, second] = inputs;
    const isXy = controls.isXy;
    const traces = !isXy && first.isOn && second.isOn ? 2 : 1;
    const rate = numberSetting(settings, 'points') * 60 / traces;
    const scope = new Scope(controls, [first.isOn, second.isOn], rate);
    const sweeps = sweepsOfWaves(controls, inputs, rate);
    const scroll = numberSetting(settings, 'speed'); // turns per second

    /** @type {import('../scope/scope.js').VoltsReader} */
    const readVolts = (sample, start, volts) => {
        const seconds = (sample + 1) / rate;
        const drift = scroll * (isXy ? seconds : start);
        volts[0] = first.at(seconds, drift);
        volts[1] = second.at(seconds, isXy ? 0 : drift);
    };
    return {
        seconds: Infinity,
        trace: (start, end, beam) => scope.trace(start, end, Infinity, sweeps, beam, readVolts),
    };
}

/**
 * A wave triggers once per period, so the sweeps are evenly spaced.
 * Each sweep starts at the first trigger after the scope is ready again.
 * @param {import('../scope/scope_controls.js').ScopeControls} controls
 * @param {WaveGenerator[]} inputs of both channels
 * @param {number} rate samples per second
 * @returns {import('../scope/sweeps.js').ScopeSweeps}
 */
function sweepsOfWaves(controls, inputs, rate) {
    const trigger = controls.trigger;
    const sweep = controls.sweepSeconds;
    const busy = sweep + trigger.holdoffSeconds;
    if (trigger.mode === 'off') {
        return new PeriodicSweeps(0, sweep * rate, sweep * rate);
    }
    const shown = inputs[0].isOn ? 0 : 1;
    const watched = trigger.source === 0 ? shown : trigger.source - 1;
    const source = inputs[watched];
    const first = secondsToTrigger(source, controls.channels[watched], trigger);
    if (first === null) {
        return trigger.mode === 'auto' ?
            new PeriodicSweeps(0, busy * rate, sweep * rate) : NO_SWEEPS;
    }
    let period = busy;
    if (source.shape !== 'noise') {
        period = Math.ceil(busy * source.hertz - 1e-6) / source.hertz;
    }
    if (trigger.mode === 'single') {
        period = 0;
    }
    return new PeriodicSweeps(first * rate, period * rate, sweep * rate);
}

/**
 * Time after 0 at which a generator first fires the trigger.
 * @param {WaveGenerator} generator
 * @param {import('../scope/scope_controls.js').ScopeChannel} channel
 * @param {import('../scope/scope_controls.js').ScopeTrigger} trigger
 * @returns {number | null} in s. Null: it never does
 */
function secondsToTrigger(generator, channel, trigger) {
    if (generator.coupling === 'gnd' || generator.amplitude <= 0 || generator.hertz <= 0) {
        return null;
    }
    const volts = channel.isInverted ? -trigger.level : trigger.level;
    const level = (volts - generator.added) / generator.amplitude;
    const isRising = trigger.isRising !== channel.isInverted;
    const turns = phaseOfCrossing(generator.shape, level, isRising);
    if (turns === null || generator.shape === 'noise') {
        return turns;
    }
    const ahead = turns - generator.phase;
    return (ahead - Math.floor(ahead)) / generator.hertz;
}
