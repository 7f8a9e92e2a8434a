// Rotates looks with an orbit by mouse and fingers, docs/look-format.md.

import { withCameraMoved, withDistanceScaled, withObjectTurned } from '../look/orbit_moves.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} OrbitPlayer */
/** @typedef {import('./edit_history.js').EditHistory} OrbitHistory */
/** @typedef {import('../look/orbit_moves.js').OrbitPose} Pose */

const factorPerNotch = 0.9;
const pixelsPerNotch = 100;
const rightButton = 2;

/**
 * The scope of an orbit in a stack: 'caffeine/' of 'caffeine/orbit_turn'.
 * @param {string} name
 */
function ownerOf(name) {
    return name.slice(0, name.lastIndexOf('/') + 1);
}

/**
 * Changes all orbits of the look.
 * @param {OrbitPlayer} player
 * @param {(pose: Pose) => Pose} move
 */
function moveOrbits(player, move) {
    const all = player.description.parameters.filter((one) => one.orbit);
    for (const owner of new Set(all.map((one) => ownerOf(one.name)))) {
        const parts = all.filter((one) => ownerOf(one.name) === owner);
        /** @type {any} */
        const pose = { turn: [0, 0, 0], azimuth: 0, elevation: 0, distance: 1 };
        for (const { name, orbit } of parts) {
            const numbers = player.values.get(name) || [];
            pose[String(orbit)] = orbit === 'turn' ? numbers : numbers[0];
        }
        /** @type {any} */
        const moved = move(pose);
        for (const { name, orbit } of parts) {
            const numbers = [moved[String(orbit)]].flat();
            if (String(numbers) !== String(player.values.get(name)))
                player.setValue(name, numbers);
        }
    }
}

/** The middle and size of one or two touches. */
class TouchedPlace {
    /** @param {{x: number, y: number}[]} touches */
    constructor([first, second = first]) {
        this.x = (first.x + second.x) / 2;
        this.y = (first.y + second.y) / 2;
        this.spread = Math.hypot(first.x - second.x, first.y - second.y);
    }
}

/**
 * One finger or the left button rotates the object, two fingers or the right button move the
 * camera. A pinch, or scrolling with Ctrl, changes its distance.
 * @param {OrbitPlayer} player
 * @param {OrbitHistory} history
 * @returns {void}
 */
export function listenForOrbit(player, history) {
    const parts = player.description.parameters.map((one) => one.orbit).filter(Boolean);
    if (!parts.length) return;
    const { canvas } = player;
    const hasCamera = parts.includes('azimuth');
    /** @type {Map<number, {x: number, y: number}>} */
    const touches = new Map();
    let place = new TouchedPlace([{ x: 0, y: 0 }]);
    let isCamera = false;
    const move = (/** @type {(pose: Pose) => Pose} */ change) =>
        history.edit('orbit', () => moveOrbits(player, change));
    const begin = () => {
        if (touches.size) place = new TouchedPlace([...touches.values()]);
    };
    const end = (/** @type {PointerEvent} */ event) => {
        touches.delete(event.pointerId);
        begin();
        if (!touches.size) history.finish();
    };
    canvas.style.touchAction = 'none';
    canvas.addEventListener('pointerdown', (event) => {
        if (event.pointerType === 'mouse' && event.button === 1) return;
        canvas.setPointerCapture(event.pointerId);
        touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
        isCamera = hasCamera && (event.button === rightButton || touches.size > 1
            || !parts.includes('turn'));
        begin();
    });
    canvas.addEventListener('pointermove', (event) => {
        if (!touches.has(event.pointerId)) return;
        touches.set(event.pointerId, { x: event.clientX, y: event.clientY });
        const next = new TouchedPlace([...touches.values()]);
        const box = canvas.getBoundingClientRect();
        const degrees = 180 / Math.max(Math.min(box.width, box.height), 1);
        const right = (next.x - place.x) * degrees;
        const up = (place.y - next.y) * degrees;
        const factor = place.spread > 0 && next.spread > 0 ? place.spread / next.spread : 1;
        place = next;
        move((pose) => {
            const moved = (isCamera ? withCameraMoved : withObjectTurned)(pose, right, up);
            return factor === 1 ? moved : withDistanceScaled(moved, factor);
        });
    });
    canvas.addEventListener('pointerup', end);
    canvas.addEventListener('pointercancel', end);
    if (!hasCamera) return;
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
        if (!event.ctrlKey) return;
        event.preventDefault();
        const notches = event.deltaMode === 0 ? event.deltaY / pixelsPerNotch : event.deltaY / 3;
        move((pose) => withDistanceScaled(pose, factorPerNotch ** -notches));
        history.finish();
    }, { passive: false });
}
