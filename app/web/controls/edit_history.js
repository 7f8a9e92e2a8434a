// Undo and redo of values and of the signal.

/** @typedef {import('./parameter_text.js').LookParameter} HistoryParameter */
/** @typedef {{kind: string, settings: Record<string, any>}} HistorySignal */
/**
 * A kind of signal that the page can generate. A setting with items has the label as its value.
 * @typedef {{kind: string, label: string, settings: HistoryParameter[]}} SignalGenerator
 */
/**
 * The members of portable.json that the controls read.
 * @typedef {object} LookDescription
 * @property {string} [id] folder name of the look
 * @property {string} [digest] look_digest of presets
 * @property {string} name
 * @property {string} about
 * @property {string} author
 * @property {string} license
 * @property {{file: string, license: string, text: string}[]} notices
 * @property {string} driven_by 'signal', 'picture' or 'nothing'
 * @property {HistorySignal} [signal]
 * @property {{content: string, generated?: string}} [source]
 * @property {HistoryParameter[]} parameters
 * @property {SignalGenerator[]} [generators]
 * @property {{inputs: {from: string}[]}[]} passes
 */
/**
 * @typedef {object} PlayerState
 * @property {boolean} hasSound
 * @property {boolean} needsClick
 * @property {string} sourceName
 * @property {string} signalName
 * @property {boolean} isMediaChanged something else is played than in the export
 * @property {number} frame
 * @property {number} seconds
 * @property {boolean} isHalved
 * @property {number} framesPerSecond
 */
/**
 * The part of the player that the controls use. `openParameterFile` is optional.
 * @typedef {object} PlayerMembers
 * @property {LookDescription} description
 * @property {HTMLCanvasElement} canvas
 * @property {Map<string, number[]>} values
 * @property {(name: string, numbers: number[]) => void} setValue
 * @property {(name: string) => void} resetValue
 * @property {HistorySignal | null} signal
 * @property {(spec: HistorySignal) => void} setSignal
 * @property {boolean} isPaused
 * @property {(isPaused: boolean) => void} setPaused
 * @property {() => void} restart
 * @property {(kind: 'sound' | 'picture' | 'video', file: File) => Promise<void>} openFile
 * @property {(kind: 'microphone' | 'camera' | 'screen') => Promise<void>} openDevice
 * @property {() => Promise<void>} startSound
 * @property {() => Promise<void>} resetSource
 * @property {(name: string, file: File) => Promise<void>} [openParameterFile]
 * @property {PlayerState} state
 * @property {string[]} notes
 * @property {() => Promise<Blob>} screenshot
 */
/** @typedef {PlayerMembers & EventTarget} ControlledPlayer */
/** @typedef {{values: Map<string, number[]>, signal: HistorySignal | null}} EditState */

const mostEdits = 200;

/**
 * @param {SignalGenerator} generator
 * @returns {HistorySignal} with the default settings
 */
export function defaultSignal({ kind, settings }) {
    return { kind, settings: Object.fromEntries(settings.map((one) => [one.name, one.default])) };
}

/** The steps of undo. A gesture, such as dragging a slider, is one step. */
export class EditHistory {
    /** @param {ControlledPlayer} player */
    constructor(player) {
        this.player = player;
        /** @type {EditState[]} */
        this.past = [];
        /** @type {EditState[]} */
        this.future = [];
        this.gesture = '';
    }

    /**
     * Applies a change. Changes with the same gesture are one step until `finish`.
     * @param {string} gesture
     * @param {() => void} change
     * @returns {void}
     */
    edit(gesture, change) {
        if (gesture !== this.gesture)
            this.past = [...this.past.slice(1 - mostEdits), this.current()];
        this.gesture = gesture;
        this.future = [];
        change();
    }

    /**
     * Applies a change as one step of its own.
     * @param {string} name
     * @param {() => void} change
     * @returns {void}
     */
    step(name, change) {
        this.finish();
        this.edit(name, change);
        this.finish();
    }

    /** @returns {void} */
    finish() {
        this.gesture = '';
    }

    /** @returns {void} */
    undo() {
        this.move(this.past, this.future);
    }

    /** @returns {void} */
    redo() {
        this.move(this.future, this.past);
    }

    /** @returns {EditState} */
    current() {
        const { values, signal } = this.player;
        return { values: new Map(values), signal };
    }

    /**
     * Moves one state between the lists and restores it.
     * @param {EditState[]} from
     * @param {EditState[]} to
     * @returns {void}
     */
    move(from, to) {
        const state = from.pop();
        if (!state) return;
        to.push(this.current());
        this.finish();
        for (const [name, numbers] of state.values)
            if (String(numbers) !== String(this.player.values.get(name)))
                this.player.setValue(name, numbers);
        if (state.signal && JSON.stringify(state.signal) !== JSON.stringify(this.player.signal))
            this.player.setSignal(state.signal);
    }
}
