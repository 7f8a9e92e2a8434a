// Expressions of sizes and conditions, docs/look-format.md.

/** @type {Object<string, (a: number) => number>} */
const expressionFunctions = {
    abs: Math.abs,
    ceil: Math.ceil,
    finite: (a) => (Number.isFinite(a) ? a : 0),
    floor: Math.floor,
    log: Math.log,
    log2: Math.log2,
    // Halves are rounded away from zero.
    round: (a) => Math.sign(a) * Math.floor(Math.abs(a) + 0.5),
    sqrt: Math.sqrt,
};

/** @type {Object<string, (a: number, b: number) => number>} */
const expressionPairs = { max: Math.max, min: Math.min, pow: Math.pow };

/** @type {Object<string, (a: number, b: number) => number>} */
const expressionOperators = {
    '||': (a, b) => (a !== 0 || b !== 0 ? 1 : 0),
    '&&': (a, b) => (a !== 0 && b !== 0 ? 1 : 0),
    '<=': (a, b) => (a <= b ? 1 : 0),
    '>=': (a, b) => (a >= b ? 1 : 0),
    '==': (a, b) => (a === b ? 1 : 0),
    '!=': (a, b) => (a !== b ? 1 : 0),
    '<': (a, b) => (a < b ? 1 : 0),
    '>': (a, b) => (a > b ? 1 : 0),
    '+': (a, b) => a + b,
    '-': (a, b) => a - b,
    '*': (a, b) => a * b,
    '/': (a, b) => a / b,
    '%': (a, b) => a % b,
};

// From the weakest to the strongest. A comparison is not repeated.
const expressionLevels = [
    { operators: ['||'], repeats: true },
    { operators: ['&&'], repeats: true },
    { operators: ['<=', '>=', '==', '!=', '<', '>'], repeats: false },
    { operators: ['+', '-'], repeats: true },
    { operators: ['*', '/', '%'], repeats: true },
];

class ExpressionReader {
    /**
     * @param {string} text
     * @param {(name: string) => number|undefined} valueOf
     */
    constructor(text, valueOf) {
        /** @type {string[]} */
        this.tokens =
            text.match(/\$?[A-Za-z_]\w*(?:\.\w+)?|[\d.]+|\|\||&&|[<>=!]=|[-+*/%()<>!?:,]|\S/g) || [];
        this.valueOf = valueOf;
        this.at = 0;
        this.text = text;
    }

    /** @returns {number} */
    read() {
        const value = this.choice();
        if (this.at < this.tokens.length || !Number.isFinite(value))
            throw new Error(`The expression '${this.text}' can't be evaluated.`);
        return value;
    }

    /** @param {string} token */
    accept(token) {
        const found = this.tokens[this.at] === token;
        this.at += found ? 1 : 0;
        return found;
    }

    /** @returns {number} */
    choice() {
        const condition = this.level(0);
        if (!this.accept('?'))
            return condition;
        const yes = this.choice();
        this.accept(':');
        const no = this.choice();
        return condition !== 0 ? yes : no;
    }

    /**
     * @param {number} index
     * @returns {number}
     */
    level(index) {
        if (index === expressionLevels.length)
            return this.factor();
        const { operators, repeats } = expressionLevels[index];
        let value = this.level(index + 1);
        while (operators.includes(this.tokens[this.at])) {
            const operator = this.tokens[this.at++];
            value = expressionOperators[operator](value, this.level(index + 1));
            if (!repeats)
                break;
        }
        return value;
    }

    /** @returns {number} */
    factor() {
        if (this.accept('-'))
            return -this.factor();
        if (this.accept('!'))
            return this.factor() === 0 ? 1 : 0;
        return this.atom();
    }

    /** @returns {number} */
    atom() {
        if (this.accept('(')) {
            const value = this.choice();
            this.accept(')');
            return value;
        }
        const token = this.tokens[this.at++] || '';
        if (token.startsWith('$')) {
            const value = this.valueOf(token.slice(1));
            return value === undefined ? NaN : value;
        }
        return /^[A-Za-z]/.test(token) ? this.call(token) : Number(token || NaN);
    }

    /**
     * @param {string} name
     * @returns {number}
     */
    call(name) {
        this.accept('(');
        const a = this.choice();
        const pair = name in expressionPairs ? expressionPairs[name] : null;
        const b = pair && this.accept(',') ? this.choice() : 0;
        this.accept(')');
        if (pair)
            return pair(a, b);
        return name in expressionFunctions ? expressionFunctions[name](a) : NaN;
    }
}

/**
 * The value of an expression. Throws if it has none.
 * @param {string} text
 * @param {(name: string) => number|undefined} valueOf value of `$name` or `$name.x`
 * @returns {number}
 */
export function evaluateExpression(text, valueOf) {
    return new ExpressionReader(text, valueOf).read();
}
