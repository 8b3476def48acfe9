// Whose code a figure runs is found in what it includes, and how.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
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
assert.equal(whose(['01.2', '03.1']), 'These figures run your code of 01.2, 03.1; the rest is the solution’s.');
assert.match(whose([]), /the solution’s code: none of yours/);
assert.match(whose([], true), /the solution’s code: with yours they do not compile/);
console.log('whose code a figure runs: found');
