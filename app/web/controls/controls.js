// The user interface of the page: panel, keys, drag and drop, and the address.

import { makeAbout, makeNotes } from './about_section.js';
import { PageActions } from './actions.js';
import { EditHistory } from './edit_history.js';
import { makeElement, makeIconButton, makeTextButton, oncePerFrame, setIcon } from './element.js';
import { dropHint, makeMediaSection, openDroppedFile } from './media_section.js';
import { makeMessages, showKeys } from './messages.js';
import { listenForOrbit } from './orbit_gestures.js';
import { makeParameterList } from './parameter_list.js';
import { applyShared, linkFragment, readShared } from './shared_link.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} PagePlayer */
/**
 * @typedef {object} ControlPanel
 * @property {HTMLElement} element
 * @property {() => void} update shows the state of the player
 * @property {() => void} toggle shows or hides it
 * @property {HTMLInputElement} search
 */

const linkDelay = 400;  // ms. Browsers allow about 100 changes of the address in 30 s.
const idleDelay = 3000;  // ms until the pointer disappears while the panel is hidden

/** @type {[string, string][]} */
const keyTexts = [
    ['H', 'Show or hide the panel'], ['/', 'Search parameters'], ['Space', 'Pause or continue'],
    ['R', 'Restart'], ['F', 'Full screen'], ['S', 'Save a screenshot'], ['Ctrl+Z', 'Undo'],
    ['Ctrl+Shift+Z', 'Redo'], ['Ctrl+V', 'Paste a preset'], ['← →', 'Change a slider'],
    ['Shift+← →', 'Change it ten times finer'], ['?', 'Show these keys'],
];

/**
 * Builds the panel and connects keys, drops and the address. Call it after `applyShared`.
 * @param {PagePlayer} player
 * @param {HTMLElement} root the body of the page, which contains the stage
 * @param {{isBare: boolean, search: string}} options
 * @returns {{say: (message: string) => void}} shows a message to the user
 */
export function buildControls(player, root, { isBare, search }) {
    const { isTransparent } = readShared(search, '');
    root.classList.toggle('bare', isBare);
    root.classList.toggle('transparent', isTransparent);
    const messages = makeMessages();
    const history = new EditHistory(player);
    const say = isBare ? () => {} : messages.say;
    const actions = new PageActions(player, history, root, say);
    const stage = player.canvas.parentElement || root;
    followAddress(player, history, actions, isBare);
    listenForOrbit(player, history);
    if (isBare) {
        window.addEventListener('pointerdown', () => {
            if (player.state.needsClick) player.startSound().catch(() => {});
        });
        return { say };
    }
    const panel = makeControlPanel(player, history, root, actions);
    const start = makeTextButton('Click to start the sound',
        () => actions.attempt(() => player.startSound()));
    start.id = 'start-sound';
    const update = oncePerFrame(() => {
        start.hidden = !player.state.needsClick;
        panel.update();
    });
    for (const type of ['values', 'signal', 'source', 'notes', 'state'])
        player.addEventListener(type, update);
    stage.append(start, messages.element, makeDropTarget(player, actions));
    root.append(panel.element);
    listenForKeys(player, root, actions, panel);
    hideIdlePointer(root);
    update();
    return { say };
}

/**
 * The panel and its button to show it.
 * @param {PagePlayer} player
 * @param {EditHistory} history
 * @param {HTMLElement} root
 * @param {PageActions} actions
 * @returns {ControlPanel}
 */
