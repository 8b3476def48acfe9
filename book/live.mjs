// The live figures: what course headers compute is compiled with Emscripten, one module a chapter, and drawn
// by the page. live/live.hpp says how to add a figure.
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { runInNewContext } from 'node:vm';
import { gzipSync } from 'node:zlib';
import { escape } from './markdown.mjs';
import { included } from './yours.mjs';

const here = join(dirname(fileURLToPath(import.meta.url)), 'live'), root = dirname(dirname(here));
const run = promisify(execFile);
const emcc = process.env.EMCC ?? 'emcc';

// For the number of each chapter that has figures: their descriptions by name.
export const described = new Map(readdirSync(here).filter(name => /^\d\d\.json$/.test(name)).sort()
    .map(name => [name.slice(0, 2), JSON.parse(readFileSync(join(here, name), 'utf8'))]));

// A script or a style sheet as the pages get it.
export const withoutComments = text => text.replace(/^\s*\/\/.*\n| {2}\/\/ .*|\/\*[^]*?\*\/\n?/gm, '').replace(/^\s+/gm, '');

// How figures write numbers.
export const numbers = runInNewContext(`${readFileSync(join(here, 'numbers.js'), 'utf8')}; liveNumbers`);

const pascal = name => name.replace(/(?:^|_)(\w)/g, (_, letter) => letter.toUpperCase());
export const find = name => described.get(name.slice(0, 2))?.[name.slice(3)];

// ---- In the page -----------------------------------------------------------------------------

function control(chapter, figure, { name, label, kind = 'range', options, ...rest }) {
    const id = `live-${chapter}-${figure}-${name}`.replaceAll('_', '-');
    const shared = `id="${id}" data-control="${name}"`;
    const text = escape(label);
    if (kind === 'choice')
        return `<label>${text} <select ${shared} autocomplete="off">${options.map((option, i) =>
            `<option value="${i}"${i === rest.value ? ' selected' : ''}>${escape(option)}</option>`).join('')}</select></label>`;
    if (kind === 'turns')
        return `<div class="turns" role="group" aria-label="${text}"><span>${text}</span><input type="number" hidden ${shared} ` +
            `value="${rest.value}" autocomplete="off">${[...options.entries(), ['', 'Back']].map(([value, option]) =>
                `<button type="button" data-turns="${name}" value="${value}">${escape(option)}</button>`).join('')}</div>`;
    const data = ['unit', 'play', 'log'].filter(key => rest[key] !== undefined)
        .map(key => ` data-${key}="${escape(String(rest[key]))}"`).join('');
    const slider = `<label>${text} <span class="value">${escape(numbers.named(Number(rest.value), rest))}</span><input type="range" ${shared} min="${rest.min}" ` +
        `max="${rest.max}" step="${rest.step}" value="${rest.value}"${data} autocomplete="off"></label>`;
    return slider + (rest.play ? `<button type="button" data-plays="${name}">Play</button>` : '');
}

// A live figure, in place of a still picture if there is one, which remains without scripts and in print.
// `first` is what it shows first, so that nothing moves when it comes to life: see live/measure.mjs.
export function figure(name, still, first) {
    const [chapter, own] = name.split('.'), { shows, try: attempt, controls } = find(name);
    const number = Object.keys(described.get(chapter)).indexOf(own);
    const { wide, narrow, said, samples } = { wide: 0.6, narrow: 0.8, said: '', samples: 0, ...first };
    return `<figure class="live${still ? '' : ' below'}" data-live="${name}" data-number="${number}" ` +
        `style="--aspect: ${(1 / wide).toFixed(3)}; --aspect-narrow: ${(1 / narrow).toFixed(3)}">` +
        `<div class="moving"><figcaption>${escape(attempt)}</figcaption>` +
        `<div class="stage">${still && `<div class="still">${still}</div>`}<canvas role="img" aria-label="${escape(shows)}"></canvas></div>` +
        `<div class="progress"${samples > 1 ? '' : ' hidden'}>0 of ${samples} samples per pixel</div>` +
        `<output class="said" aria-live="polite">${escape(said)}</output>` +
        `<form>${controls.map(one => control(chapter, own, one)).join('')}<button type="reset">Reset</button></form>` +
        '</div></figure>';
}

