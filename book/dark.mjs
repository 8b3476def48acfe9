// Gives each drawing of docs/images colors for dark pages, those that it has in the book: a style of its own, made from the
// colors that it names. Run it after each change of a drawing:
// node book/dark.mjs
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inPage, ownStyle } from './colors.mjs';

const root = dirname(dirname(fileURLToPath(import.meta.url))), folder = join(root, 'docs/images');
const palette = Object.fromEntries([...readFileSync(join(root, 'book/palette.css'), 'utf8')
    .matchAll(/--(\w+): light-dark\(#\w+, #(\w+)\)/g)].map(([, name, hex]) => [name, hex]));

const linear = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const shown = c => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
const times = (matrix, vector) => matrix.map(row => row.reduce((sum, a, i) => sum + a * vector[i], 0));

// Oklab: https://bottosson.github.io/posts/oklab/
const toCones = [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
    [0.0883024619, 0.2817188376, 0.6299787005]];
const toLab = [[0.2104542553, 0.793617785, -0.0040720468], [1.9779984951, -2.428592205, 0.4505937099],
    [0.0259040371, 0.7827717662, -0.808675766]];
const fromLab = [[1, 0.3963377774, 0.2158037573], [1, -0.1055613458, -0.0638541728], [1, -0.0894841775, -1.291485548]];
const fromCones = [[4.0767416621, -3.3077115913, 0.2309699292], [-1.2684380046, 2.6097574011, -0.3413193965],
    [-0.0041960863, -0.7034186147, 1.707614701]];
const lab = hex => times(toLab, times(toCones, (hex.length === 3 ? [...hex].map(c => c + c) : hex.match(/../g))
    .map(pair => linear(parseInt(pair, 16) / 255))).map(Math.cbrt));
const hexOf = color => '#' + times(fromCones, times(fromLab, color).map(c => c ** 3)).map(c =>
    Math.round(255 * Math.min(1, Math.max(0, shown(Math.max(0, c))))).toString(16).padStart(2, '0')).join('');

// A color that CSS knows, var(--NAME) or a mixture of two such, as a plain one on a dark page.
function onDark(css) {
    const [name, base] = [...css.matchAll(/var\(--(\w+)\)/g)].map(found => found[1]), part = +(/(\d+)%/.exec(css)?.[1] ?? 100) / 100;
    const [a, b] = [lab(palette[name]), lab(palette[base ?? name])];
    return hexOf(a.map((x, i) => part * x + (1 - part) * b[i]));
}

// The style, with a rule for each color of each kind of element.
function styleOf(svg) {
    const rules = new Map();
    for (const [, tag, rest] of svg.matchAll(/<(\w+)([^>]*)>/g))
        for (const [, what, hex] of rest.matchAll(/(fill|stroke|stop-color)="(#[0-9a-fA-F]+)"/g)) {
            const isWords = /^t(ext|span)$/.test(tag) || rest.includes('text-anchor');
            const selector = `${tag}${isWords && !/^t/.test(tag) ? '[text-anchor]' : ''}[${what}="${hex}"]`;
            rules.set(selector, `${selector}{${what}:${onDark(inPage(hex, tag, what === 'fill', isWords))}}`);
        }
    return `<style>@media(prefers-color-scheme:dark){svg{fill:${'#' + palette.ink}}${[...rules.keys()].sort().map(key => rules.get(key)).join('')}}</style>`;
}

for (const name of readdirSync(folder).filter(name => name.endsWith('.svg'))) {
    const file = join(folder, name), old = readFileSync(file, 'utf8'), plain = old.replace(ownStyle, '');
    const end = plain.indexOf('>', plain.indexOf('<svg')) + 1;
    const made = `${plain.slice(0, end)}\n${styleOf(plain)}${plain.slice(end)}`;
    if (made !== old) {
        writeFileSync(file, made);
        console.log(`docs/images/${name} has new colors for dark pages`);
    }
}
