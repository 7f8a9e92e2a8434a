// Parameters that change by themselves: LFO, sound level and beat, docs/presets.md.

import { usableNumbers } from './values.js';

/**
 * A modulation as a preset writes it, with all numbers of its kind. `unit` is seconds without one.
 * @typedef {{kind: 'lfo'|'envelope'|'beat', depth: number, unit?: string, shape?: string,
 *     rate?: number, period?: number, phase?: number, attack?: number, release?: number,
 *     threshold?: number}} ModulationDescription
 * @typedef {{bpm: number, downbeat?: number}} ModulationTempo
 *     `bpm` in beats per minute, `downbeat` in s.
 * @typedef {{name: string, type: string, min: number, max: number,
 *     axes?: {min: number, max: number}[], limit?: {min: number, max: number},
 *     modulation?: ModulationDescription}} ModulatedParameter
 */

/**
 * The level of a sound, from 0 for silence to 1 for full scale. Times are in s.
 * `envelope` follows the peaks with two time constants. `secondsSinceBeat` is null without a recent
 * beat. A beat has at least `threshold` times the mean energy.
 * @typedef {{envelope: (seconds: number, attack: number, release: number) => number,
 *     secondsSinceBeat: (seconds: number, threshold: number) => number|null}} Loudness
 */

/**
 * The change at a time in s, relative to the depth: -1..1 for an LFO, otherwise 0..1.
 * @typedef {(seconds: number, loudness: Loudness|null) => number} ModulationWave
 */

const shortestConstant = 0.001;  // s
const longestEnvelope = 2;  // s
const longestDecay = 0.5;  // s, after a beat

/**
 * The fraction of a cycle, from 0 to below 1.
 * @param {number} turns
 */
function shareOfTurn(turns) {
    return turns - Math.floor(turns);
}

/**
 * FNV-1a with 64 bits of a parameter's name, without its scope.
 * @param {string} name
 * @returns {bigint}
 */
function seedOfName(name) {
    let digest = 0xcbf29ce484222325n;
    for (const byte of new TextEncoder().encode(name.slice(name.lastIndexOf('/') + 1)))
        digest = BigInt.asUintN(64, (digest ^ BigInt(byte)) * 0x100000001b3n);
    return digest;
}

/**
 * The first number of SplitMix64 (Steele, Lea and Flood 2014).
 * @param {bigint} seed
 * @returns {number} from 0 to below 1
 */
function firstRandom(seed) {
    let z = BigInt.asUintN(64, seed + 0x9e3779b97f4a7c15n);
    z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return Number((z ^ (z >> 31n)) >> 11n) * 2 ** -53;
}

/**
 * One random number per cycle.
 * @param {string} name of the parameter
 * @returns {(turns: number) => number} -1..1
 */
function randomSteps(name) {
    const seed = seedOfName(name);
    let known = NaN;
    let value = 0;
    return (turns) => {
        const step = Math.floor(turns);
        if (step !== known)
            value = 2 * firstRandom(seed ^ BigInt.asUintN(64, BigInt(step) * 0xd1342543de82ef95n))
                - 1;
        known = step;
        return value;
    };
}

/** @type {Object<string, (turns: number) => number>} */
const lfoShapes = {
    sine: (turns) => Math.sin(2 * Math.PI * shareOfTurn(turns)),
    triangle: (turns) => 1 - 4 * Math.abs(shareOfTurn(turns + 0.25) - 0.5),
    saw: (turns) => 2 * shareOfTurn(turns) - 1,
    square: (turns) => (shareOfTurn(turns) < 0.5 ? 1 : -1),
};

/**
 * @param {ModulationDescription} modulation
 * @param {string} name of the parameter
 * @param {ModulationTempo} tempo
 * @returns {ModulationWave}
 */
function lfoWave({ unit, shape = 'sine', rate = 0.5, period = 4, phase = 0 }, name, tempo) {
    const at = shape === 'random' ? randomSteps(name) : lfoShapes[shape];
    const { bpm, downbeat = 0 } = tempo;
    if (unit === 'beats')
        return (seconds) => at(((seconds - downbeat) * bpm) / 60 / period + phase);
    return (seconds) => at(rate * seconds + phase);
}

/**
 * @param {ModulationDescription} modulation
 * @param {string} name of the parameter
 * @param {ModulationTempo} tempo
 * @returns {ModulationWave}
 */
function modulationWave(modulation, name, tempo) {
    const { kind, unit, attack = 0.01, release = 0.3, threshold = 2 } = modulation;
    if (kind === 'lfo')
        return lfoWave(modulation, name, tempo);
    /** @type {(time: number, longest: number) => number} */
    const inSeconds = (time, longest) => (unit === 'beats'
        ? Math.min(Math.max(time * (60 / tempo.bpm), shortestConstant), longest) : time);
    if (kind === 'envelope') {
        const [rise, fall] = [attack, release].map((one) => inSeconds(one, longestEnvelope));
        return (seconds, loudness) => (loudness ? loudness.envelope(seconds, rise, fall) : 0);
    }
    const decay = inSeconds(release, longestDecay);
    return (seconds, loudness) => {
        const since = loudness && loudness.secondsSinceBeat(seconds, threshold);
        return since === null ? 0 : Math.exp(-since / decay);
    };
}

/**
 * The modulations of a look. `apply` returns the values in the frame that ends at `seconds`:
 * `values` if nothing is modulated, otherwise `target`. Null loudness is silence.
 * @param {ModulatedParameter[]} parameters
 * @param {ModulationTempo} tempo
 * @returns {{apply: (values: Map<string, number[]>, seconds: number, loudness: Loudness|null,
 *     target: Map<string, number[]>) => Map<string, number[]>}}
 */
export function makeModulations(parameters, tempo) {
    const moving = parameters.flatMap((parameter) => (parameter.modulation ? [{ parameter,
        depth: parameter.modulation.depth,
        wave: modulationWave(parameter.modulation, parameter.name, tempo) }] : []));
    return {
        apply(values, seconds, loudness, target) {
            if (moving.length === 0)
                return values;
            for (const [name, numbers] of values)
                target.set(name, numbers);
            for (const { parameter, depth, wave } of moving) {
                const { name, axes = [] } = parameter;
                const numbers = values.get(name) || [];
                const by = depth * wave(seconds, loudness);
                target.set(name, usableNumbers(numbers, parameter, numbers.map((number, i) => {
                    const { min, max } = axes[i] || parameter;
                    return number + by * (max - min);
                })));
            }
            return target;
        },
    };
}

/**
 * What changes a parameter: 'LFO, sine'.
 * @param {ModulationDescription} modulation
 * @returns {string}
 */
export function modulationText({ kind, shape }) {
    if (kind === 'lfo')
        return `LFO, ${shape === 'random' ? 'random steps' : shape}`;
    return kind === 'envelope' ? 'sound level' : 'beat';
}
