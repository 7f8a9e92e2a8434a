// A player without a picture, for tests of the controls. It implements the player's interface.

/** The numbers of a JSON value: labels become item values. */
function mockNumbers(parameter, value) {
    if (parameter.type === 'image' || parameter.type === 'sound') return null;
    const item = parameter.items.find((other) => other.label === value);
    if (item) return [item.value];
    return (Array.isArray(value) ? value : [value]).map(Number);
}

export class MockPlayer extends EventTarget {
    /**
     * @param {any} description portable.json
     * @param {any} canvas
     */
    constructor(description, canvas = {}) {
        super();
        this.description = description;
        this.canvas = canvas;
        this.values = new Map();
        for (const parameter of description.parameters) {
            const numbers = mockNumbers(parameter, parameter.value);
            if (numbers) this.values.set(parameter.name, numbers);
        }
        this.signal = description.signal || null;
        this.isPaused = false;
        this.notes = [];
        this.state = { hasSound: false, needsClick: false, sourceName: '', signalName: '',
            isMediaChanged: false, frame: 0, seconds: 0, isHalved: false, framesPerSecond: 60 };
        this.calls = [];
        this.nameContent();
    }

    nameContent() {
        const { generators, source } = this.description;
        const kind = this.signal ? this.signal.kind : '';
        const known = (generators || []).find((one) => one.kind === kind);
        this.state.signalName = known ? known.label : kind;
        this.state.sourceName = source ? source.content : '';
    }

    fire(type) {
        this.dispatchEvent(new Event(type));
    }

    setValue(name, numbers) {
        const parameter = this.description.parameters.find((one) => one.name === name);
        if (!parameter) throw new Error(`unknown parameter ${name}`);
        const { limit, type } = parameter;
        this.values.set(name, numbers.map((number) => {
            const limited = limit ? Math.min(Math.max(number, limit.min), limit.max) : number;
            return /^[iu](nt|vec)/.test(type) ? Math.round(limited) : limited;
        }));
        this.fire('values');
    }

    resetValue(name) {
        this.calls.push(`resetValue ${name}`);
    }

    setSignal(spec) {
        if (spec.kind === 'text') throw new Error('Text can\'t be made in a page.');
        this.signal = spec;
        this.nameContent();
        this.fire('signal');
    }

    setPaused(isPaused) {
        this.isPaused = isPaused;
        this.fire('state');
    }

    restart() {
        this.calls.push('restart');
    }

    async openFile(kind, file) {
        this.calls.push(`${kind} ${file.name}`);
        if (kind === 'sound') this.state.signalName = file.name;
        this.fire('signal');
    }

    async openDevice(kind) {
        if (kind === 'microphone')
            throw new Error('The browser refused the microphone. Allow it and try again.');
        this.calls.push(kind);
    }

    async startSound() {
        this.state.needsClick = false;
        this.fire('state');
    }

    async resetSource() {
        this.calls.push('resetSource');
        this.signal = this.description.signal || null;
        this.nameContent();
        this.fire('signal');
    }

    async screenshot() {
        this.calls.push('screenshot');
        return new Blob(['png'], { type: 'image/png' });
    }
}
