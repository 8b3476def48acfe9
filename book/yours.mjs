// Whose code the live figures run if the learner's headers come before the solution's.
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

// The files of the course that a source includes, directly or through others, as a compiler with these include
// folders finds them.
export function included(source, folders, found = new Set()) {
    for (const [, kind, name] of readFileSync(source, 'utf8').matchAll(/^\s*#\s*include\s*([<"])([\w./]+)[>"]/gm)) {
        const file = [...(kind === '"' ? [dirname(source)] : []), ...folders]
            .map(folder => join(folder, name)).find(existsSync);
        if (!file || found.has(file)) continue;  // of the standard library, or seen before
        found.add(file);
        included(file, folders, found);
    }
    return found;
}

// The exercises of these chapters whose answers in the folder `first` the sources include. That folder holds those of
// the learner's headers that pass, and nothing else.
export function exercisesUsed(sources, folders, first, chapters) {
    const files = new Set(sources.flatMap(source => [...included(source, folders)]));
    return chapters.flatMap(chapter => chapter.exercises ?? [])
        .filter(exercise => exercise.files.some(file => files.has(join(first, file)))).map(({ id }) => id);
}

// What a page with figures says about it; `refused` if they do not compile with the learner's headers. With a switch,
// they also run the exercise `failing`.
export function whose(ids, refused = false, failing = undefined) {
    const said = ids.length > 0 ? `These figures run your code for ${ids.join(', ')}; the rest is the solution’s.`
        : 'These figures run the solution’s code: ' +
          (refused ? 'they do not compile with yours.' : 'none of your answers that they need passes yet.');
    return failing ? `${said} <label class="as-it-is"><input type="checkbox" checked autocomplete="off"> ` +
        `Your answer to ${failing} as it is, though it fails</label>` : said;
}
