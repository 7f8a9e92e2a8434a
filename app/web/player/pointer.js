// The mouse or finger on the picture, as looks read it.

/**
 * Where an event is on the picture: 0 to 1 from its bottom left. The picture keeps its shape
 * within the element of the canvas.
 * @param {HTMLCanvasElement} canvas
 * @param {{clientX: number, clientY: number}} event
 * @returns {[number, number]}
 */
export function placeOnPicture(canvas, event) {
    const box = canvas.getBoundingClientRect();
    const scale = Math.min(box.width / canvas.width, box.height / canvas.height) || 1;
    const width = canvas.width * scale;
    const height = canvas.height * scale;
    const left = box.left + (box.width - width) / 2;
    const bottom = box.bottom - (box.height - height) / 2;
    return [(event.clientX - left) / width, (bottom - event.clientY) / height];
}

/** Position and press of the pointer, in pixels of the picture from its bottom left. */
export class PicturePointer {
    #canvas;
    #isHeld = false;
    #isNew = false;
    // 0 to 1: the pointer, where it was last while held, and where the press began.
    #place = [0, 0];
    #held = [0, 0];
    #first = [0, 0];

    /** @param {HTMLCanvasElement} canvas */
    constructor(canvas) {
        this.#canvas = canvas;
        this.hasMoved = false;
        /** @type {[number, number]} */
        this.position = [0, 0];
        /** Where the press is and where it began. Signs: held, and just begun. */
        this.press = [0, 0, 0, 0];
        canvas.addEventListener('pointermove', (event) => this.#move(event));
        canvas.addEventListener('pointerdown', (event) => this.#begin(event));
        for (const type of /** @type {const} */ (['pointerup', 'pointercancel']))
            canvas.addEventListener(type, (event) => this.#end(event));
    }

    /** @param {PointerEvent} event */
    #move(event) {
        if (!event.isPrimary)
            return;
        this.#place = placeOnPicture(this.#canvas, event);
        this.hasMoved = true;
        if (this.#isHeld)
            this.#held = this.#place;
    }

    /** @param {PointerEvent} event */
    #begin(event) {
        if (!event.isPrimary || event.button !== 0)
            return;
        this.#canvas.setPointerCapture(event.pointerId);
        this.#place = placeOnPicture(this.#canvas, event);
        this.#held = this.#first = this.#place;
        this.hasMoved = this.#isHeld = this.#isNew = true;
    }

    /** @param {PointerEvent} event */
    #end(event) {
        if (event.isPrimary && event.button <= 0)
            this.#isHeld = false;
    }

    /**
     * Computes the numbers for a frame.
     * @param {{width: number, height: number}} picture
     */
    beginFrame({ width, height }) {
        this.position[0] = this.#place[0] * width;
        this.position[1] = this.#place[1] * height;
        this.press[0] = this.#held[0] * width;
        this.press[1] = this.#held[1] * height;
        this.press[2] = this.#first[0] * width * (this.#isHeld ? 1 : -1);
        this.press[3] = this.#first[1] * height * (this.#isNew ? 1 : -1);
    }

    /** Call after each frame: a press is new in one frame only. */
    endFrame() {
        this.#isNew = false;
        this.hasMoved = false;
    }
}
