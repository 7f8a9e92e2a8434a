// The settings of sound signals, with the defaults of the program.

const audioDefaults = {
    file: '', loop: 'on', start: 0, end: 0, mode: 'xy', level: 1, auto_gain: 'off', upsample: 4,
    channel: 'mean', fit: 'whole', v1: 0.25, o1: 0, coupling1: 'dc', invert1: 'off', v2: 0.25,
    o2: 0, coupling2: 'dc', invert2: 'off', swap: 'off', sdiv: 0.002, layout: 'split',
    trigger: 'auto', trigger_source: 'shown', trigger_level: 0, slope: 'rising', holdoff: 0, x: 1,
    y: 2, intensity: 0, r: 0, g: 0, b: 0, fft: '2048', smoothing: 0.08, floor: -80, ceiling: 0,
    low: 20, high: 20000, radius: 0.4, pulse: 0.3, beat_threshold: 2, beat_decay: 0.2,
};

/** All settings of kinds audio and microphone, some of them changed. */
export function audioSettings(changed = {}) {
    return { ...audioDefaults, ...changed };
}
