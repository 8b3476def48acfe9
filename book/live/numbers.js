// Numbers as the figures write them, in the page and when the book is made.
'use strict';

const liveNumbers = (() => {
    const superscript = text => [...text].map(c => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('');
    const minus = text => text.replace('-', '−');
    function scientific(value) {
        if (value === 0 || !Number.isFinite(value)) return plain(value);
        const [digits, exponent] = value.toExponential(1).split('e');
        return `${minus(digits)}·10${superscript(exponent.replace('+', ''))}`;
    }
    function plain(value) {
        if (Number.isNaN(value)) return 'none';
        if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞';
        const size = Math.abs(value);
        if (size !== 0 && (size < 1e-4 || size >= 1e7)) return scientific(value);
        return minus(String(+value.toPrecision(4)));
    }
    function shown(value, how) {
        if (how === 'e') return scientific(value);
        if (how === '+') return (value >= 0 ? '+' : '') + plain(value);
        if (how.startsWith('.') && Number.isFinite(value))
            return minus(value.toFixed(+how.slice(1)).replace(/^-(?=[0.]*$)/, ''));  // no negative zero
        return plain(value);
    }
    return {
        // Words with {} where numbers belong: see Drawing in live.hpp.
        filled(words, values) {
            let next = 0;
            return words.replace(/\{(e|\+|\.\d+|)\}/g, (_, how) => shown(values[next++], how));
        },
        // A slider's value, with its unit. On a logarithmic slider it is the exponent of ten.
        named(value, { log, unit = '' }) {
            const number = log ? 10 ** value : value;
            return plain(number < 100 ? number : Math.round(number)) + unit;
        },
    };
})();
