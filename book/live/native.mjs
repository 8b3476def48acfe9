// A live figure computes what the same code computes natively: node book/live/native.mjs. The mean light of the
// pictures of chapters 04 and 05, after one sample per pixel, must be the same to the last digit.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { code, described, sources } from '../live.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = dirname(dirname(here));
const chapters = JSON.parse(readFileSync(join(root, 'course.json'))).chapters
    .map(one => ({ ...one, number: one.name.slice(0, 2) }));
const compiler = process.env.CXX ?? 'c++';

for (const name of ['04.scene', '05.scene']) {
    const [chapter, own] = name.split('.');
    const number = Object.keys(described.get(chapter)).indexOf(own);
    const values = described.get(chapter)[own].controls.map(control => Number(control.value));

    const compiled = await code(chapter, chapters, join(root, 'out/book-cache'));
    if (!compiled) {
        console.log('skipped: live figures, which need Emscripten');
        break;
    }
    const imports = new Proxy({}, { get: () => new Proxy({}, { get: () => () => 0 }) });
    const wasm = (await WebAssembly.instantiate(compiled, imports)).instance.exports;
    wasm._initialize?.();
    new Float64Array(wasm.memory.buffer, wasm.live_values(), values.length).set(values);
    wasm.live_draw(number, 320, 1);
    while (wasm.live_done(number) === 0) wasm.live_more(number);
    const mean = wasm.live_mean(number);

    const folder = mkdtempSync(join(tmpdir(), 'live-'));
    try {
        const { generated, float, include } = sources(chapter, chapters);
        for (const [file, text] of Object.entries(generated)) writeFileSync(join(folder, file), text);
        writeFileSync(join(folder, 'main.cpp'), `#include "module.cpp"
#include <cstdio>
int main() {
    live::values = {${values.join()}};
    live_draw(${number}, 320, 1);
    while (live_done(${number}) == 0) live_more(${number});
    std::printf("%.17g", live_mean(${number}));
}
`);
        const program = join(folder, 'figure');
        const options = ['-std=c++20', '-O0', '-ffp-contract=off', '-I', here, '-I', folder, ...include];
        const object = join(folder, 'float.o');
        if (float) execFileSync(compiler, [...options, '-DRT_REAL=float', '-Drt=rt_float', '-c', float, '-o', object]);
        execFileSync(compiler, [...options, join(folder, 'main.cpp'), ...(float ? [object] : []), '-o', program]);
        assert.equal(Number(execFileSync(program, { encoding: 'utf8' })), mean, `${name}: native and in the page`);
    } finally {
        rmSync(folder, { recursive: true });
    }
    console.log(`live figure ${name}: the mean is ${mean}, natively as well`);
}
