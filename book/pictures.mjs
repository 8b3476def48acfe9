// The texts' pictures. Two of one scene are laid on top of each other, with a slider
// that uncovers the second.
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { escape } from './markdown.mjs';

// Width and height are in the header of a PNG file, and in an SVG's viewBox.
export function sizeOf(file) {
    const bytes = readFileSync(file);
    if (file.endsWith('.png')) return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
    const [, width, height] = /viewBox="\S+ \S+ (\S+) (\S+)"/.exec(bytes);
    return { width: +width, height: +height };
}

const sameShape = (a, b) => Math.abs(a.width * b.height - b.width * a.height) <= a.width + b.width;

// The right picture for comparison with a mistake's: the chapter's scene alone if its figure holds more than
// that, else the chapter's picture. None if the mistake's picture shows something else, such as a part.
export function rightPicture(file, chapter) {
    if (!/-mistake-/.test(file) || file.endsWith('01-mistake-not_normalized.png')) return undefined;
    const scene = join(dirname(file), `${chapter.number}-scene.png`);
    const right = existsSync(scene) ? scene : join(dirname(file), `${chapter.name}.png`);
    return sameShape(sizeOf(file), sizeOf(right)) ? right : undefined;
}

export const img = ({ src, text, size }) =>
    `<img src="${src}" alt="${escape(text)}" width="${size.width}" height="${size.height}" loading="lazy">`;

// A plot of docs/plots is a part of the page: it has the page's colors, and its dots say their values.
export const plot = (svg, text) =>
    `<figure class="measured" aria-label="${escape(text)}"><div class="scroll">\n${svg}</div></figure>`;

// Without scripts, and in print, the two are side by side.
export function compared(left, right) {
    return `<span class="compare">${img(left)}<span class="over">${img({ ...right, size: left.size })}</span>` +
        `<input type="range" min="0" max="100" value="50" aria-label="How much you see of the right picture">` +
        `</span>`;
}