function makeControlPanel(player, history, root, actions) {
    const { name } = player.description;
    const pause = makeIconButton('pause', 'Pause (Space)', () => actions.togglePause());
    const status = makeElement('small');
    const hide = makeIconButton('close', 'Hide panel (H)', () => toggle());
    const show = makeIconButton('panel', 'Show panel (H)', () => toggle(), 'show-panel');
    const fullScreen = makeIconButton('full', 'Full screen (F)', () => actions.toggleFullScreen());
    fullScreen.hidden = !document.fullscreenEnabled;
    const undo = makeIconButton('undo', 'Undo (Ctrl+Z)', () => history.undo());
    const redo = makeIconButton('redo', 'Redo (Ctrl+Shift+Z)', () => history.redo());
    const parameters = makeParameterList(player, history, actions);
    const media = makeMediaSection(player, history, actions);
    const notes = makeNotes(player);
    const search = makeElement('input',
        { type: 'search', placeholder: 'Search', 'aria-label': 'Search parameters' });
    search.oninput = () => parameters.search(search.value);
    const panel = makeElement('aside', { id: 'panel', 'aria-label': 'Controls' },
        makeElement('header', {}, makeElement('div', { className: 'title' },
            makeElement('h1', { title: name }, name), status),
        pause, makeIconButton('restart', 'Restart (R)', () => player.restart()),
        makeIconButton('picture', 'Save screenshot (S)', () => actions.saveScreenshot()),
        fullScreen,
        makeIconButton('help', 'Keys (?)', () => showKeys(root, keyTexts), 'keys'), hide),
        makeElement('div', { className: 'tools' }, search, undo, redo,
            makeTextButton('Reset all', () => actions.resetAll())),
        makeElement('div', { className: 'body' }, notes.element, ...(media ? [media.element] : []),
            parameters.element, makeAbout(player)),
        makeElement('footer', {},
            makeTextButton('Copy link',
                () => actions.copy('Copy link', pageLink(player), 'Link copied.')),
            makeTextButton('Copy preset', () => actions.copyPreset()),
            makeTextButton('Paste preset', () => actions.paste())));
    const toggle = () => {
        const hasFocus = root.contains(document.activeElement) && document.activeElement !== root;
        panel.hidden = root.classList.toggle('panel-hidden');
        if (hasFocus) (panel.hidden ? show : hide).focus();
    };
    root.append(show);
    const update = () => {
        const { framesPerSecond } = player.state;
        setIcon(pause, player.isPaused ? 'play' : 'pause',
            player.isPaused ? 'Continue (Space)' : 'Pause (Space)');
        status.textContent = player.isPaused ? 'Paused'
            : framesPerSecond ? `${Math.round(framesPerSecond)} fps` : '';
        undo.disabled = !history.past.length;
        redo.disabled = !history.future.length;
        parameters.update();
        notes.update();
        if (media) media.update();
    };
    return { element: panel, update, toggle, search };
}

/**
 * The address of the page with the current values.
 * @param {PagePlayer} player
 * @returns {string}
 */
function pageLink(player) {
    const { protocol, host, pathname, search } = window.location;
    const query = search.slice(1).split('&').filter((part) => !/^preset=|^$/.test(part)).join('&');
    const fragment = linkFragment(player);
    return `${protocol}//${host}${pathname}${query && `?${query}`}${fragment && `#${fragment}`}`;
}

/**
 * Writes changes into the address, and applies an address that the user edits.
 * @param {PagePlayer} player
 * @param {EditHistory} history
 * @param {PageActions} actions
 * @param {boolean} isBare the address is read only
 * @returns {void}
 */
function followAddress(player, history, actions, isBare) {
    let timer = 0;
    const write = () => {
        timer = 0;
        try {
            window.history.replaceState(null, '', pageLink(player));
        } catch {
            // A sandboxed page has no address of its own.
        }
    };
    const writeLater = () => {
        if (!timer) timer = window.setTimeout(write, linkDelay);
    };
    if (!isBare)
        for (const type of ['values', 'signal']) player.addEventListener(type, writeLater);
    window.addEventListener('hashchange', async () => {
        const shared = readShared('', window.location.hash);
        history.finish();
        history.edit('Link', () => actions.restoreExport());
        const notes = await applyShared(player, shared);
        history.finish();
        notes.forEach(actions.say);
    });
}

