// Shapes of waves between -1 and 1.
import { fractionOf, linearBetween, sineOfTurns } from '../sine.js';
import { RandomLevels } from './random_levels.js';

const NOISE_LEVELS_PER_TURN = 32;

/**
 * The wave of a shape as a function of its phase in turns.
 * All shapes except noise rise through 0 at phase 0.
 * @param {string} shape
 * @param {number} seed of noise
 * @returns {(turns: number) => number} -1..1
 */
export function waveOfShape(shape, seed) {
    switch (shape) {
        case 'sine':
            return sineOfTurns;
        case 'triangle':
            return (turns) => 1 - 4 * Math.abs(fractionOf(turns + 0.25) - 0.5);
        case 'square':
            return (turns) => (fractionOf(turns) < 0.5 ? 1 : -1);
        case 'saw':
            return (turns) => 2 * fractionOf(turns + 0.5) - 1;
        case 'noise':
            return noiseWave(seed);
        default:
            return () => 0;
    }
}

/**
 * Random levels, linearly interpolated. The wave never repeats.
 * @param {number} seed
 * @returns {(turns: number) => number}
 */
function noiseWave(seed) {
    const levels = new RandomLevels(seed);
    let index = NaN; // of the last level
    let level = 0;
    let next = 0;
    return (turns) => {
        const position = turns * NOISE_LEVELS_PER_TURN;
        const below = Math.floor(position);
        if (below !== index) {
            index = below;
            level = levels.at(below);
            next = levels.at(below + 1);
        }
        return linearBetween(level, next, position - below);
    };
}

/**
 * The phase at which a wave crosses a level.
 * @param {string} shape
 * @param {number} level
 * @param {boolean} isRising
 * @returns {number | null} in turns, 0..1. Null: it never does. 0 for noise
 */
export function phaseOfCrossing(shape, level, isRising) {
    if (shape === 'off' || Math.abs(level) >= 1) {
        return null;
    }
    if (shape === 'sine') {
        const turns = Math.asin(level) / (2 * Math.PI);
        return fractionOf(isRising ? turns : 0.5 - turns);
    }
    if (shape === 'triangle') {
        return fractionOf(isRising ? 0.25 * level : 0.5 - 0.25 * level);
    }
    if (shape === 'square') {
        return isRising ? 0 : 0.5;
    }
    if (shape === 'saw') {
        return isRising ? fractionOf(0.5 * level) : 0.5;
    }
    return 0;
}
