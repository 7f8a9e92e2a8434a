// The settings of a source picture, as in 'media/game.png,fit=integer,prescaled=2'.

/**
 * How a picture fits the picture that a look draws. 'stretch' fills it. 'whole' adds black borders.
 * 'crop' cuts off the excess. 'integer' scales by an integer and adds black borders.
 * @typedef {'stretch' | 'whole' | 'crop' | 'integer'} SourceFit
 */

/**
 * @typedef {object} SourceSettings
 * @property {string} content A file, or 'pattern:NAME' with its own settings.
 * @property {SourceFit} fit
 * @property {number} aspect Width / height of a pixel. Ignored when stretched.
 * @property {[number, number] | null} shape Width and height of the whole picture as displayed.
 *     Null: use `aspect`.
 * @property {number} prescaled Pixels per side that show one original pixel, 1 to 8. 0: detected.
 * @property {number} rate Pictures per second of a sequence or video. 0: its own, or 60.
 * @property {boolean} loops Restarts after the last picture. Otherwise that one stays.
 */

const sourceFits = ['stretch', 'whole', 'crop', 'integer'];
const largestSourceAspect = 16;
const largestSourceRate = 1000;
const largestPrescale = 8;

/**
 * The settings of a source without any in its text.
 * @param {string} content
 * @returns {SourceSettings}
 */
export function defaultSourceSettings(content) {
    return {
        content,
        fit: 'stretch',
        aspect: 1,
        shape: null,
        prescaled: 1,
        rate: 0,
        loops: true,
    };
}

/**
 * The settings that the program uses for a file that the user opens.
 * @param {string} content
 * @returns {SourceSettings}
 */
export function openedFileSettings(content) {
    return { ...defaultSourceSettings(content), fit: 'whole', prescaled: 0 };
}

/**
 * A decimal number, or NaN.
 * @param {string} text
 * @returns {number}
 */
function parsedSettingNumber(text) {
    const isDecimal = /^\+?-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text);
    const number = isDecimal ? Number(text.replace(/^\+/, '')) : NaN;
    return Number.isFinite(number) ? number : NaN;
}

/**
 * @param {string} setting
 * @param {string} word
 * @param {number} low
 * @param {number} high
 * @returns {number}
 */
function settingInRange(setting, word, low, high) {
    const number = parsedSettingNumber(word);
    if (!(number >= low && number <= high)) {
        throw new Error(`'${setting}': expected a number from ${low} to ${high}`);
    }
    return number;
}

/**
 * @param {string} setting
 * @param {string} word
 * @returns {[number, number] | null}
 */
function parsedShape(setting, word) {
    if (word === 'square') {
        return null;
    }
    const colon = word.indexOf(':');
    const width = parsedSettingNumber(colon < 0 ? word : word.slice(0, colon));
    const height = parsedSettingNumber(colon < 0 ? '' : word.slice(colon + 1));
    const isRatio = width > 0 && height > 0 && width / height <= largestSourceAspect &&
        height / width <= largestSourceAspect;
    if (!isRatio) {
        throw new Error(`'${setting}': expected 'square' or a ratio such as 4:3`);
    }
    return [width, height];
}

/**
 * @param {string} setting
 * @param {string} word
 * @returns {number}
 */
function parsedPrescale(setting, word) {
    if (word === 'auto') {
        return 0;
    }
    const times = /^\+?\d+$/.test(word) ? Number(word) : 0;
    if (times < 1 || times > largestPrescale) {
        throw new Error(
            `'${setting}': expected 'auto' or a whole number from 1 to ${largestPrescale}`);
    }
    return times;
}

/**
 * @param {string} setting
 * @param {string} word
 * @returns {boolean}
 */
function parsedLoop(setting, word) {
    if (word !== 'on' && word !== 'off') {
        throw new Error(`'${setting}': expected 'on' or 'off'`);
    }
    return word === 'on';
}

/**
 * @param {string} word
 * @returns {SourceFit}
 */
function parsedFit(word) {
    if (!sourceFits.includes(word)) {
        throw new Error(`unknown fit '${word}'; use one of: ${sourceFits.join(', ')}`);
    }
    return /** @type {SourceFit} */ (word);
}

/**
 * The part of the settings in one piece of a text. Null: the piece is not a setting.
 * @param {string} setting
 * @returns {Partial<SourceSettings> | null}
 */
function parsedSourceSetting(setting) {
    const equals = setting.indexOf('=');
    if (equals < 0) {
        return null;
    }
    const word = setting.slice(equals + 1);
    switch (setting.slice(0, equals)) {
        case 'aspect':
            return { aspect: settingInRange(
                setting, word, 1 / largestSourceAspect, largestSourceAspect) };
        case 'shape':
            return { shape: parsedShape(setting, word) };
        case 'prescaled':
            return { prescaled: parsedPrescale(setting, word) };
        case 'rate':
            return { rate: settingInRange(setting, word, 0, largestSourceRate) };
        case 'loop':
            return { loops: parsedLoop(setting, word) };
        case 'fit':
            return { fit: parsedFit(word) };
        default:
            return null;
    }
}

/**
 * Parses a source with settings at its end. All text before them, commas included, is the content.
 * Throws an Error with a message for the user.
 * @param {string} text
 * @param {SourceSettings} [usual] Settings that the text does not contain.
 * @returns {SourceSettings}
 */
export function parseSource(text, usual = defaultSourceSettings('')) {
    const settings = { ...usual };
    const pieces = text.split(',');
    /** @type {string[]} */
    const own = [];  // settings of a pattern itself
    // From the end, so the first of two equal settings wins.
    while (pieces.length > 1) {
        const last = pieces[pieces.length - 1];
        const parsed = parsedSourceSetting(last);
        if (!parsed && !text.startsWith('pattern:')) {
            break;
        }
        if (parsed) {
            Object.assign(settings, parsed);
        } else {
            own.unshift(last);
        }
        pieces.pop();
    }
    settings.content = pieces.concat(own).join(',');
    if (settings.content === '') {
        throw new Error('a source must be a file or pattern:NAME');
    }
    if (settings.shape && settings.aspect !== 1) {
        throw new Error("a source can have 'aspect' or 'shape', not both");
    }
    return settings;
}

/**
 * Width / height of a pixel of the source.
 * @param {SourceSettings} settings
 * @param {{width: number, height: number}} picture
 * @returns {number}
 */
export function sourcePixelAspect(settings, picture) {
    const { width, height } = picture;
    if (!settings.shape || width <= 0 || height <= 0) {
        return settings.aspect;
    }
    return settings.shape[0] / settings.shape[1] * height / width;
}
