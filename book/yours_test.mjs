// What a figure includes tells whose code it runs, and the contents tick what passes.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { layout } from './layout.mjs';
import { folders, written } from './live.mjs';
import { exercisesUsed, whose } from './yours.mjs';

const folder = mkdtempSync(join(tmpdir(), 'yours-'));
const put = (name, text) => {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
};
try {
    put('03.cpp', '#include "live.hpp"\n#include "scene.hpp"\n#  include <rt/hit.hpp>\n#include <vector>\n' +
        '// #include <rt/other.hpp>\n');
    put('live.hpp', '#include "live.hpp"\n');
    put('chapter/scene.hpp', '#include <rt/camera.hpp>\n');
    put('mine/rt/roots.hpp', '');
    put('mine/rt/other.hpp', '');
    put('mine/rt/camera.hpp', '#line 1 "/somewhere/camera.hpp"\n#include <rt/dot.hpp>\n');
    put('solutions/rt/hit.hpp', '#include <rt/roots.hpp>\n#include <rt/dot.hpp>\n');
    put('solutions/rt/roots.hpp', '#include <rt/other.hpp>\n');  // not found first
    put('solutions/rt/dot.hpp', '#include <rt/hit.hpp>\n');
    const chapters = [{}, { exercises: [
        { id: '01.1', files: ['rt/dot.hpp'] }, { id: '01.2', files: ['rt/camera.hpp', 'rt/none.hpp'] },
        { id: '03.1', files: ['rt/roots.hpp'] }, { id: '03.2', files: ['rt/hit.hpp'] },
        { id: '03.3', files: ['rt/other.hpp'] }] }];
    const first = join(folder, 'mine');
    assert.deepEqual(exercisesUsed([join(folder, '03.cpp')],
                                   [first, join(folder, 'solutions'), join(folder, 'chapter')], first, chapters),
                     ['01.2', '03.1']);
} finally {
    rmSync(folder, { recursive: true });
}

// The figures of chapter 03, for somebody who has the solution's answers to 03.1 to 03.4.
const root = dirname(dirname(fileURLToPath(import.meta.url)));
const { chapters } = JSON.parse(readFileSync(join(root, 'course.json')));
const numbered = chapters.map(chapter => ({ ...chapter, number: chapter.name.slice(0, 2) }));
const answers = join(root, 'solutions/03_sphere');
assert.deepEqual(exercisesUsed(written('03'), folders('03', numbered, answers), answers, chapters),
                 ['03.1', '03.2', '03.3']);

assert.equal(whose(['01.2', '03.1']), 'These figures run your code for 01.2, 03.1; the rest is the solution’s.');
assert.match(whose([]), /the solution’s code: none of your answers/);
assert.match(whose([], true), /the solution’s code: they do not compile with yours/);
assert.match(whose(['01.2'], false, '03.2'), /^These figures run your code for 01\.2; .* checked .*Your answer to 03\.2 as it is, though it fails/);
const page = { out: 'a.html', name: 'A', html: '<h1>A</h1><p>Words.</p>', headings: [
    { level: 3, id: 'first', text: '03.1 Roots (about 5 minutes)' }, { level: 3, id: 'second', text: '03.2 Sphere' }] };
const html = layout(page, { pages: [page], title: 'The course', passed: new Set(['03.1']), sourceOf: () => 'a.md' });
assert.match(html, /href="#first"><span class="tick"/);
assert.match(html, /href="#second">03\.2 Sphere</);

console.log('whose code a figure runs: found');
