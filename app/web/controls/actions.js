// What the buttons and keys of the page do.

import { makeElement } from './element.js';
import { openTextDialog } from './messages.js';
import { exportedNumbers, isAdjustable } from './parameter_text.js';
import { applyPreset, lookId, presetLine, presetOf, readPreset } from './preset_line.js';

/** @typedef {import('./edit_history.js').ControlledPlayer} ActionPlayer */
/** @typedef {import('./edit_history.js').EditHistory} ActionHistory */
/** @typedef {import('./preset_line.js').SharedPreset} ActionPreset */

/** The actions of the panel. Errors become messages. */
export class PageActions {
    /**
     * @param {ActionPlayer} player
     * @param {ActionHistory} history
     * @param {HTMLElement} root of dialogs
     * @param {(message: string) => void} say
     */
    constructor(player, history, root, say) {
        this.player = player;
        this.history = history;
        this.root = root;
        this.say = say;
    }

    /**
     * Calls a function. Its error becomes a message.
     * @param {() => Promise<void> | void} act
     * @returns {Promise<void>}
     */
    async attempt(act) {
        try {
            await act();
        } catch (error) {
            this.say(/** @type {Error} */ (error).message);
        }
    }

    /** @returns {void} */
    togglePause() {
        this.player.setPaused(!this.player.isPaused);
        this.player.dispatchEvent(new Event('state'));
    }

    /** @returns {void} */
    toggleFullScreen() {
        const change = document.fullscreenElement ? document.exitFullscreen()
            : document.documentElement.requestFullscreen();
        change.catch(() => this.say('The browser refused full screen. Use its own menu.'));
    }

    /** @returns {Promise<void>} */
    saveScreenshot() {
        return this.attempt(async () => {
            const url = URL.createObjectURL(await this.player.screenshot());
            makeElement('a', { href: url, download: `${lookId(this.player)}.png` }).click();
            setTimeout(() => URL.revokeObjectURL(url), 60000);
            this.say('Screenshot downloaded.');
        });
    }

    /**
     * Sets the values and the signal of the export. Files stay.
     * @returns {void}
     */
    restoreExport() {
        const { parameters, signal } = this.player.description;
        for (const parameter of parameters.filter(isAdjustable))
            this.player.setValue(parameter.name, exportedNumbers(parameter));
        if (signal && JSON.stringify(signal) !== JSON.stringify(this.player.signal))
            this.player.resetSource();
    }

    /** @returns {void} */
    resetAll() {
        this.history.step('Reset all', () => this.restoreExport());
    }

    /**
     * @param {string} title
     * @param {string} text
     * @param {string} done
     * @returns {Promise<void>}
     */
    async copy(title, text, done) {
        try {
            await navigator.clipboard.writeText(text);
            this.say(done);
        } catch {
            openTextDialog(this.root, title, text);
        }
    }

    /** @returns {Promise<void>} */
    copyPreset() {
        return this.attempt(async () => {
            const line = await presetLine(presetOf(this.player));
            await this.copy('Copy preset', line, 'Preset copied. Paste it in Afterglow or here.');
        });
    }

    /** @returns {Promise<void>} */
    async paste() {
        let text = '';
        try {
            text = await navigator.clipboard.readText();
        } catch {
            // The user pastes it into the dialog.
        }
        if (/^\s*(afterglow:|\{)/.test(text)) this.pasteText(text);
        else openTextDialog(this.root, 'Paste preset', '', (typed) => this.pasteText(typed));
    }

    /**
     * @param {string} text a share line, or the JSON of a preset
     * @returns {Promise<void>}
     */
    pasteText(text) {
        return this.attempt(async () => this.openPreset(await readPreset(text)));
    }

    /**
     * @param {ActionPreset} preset
     * @returns {void}
     */
    openPreset(preset) {
        /** @type {string[]} */
        let notes = [];
        this.history.step('Preset', () => { notes = applyPreset(this.player, preset); });
        this.say(['Preset applied.', ...notes].join(' '));
    }
}