/**
 * A message over the picture while files are dragged over the page.
 * @param {PagePlayer} player
 * @param {PageActions} actions
 * @returns {HTMLElement}
 */
function makeDropTarget(player, actions) {
    const target = makeElement('div', { id: 'drop-target', hidden: true },
        makeElement('span', {}, dropHint(player)));
    const openFile = (/** @type {File} */ file) => actions.attempt(() =>
        openDroppedFile(player, file, (preset) => actions.openPreset(preset)));
    const hasFiles = (/** @type {DragEvent} */ event) =>
        !!event.dataTransfer && event.dataTransfer.types.includes('Files');
    window.addEventListener('dragover', (event) => {
        if (!hasFiles(event)) return;
        event.preventDefault();
        target.hidden = false;
    });
    window.addEventListener('dragleave', (event) => {
        if (!event.relatedTarget) target.hidden = true;
    });
    window.addEventListener('drop', (event) => {
        target.hidden = true;
        if (!event.dataTransfer || !hasFiles(event)) return;
        event.preventDefault();
        if (event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
    });
    document.addEventListener('paste', (event) => {
        const data = event.clipboardData;
        if (!data || isTextField(event.target)) return;
        event.preventDefault();
        if (data.files[0]) openFile(data.files[0]);
        else if (data.getData('text')) actions.pasteText(data.getData('text'));
    });
    return target;
}

/**
 * @param {EventTarget | null} target
 * @returns {boolean}
 */
function isTextField(target) {
    return target instanceof Element &&
        target.matches('[type=text], [type=search], textarea, select');
}

/**
 * @param {PagePlayer} player
 * @param {HTMLElement} root
 * @param {PageActions} actions
 * @param {ControlPanel} panel
 * @returns {void}
 */
function listenForKeys(player, root, actions, panel) {
    const readsKeyboard = player.description.passes
        .some((pass) => pass.inputs.some((input) => input.from === 'keyboard'));
    /** @type {Record<string, () => void>} */
    const keys = {
        h: panel.toggle, r: () => player.restart(), f: () => actions.toggleFullScreen(),
        s: () => actions.saveScreenshot(), ' ': () => actions.togglePause(),
        '?': () => showKeys(root, keyTexts),
        '/': () => {
            if (panel.element.hidden) panel.toggle();
            panel.search.focus();
        },
    };
    window.addEventListener('keydown', (event) => {
        const { target, altKey, ctrlKey, metaKey, shiftKey } = event;
        const key = event.key.toLowerCase();
        const isInPanel = target instanceof Element && panel.element.contains(target);
        if (key === 'escape' && isInPanel && isTextField(target)) return player.canvas.focus();
        if (isTextField(target) || altKey || document.querySelector('dialog[open]')) return;
        const isPressed = key === ' ' && target instanceof Element &&
            target.matches('button, summary, input[type=checkbox], input[type=color]');
        const isOfLook = readsKeyboard && !isInPanel;
        let action = isPressed || isOfLook || event.repeat ? undefined : keys[key];
        if (ctrlKey || metaKey) {
            const isRedo = key === 'y' || shiftKey;
            action = !/^[yz]$/.test(key) ? undefined
                : () => isRedo ? actions.history.redo() : actions.history.undo();
        }
        if (!action) return;
        event.preventDefault();
        action();
    });
}

/**
 * Marks the root as idle while the pointer rests, so that the style can hide it.
 * @param {HTMLElement} root
 * @returns {void}
 */
function hideIdlePointer(root) {
    let timer = 0;
    const wake = () => {
        root.classList.remove('idle');
        window.clearTimeout(timer);
        timer = window.setTimeout(() => root.classList.add('idle'), idleDelay);
    };
    for (const type of ['pointermove', 'pointerdown', 'keydown', 'focusin'])
        window.addEventListener(type, wake);
    wake();
}
