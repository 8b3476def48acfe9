// The texts' pictures. Two of one scene are laid on top of each other, with a slider that uncovers the second.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import sharp from 'sharp';
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

// ---- Files -----------------------------------------------------------------------------------

// What make() returns; kept in the folder `cache` under the hash of what it is made from.
async function kept(cache, from, make) {
    const hash = createHash('sha256');
    for (const one of from) hash.update(one).update('\0');
    const file = join(cache, hash.digest('hex').slice(0, 24));
    if (existsSync(file)) return readFileSync(file);
    const made = await make();
    mkdirSync(cache, { recursive: true });
    writeFileSync(file, made);
    return made;
}

// A picture as WebP, a quarter as large as PNG; of `crop`, only that part.
export const webp = (file, cache, crop) =>
    kept(cache, ['webp 88', readFileSync(file), JSON.stringify(crop ?? null)], () => {
        const picture = sharp(file);
        return (crop ? picture.extract(crop) : picture).webp({ quality: 88, smartSubsample: true }).toBuffer();
    });

// The picture that other sites show beside a link to the book.
export const card = (file, cache) =>
    kept(cache, ['card', readFileSync(file)], () => sharp(file).resize(1200, 630).jpeg({ quality: 85 }).toBuffer());

// Where two pictures differ, with a margin, as a part of the first. All of it if they differ nearly everywhere.
export async function differing(wrong, right, cache) {
    const { width, height } = sizeOf(wrong);
    const found = await kept(cache, ['differing', readFileSync(wrong), readFileSync(right)], async () => {
        const [a, b] = await Promise.all([wrong, right].map(file =>
            sharp(file).removeAlpha().resize(width, height, { fit: 'fill' }).blur(1).raw().toBuffer()));
        let [left, top, end, bottom] = [width, height, 0, 0];
        for (let y = 0; y < height; ++y)
            for (let x = 0; x < width; ++x) {
                const at = 3 * (y * width + x);
                if (Math.max(...[0, 1, 2].map(i => Math.abs(a[at + i] - b[at + i]))) < 24) continue;
                left = Math.min(left, x), end = Math.max(end, x + 1), top = Math.min(top, y), bottom = Math.max(bottom, y + 1);
            }
        const margin = Math.round(width / 20);
        [left, top] = [Math.max(0, left - margin), Math.max(0, top - margin)];
        [end, bottom] = [Math.min(width, end + margin), Math.min(height, bottom + margin)];
        const isPart = end > left && (end - left) * (bottom - top) < 0.7 * width * height;
        return JSON.stringify(isPart ? { left, top, width: end - left, height: bottom - top } : { left: 0, top: 0, width, height });
    });
    return JSON.parse(found);
}

// ---- In the page -----------------------------------------------------------------------------

export const img = ({ src, text, size }) =>
    `<img src="${src}" alt="${escape(text)}" width="${size.width}" height="${size.height}" loading="lazy">`;

// A plot of docs/plots is a part of the page: it has the page's colors, and its dots say their values.
export const plot = (svg, text) =>
    `<figure class="measured" aria-label="${escape(text)}"><div class="scroll">\n${svg}</div></figure>`;

// Without scripts, and in print, the two are side by side. The slider moves the line between them. A word, as HTML, says
// what each shows.
export function compared(left, right, named) {
    const words = named.map(word => `<span class="word">${word}</span>`).join('');
    return `<span class="compare"><span class="pair">${img(left)}<span class="over">${img({ ...right, size: left.size })}</span>` +
        `${words}</span><input type="range" min="0" max="100" value="50" aria-label="Where the first picture ends and the second begins"></span>`;
}
