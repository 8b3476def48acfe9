// The live figures: what course headers compute is compiled with Emscripten, one module a chapter, and drawn
// by the page. live/live.hpp says how to add a figure.
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { gzipSync } from 'node:zlib';
import { escape } from './markdown.mjs';

const here = join(dirname(fileURLToPath(import.meta.url)), 'live'), root = dirname(dirname(here));
const run = promisify(execFile);
const emcc = process.env.EMCC ?? 'emcc';

// For the number of each chapter that has figures: their descriptions by name.
export const described = new Map(readdirSync(here).filter(name => /^\d\d\.json$/.test(name)).sort()
    .map(name => [name.slice(0, 2), JSON.parse(readFileSync(join(here, name), 'utf8'))]));

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
    const data = ['unit', 'play', 'log'].filter(key => rest[key] !== undefined)
        .map(key => ` data-${key}="${escape(String(rest[key]))}"`).join('');
    const slider = `<label>${text} <span class="value"></span><input type="range" ${shared} min="${rest.min}" ` +
        `max="${rest.max}" step="${rest.step}" value="${rest.value}"${data} autocomplete="off"></label>`;
    return slider + (rest.play ? `<button type="button" data-plays="${name}">Play</button>` : '');
}

// A live figure in place of a still picture, or below it. The still picture remains without scripts, and in print.
export function figure(name, still, isBelow) {
    const [chapter, own] = name.split('.'), { shows, try: attempt, controls } = find(name);
    const number = Object.keys(described.get(chapter)).indexOf(own);
    return `<figure class="live${isBelow ? ' below' : ''}" data-live="${name}" data-number="${number}">` +
        (still && `<div class="still">${still}</div>`) +
        `<div class="moving"><div class="stage"><canvas role="img" aria-label="${escape(shows)}"></canvas></div>` +
        `<div class="progress" hidden></div><output class="said" aria-live="polite"></output>` +
        `<form>${controls.map(one => control(chapter, own, one)).join('')}<button type="reset">Reset</button></form>` +
        `<figcaption>${escape(attempt)}</figcaption></div></figure>`;
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

// The headers in a folder on the include path, and its sources, since figures include those of a program, too.
const headers = folder => [folder, ...['rt', 'app', 'study'].map(name => join(folder, name))].filter(existsSync).flatMap(one =>
    readdirSync(one).filter(name => /\.[ch]pp$/.test(name)).sort().map(name => join(one, name)));

// The include folders of a chapter's figures, in the order of its program's.
export function folders(chapter, chapters, first) {
    const upTo = chapters.filter(one => one.number <= chapter).reverse();
    return [...(first ? [first] : []),
            ...upTo.flatMap(one => ['chapters', 'solutions'].map(kind => join(root, kind, one.name))), join(root, 'common')];
}

// The wide trees, from chapter 07 on, are twice as fast with SIMD, and give the same bits.
const flags = ['-std=c++20', '-O2', '-msimd128', '-ffp-contract=off', '-Wall', '-Wextra', '-include', join(here, 'missing.hpp')];
const linked = ['-sSTANDALONE_WASM', '--no-entry', '-sALLOW_MEMORY_GROWTH=1'];

// The sources that a person wrote for a chapter's figures. The second, if there is one, is compiled in float.
export const written = chapter =>
    [`${chapter}.cpp`, `${chapter}.float.cpp`].map(name => join(here, name)).filter(existsSync);

// What compiling a chapter's figures takes, also by another compiler: see live/native.mjs.
export const sources = (chapter, chapters, first) => ({
    generated: generated(chapter), float: written(chapter)[1],
    include: folders(chapter, chapters, first).flatMap(folder => ['-I', folder]),
});

async function compile(chapter, chapters, first, cache) {
    const { generated: made, float, include } = sources(chapter, chapters, first);
    const hash = createHash('sha256');
    hash.update(JSON.stringify([version, flags, linked, made]));
    const own = readdirSync(here).filter(name => name.endsWith('.hpp') || name.startsWith(chapter) && name.endsWith('.cpp'));
    for (const file of [...own.sort().map(name => join(here, name)), ...folders(chapter, chapters, first).flatMap(headers)])
        hash.update(basename(file)).update('\0').update(readFileSync(file));
    const kind = `${chapter}-${first ? 'first' : 'solution'}-`;
    const kept = join(cache, `${kind}${hash.digest('hex').slice(0, 16)}.wasm`);
    if (existsSync(kept)) return readFileSync(kept);

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
        await run(emcc, ['-O2', ...linked, ...compiled, '-o', to]);
        const code = readFileSync(to);
        mkdirSync(cache, { recursive: true });
        for (const old of readdirSync(cache)) if (old.startsWith(kind)) rmSync(join(cache, old), { force: true });
        writeFileSync(kept, code);
        return code;
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
export const code = (chapter, chapters, cache, first) => version && compile(chapter, chapters, first, cache);

// For the number of each of these chapters: its module, as a script for the pages; undefined without Emscripten. The
// learner's headers in the folder `first`, if there is one, come before the solution's. A chapter that does not
// compile with them is compiled without them, after a call of refused(chapter, error).
export async function modules(wanted, chapters, cache, first, refused) {
    if (!version) return undefined;
    const worker = readFileSync(join(here, 'worker.js'), 'utf8');
    const made = new Map(), waiting = [...wanted];
    const work = async () => {
        for (let chapter; (chapter = waiting.shift());) {
            const compiled = await compile(chapter, chapters, first, cache).catch(error => {
                if (!first) throw error;
                refused(chapter, error);
                return compile(chapter, chapters, undefined, cache);
            });
            const packed = gzipSync(compiled, { level: 9 });
            made.set(chapter, `liveModule(${JSON.stringify(chapter)}, ${JSON.stringify(worker)}, ` +
                `"${packed.toString('base64')}");\n`);
        }
    };
    await Promise.all([work(), work()]);
    return made;
}
