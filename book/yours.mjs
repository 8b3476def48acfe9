// Whose code a live figure runs, where the learner's headers come before the solution's.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

// The headers <rt/NAME.hpp> that a source includes, and that those include: NAME.hpp by where each is found first.
function headers(source, folders, found = new Map()) {
    for (const [, name] of readFileSync(source, 'utf8').matchAll(/^\s*#\s*include\s*<rt\/([\w.]+)>/gm)) {
        if (found.has(name)) continue;
        const folder = folders.find(one => existsSync(join(one, 'rt', name)));
        if (!folder) throw new Error(`${source} includes <rt/${name}>, which is in none of ${folders.join(', ')}`);
        found.set(name, folder);
        headers(join(folder, 'rt', name), folders, found);
    }
    return found;
}

// The exercises of these chapters whose answers in the folder `first` are compiled into the sources. An include
// folder `first` holds headers of the learner's that pass, and nothing else.
export function exercisesUsed(sources, folders, first, chapters) {
    const used = new Set(sources.flatMap(source => [...headers(source, folders)])
        .filter(([, folder]) => folder === first).map(([name]) => `rt/${name}`));
    return chapters.flatMap(chapter => chapter.exercises ?? [])
        .filter(({ files }) => files.some(file => used.has(file))).map(({ id }) => id);
}

// What a page with figures says of that.
export function whose(exercises) {
    if (!exercises.length) return 'These figures run the solution’s code: no answer of yours that they need passes yet.';
    return `These figures run your code of ${exercises.join(', ')}; the rest is the solution’s.`;
}