// ---- Compiled --------------------------------------------------------------------------------

// A struct of controls for each figure, and the source that joins the figures in a module.
function generated(chapter) {
    const figures = Object.entries(described.get(chapter));
    const structs = figures.map(([name, { controls }]) =>
        `struct ${pascal(name)}Controls {\n${controls.map(one =>
            `    double ${one.name} = ${Number(one.value)};`).join('\n')}\n};\n`);
    return {
        'controls.hpp': `#pragma once\nnamespace live {\n${structs.join('')}}  // namespace live\n`,
        'module.cpp': `#include "${chapter}.cpp"\n#include "host.hpp"\n` +
            `const live::Figure live_figures[] = {\n${figures.map(([name]) =>
                `    live::figure<live::${pascal(name)}Controls>(),\n`).join('')}};\n` +
            `const int live_count = ${figures.length};\n`,
    };
}

// The folders of what a chapter gives: its own, and those of several kinds of headers in it.
function given(name) {
    const own = join(root, 'chapters', name);
    const kinds = readdirSync(own).filter(kind => existsSync(join(own, kind, 'rt'))).map(kind => join(own, kind));
    return [own, ...kinds];
}

// The include folders of a chapter's figures, in the order of its program's.
export function folders(chapter, chapters, first) {
    const upTo = chapters.filter(one => one.number <= chapter).reverse();
    return [...(first ? [first] : []),
            ...upTo.flatMap(one => [...given(one.name), join(root, 'solutions', one.name)]), join(root, 'common')];
}

// The wide trees, from chapter 07 on, are twice as fast with SIMD, and give the same bits. Without -fno-slp-vectorize,
// Emscripten 3.1 packs numbers of unrelated statements wrongly: a variance of 11.adaptive became NaN.
const flags = ['-std=c++20', '-O2', '-msimd128', '-fno-slp-vectorize', '-ffp-contract=off', '-Wall', '-Wextra', '-include', join(here, 'missing.hpp')];
// Linked for size, which pages count: the loops that take time have been compiled before, and stay as fast.
const linked = ['-Oz', '-sMALLOC=emmalloc', '-sSTANDALONE_WASM', '--no-entry', '-sALLOW_MEMORY_GROWTH=1'];

// The sources that a person wrote for a chapter's figures. The second, if there is one, is compiled in float.
export const written = chapter =>
    [`${chapter}.cpp`, `${chapter}.float.cpp`].map(name => join(here, name)).filter(existsSync);

// What compiling a chapter's figures takes, also by another compiler: see live/native.mjs.
export const sources = (chapter, chapters, first) => ({
    generated: generated(chapter), float: written(chapter)[1],
    include: folders(chapter, chapters, first).flatMap(folder => ['-I', folder]),
});

// Writes a file of the cache, and of the older ones of its chapter keeps only the three newest.
function keep(file, content) {
    const cache = dirname(file), chapter = basename(file).slice(0, 3);
    mkdirSync(cache, { recursive: true });
    writeFileSync(file, content);
    const old = readdirSync(cache).filter(name => name.startsWith(chapter) && name.endsWith('.wasm'))
        .sort((a, b) => statSync(join(cache, b)).mtimeMs - statSync(join(cache, a)).mtimeMs);
    for (const name of old.slice(4)) for (const one of [name, `${name}.json`]) rmSync(join(cache, one), { force: true });
}

