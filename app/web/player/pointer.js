// The mouse or finger on the picture, as looks read it.

/** Position and press of the pointer, in pixels of the picture from its bottom left. */
export class PicturePointer {
    /** @param {HTMLCanvasElement} canvas */
    constructor(canvas) {
        this.canvas = canvas;
        /** @type {[number, number]} */
        this.position = [0, 0];
        /** Where the press began and where it is. Signs: held, and just begun. */
        this.press = [0, 0, 0, 0];
        this.hasMoved = false;
        this.isHeld = false;
        canvas.addEventListener('pointermove', (event) => this.move(event));
        canvas.addEventListener('pointerdown', (event) => this.begin(event));
        for (const type of /** @type {const} */ (['pointerup', 'pointercancel']))
            canvas.addEventListener(type, () => this.end());
    }

    /**
     * @param {PointerEvent} event
     * @returns {[number, number]}
     */
    place(event) {
        const box = this.canvas.getBoundingClientRect();
        return [((event.clientX - box.left) / box.width) * this.canvas.width,
            (1 - (event.clientY - box.top) / box.height) * this.canvas.height];
    }

    /** @param {PointerEvent} event */
    move(event) {
        this.position = this.place(event);
        this.hasMoved = true;
        if (this.isHeld)
            [this.press[0], this.press[1]] = this.position;
    }

    /** @param {PointerEvent} event */
    begin(event) {
        this.canvas.setPointerCapture(event.pointerId);
        this.position = this.place(event);
        this.hasMoved = true;
        this.isHeld = true;
        this.press = [...this.position, ...this.position];
    }

    end() {
        this.isHeld = false;
        this.press[2] = -Math.abs(this.press[2]);
    }

    /** Call after each frame: a press has begun in one frame only. */
    endFrame() {
        this.press[3] = -Math.abs(this.press[3]);
        this.hasMoved = false;
    }
}
