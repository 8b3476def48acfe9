// Prints what a live figure shows as a drawing for docs/images, which stands in its place in print and without scripts:
// node book/live/still.mjs 00.memory [name=value ...] > docs/images/00-memory.svg
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { code, described, find, numbers } from '../live.mjs';
import { escape } from '../markdown.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = dirname(dirname(here));
const [, , name, ...settings] = process.argv;
if (!name || !find(name)) throw new Error(`no live figure has the name ${name}`);
const chapter = name.slice(0, 2), { controls } = find(name);
const chapters = JSON.parse(readFileSync(join(root, 'course.json'))).chapters
    .map(one => ({ ...one, number: one.name.slice(0, 2) }));
const set = new Map(settings.map(setting => setting.split('=')));

const imports = new Proxy({}, { get: () => new Proxy({}, { get: () => () => 0 }) });
const compiled = await code(chapter, chapters, join(root, 'out/book-cache'));
if (!compiled) throw new Error('emcc is missing');
const wasm = (await WebAssembly.instantiate(compiled, imports)).instance.exports;
wasm._initialize?.();
const width = 420, number = Object.keys(described.get(chapter)).indexOf(name.slice(3));
new Float64Array(wasm.memory.buffer, wasm.live_values(), controls.length)
    .set(controls.map(one => +(set.get(one.name) ?? one.value)));
wasm.live_draw(number, width, 1);
const list = new Float64Array(wasm.memory.buffer, wasm.live_list(number), wasm.live_list_size(number));
const words = Buffer.from(wasm.memory.buffer, wasm.live_words(number), wasm.live_words_size(number)).toString().split('\0');

// The page's colors on light paper, by their numbers in live.hpp.
const css = readFileSync(join(root, 'book/palette.css'), 'utf8');
const colors = ['paper', 'ink', 'muted', 'line', 'accent', 'c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'panel']
    .map(color => new RegExp(`--${color}: light-dark\\((#\\w+)`).exec(css)[1]);

const short = number => String(+number.toFixed(1));
const pairs = points => points.map(short).join(' ').replace(/(\S+ \S+) /g, '$1,');
const dashed = dash => (dash ? ` stroke-dasharray="${short(dash)}"` : '');
const draws = [
    ([pen, dash, ...points], color) => `<polyline points="${pairs(points)}" fill="none" stroke="${color}" ` +
        `stroke-width="${short(pen)}" stroke-linejoin="round" stroke-linecap="round"${dashed(dash)}/>`,
    (points, color) => `<polygon points="${pairs(points)}" fill="${color}"/>`,
    ([x, y, radius], color) => `<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" fill="${color}"/>`,
    ([pen, dash, x, y, radius], color) => `<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" fill="none" ` +
        `stroke="${color}" stroke-width="${short(pen)}"${dashed(dash)}/>`,
    ([x, y, align, size, bold, , text, ...values], color) =>
        `<text x="${short(x)}" y="${short(y + 0.35 * size)}" text-anchor="${['start', 'middle', 'end'][align]}" font-size="${short(size)}"` +
        `${bold === 1 ? ' font-weight="600"' : ''}${bold === 2 ? ' font-family="monospace"' : ''} fill="${color}">` +
        `${escape(numbers.filled(words[text], values))}</text>`,
];

const entries = [];
for (let at = 0; at < list.length; at += 2 + list[at + 1])
    entries.push({ op: list[at], color: list[at + 2], alpha: list[at + 3], numbers: [...list.subarray(at + 4, at + 2 + list[at + 1])] });
// Nothing can be dragged in a drawing: without the two circles of a handle's grip.
const isGrip = (entry, i) => [1, 2].some(later => entries[i + later]?.op === 5 && entries[i + later].numbers[2] > 0) &&
    entry.numbers.at(-1) === 9 && [2, 3].includes(entry.op);

console.log(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${Math.ceil(wasm.live_height(number))}" width="${width}" ` +
    `height="${Math.ceil(wasm.live_height(number))}" font-family="sans-serif">\n<rect width="100%" height="100%" fill="#fff"/>`);
entries.forEach((entry, i) => {
    const { op, color, alpha, numbers: own } = entry;
    if (!draws[op] || isGrip(entry, i)) return;
    const element = draws[op](own, color < 256 ? colors[color] : `#${(color - 256).toString(16).padStart(6, '0')}`);
    console.log(alpha < 1 ? element.replace(/^<\w+/, `$& opacity="${+alpha.toFixed(2)}"`) : element);
});
console.log('</svg>');