// The file of a chapter's compiled figures.
async function compile(chapter, chapters, first, cache) {
    const { generated: made, float, include } = sources(chapter, chapters, first);
    const hash = createHash('sha256').update(JSON.stringify([version, flags, linked, made]));
    const own = [...written(chapter), join(here, 'host.hpp'), join(here, 'missing.hpp')], paths = folders(chapter, chapters, first);
    for (const file of new Set(own.flatMap(one => [one, ...included(one, [here, ...paths])])))
        hash.update(basename(file)).update('\0').update(readFileSync(file));
    const kept = join(cache, `${chapter}-${hash.digest('hex').slice(0, 16)}.wasm`);
    if (existsSync(kept)) return kept;

    const folder = mkdtempSync(join(tmpdir(), 'live-'));
    try {
        for (const [name, text] of Object.entries(made)) writeFileSync(join(folder, name), text);
        const common = [...flags, '-I', here, '-I', folder, ...include];
        const objects = [[join(folder, 'module.cpp'), []],
                         ...(float ? [[float, ['-DRT_REAL=float', '-Drt=rt_float']]] : [])];
        const compiled = await Promise.all(objects.map(async ([source, more], i) => {
            const to = join(folder, `${i}.o`);
            await run(emcc, [...common, ...more, '-c', source, '-o', to]);
            return to;
        }));
        const to = join(folder, 'module.wasm');
        await run(emcc, [...linked, ...compiled, '-o', to]);
        keep(kept, readFileSync(to));
        return kept;
    } catch (error) {
        throw new Error(`the live figures of chapter ${chapter} do not compile:\n` +
                        (error.stderr ?? error.message).replace(/^emcc: error: .*/gm, '').trim());
    } finally {
        rmSync(folder, { recursive: true, force: true });
    }
}

// What emcc calls itself; undefined if it is missing.
const version = await run(emcc, ['--version']).then(({ stdout }) => stdout.split('\n')[0], () => undefined);

// The compiled figures of a chapter; undefined without Emscripten.
export const code = async (chapter, chapters, cache, first) =>
    version && readFileSync(await compile(chapter, chapters, first, cache));

// What the figures of a compiled chapter show first. A learner's code may not return.
async function measured(chapter, kept) {
    const file = `${kept}.json`;
    if (!existsSync(file)) {
        const { stdout } = await run(process.execPath, [join(here, 'measure.mjs'), chapter, kept], { timeout: 60_000 });
        writeFileSync(file, stdout);
    }
    return JSON.parse(readFileSync(file, 'utf8'));
}

// For the number of each of these chapters: its module as a script for the pages, and what its figures show first;
// undefined without Emscripten. The learner's headers in the folder `first`, if there is one, come before the
// solution's. A chapter that does not compile with them is compiled without them, after a call of refused(chapter, error).
// asItIs(chapter) may name a folder with headers that fail, too: the page can run these on demand.
export async function modules(wanted, chapters, cache, first, refused, asItIs = () => undefined) {
    if (!version) return undefined;
    const worker = withoutComments(readFileSync(join(here, 'worker.js'), 'utf8'));
    const packed = kept => gzipSync(readFileSync(kept), { level: 9 }).toString('base64');
    const made = new Map(), waiting = [...wanted];
    const work = async () => {
        for (let chapter; (chapter = waiting.shift());) {
            let whose = first ? 'Your' : 'The';
            const kept = await compile(chapter, chapters, first, cache).catch(error => {
                if (!first) throw error;
                refused(chapter, error);
                whose = 'The';
                return compile(chapter, chapters, undefined, cache);
            });
            const failing = asItIs(chapter), alsoKept = failing && await compile(chapter, chapters, failing, cache)
                .catch(error => refused(chapter, error, failing));
            const script = `liveModule(${[chapter, worker, packed(kept), whose, ...(alsoKept ? [packed(alsoKept)] : [])]
                .map(one => JSON.stringify(one)).join(', ')});\n`;
            made.set(chapter, { script, runsAsItIs: Boolean(alsoKept), shown: await measured(chapter, kept).catch(() => ({})) });
        }
    };
    await Promise.all([work(), work()]);
    return made;
}

// What the page runs for its figures.
export const pageScript = () =>
    ['numbers.js', 'page.js'].map(name => withoutComments(readFileSync(join(here, name), 'utf8'))).join('\n');
