// Makes the web book from docs/ and course.json: node book/build.mjs [FOLDER], out/book if no folder is named.
//     --first HEADERS  the live figures use the headers of this folder before the solution's; its file passed.txt, if
//                      there is one, names the exercises that pass, which are ticked; if there is a failing.txt, it names
//                      one that fails, whose headers, in the folder as_it_is beside the others, the figures run on demand
//     --url URL        where the book is going to be: for the sitemap, and for other sites that show a link to it
//     --source URL     where the files of the course can be read: for the links to a page's source
// Every page works from a folder, without a server, and under any path on one: all links are relative.
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join, normalize, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import subsetFont from 'subset-font';
import { escape, mathLetters, render, typographic } from './markdown.mjs';
import { described, figure, find, folders, modules, pageScript, withoutComments, written } from './live.mjs';
import { layout } from './layout.mjs';
import { mistakesPage } from './mistakes.mjs';
import { drawing } from './colors.mjs';
import { card, compared, differing, img, plot, rightPicture, sizeOf, webp } from './pictures.mjs';
import { exercisesUsed, whose } from './yours.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = dirname(here);
const { values: options, positionals } =
    parseArgs({ options: { first: { type: 'string' }, url: { type: 'string' }, source: { type: 'string' } },
                allowPositionals: true });
const out = resolve(positionals[0] ?? join(root, 'out/book'));
const read = file => readFileSync(join(root, file), 'utf8');
// Windows has backslashes in paths.
const slashed = path => path.replaceAll('\\', '/');
const packaged = name => slashed(createRequire(import.meta.url).resolve(name));

// ---- The pages, in reading order -------------------------------------------------------------

const chapters = JSON.parse(read('course.json')).chapters
    .map(chapter => ({ ...chapter, number: chapter.name.slice(0, 2) }));

// The plots of a chapter, in the order of its table.
function plotsOf({ name }) {
    const table = `docs/studies/${name}.csv`;
    if (!existsSync(join(root, table))) return [];
    const rows = read(table);
    return readdirSync(join(root, 'docs/plots')).filter(file => file.startsWith(`${name}-`)).map(file => {
        const svg = read(`docs/plots/${file}`), study = /data-study="(.*?)"/.exec(svg)[1];
        return { id: file.slice(name.length + 1, -4), study, svg };
    }).sort((a, b) => rows.indexOf(a.study) - rows.indexOf(b.study));
}

const titleOf = source => typographic(/^# (.*)/m.exec(read(source))[1]);
const pages = [
    { source: 'README.md', out: 'index.html', name: 'Begin here', group: 'The course' },
    { source: 'docs/README.md', out: 'map.html', name: titleOf('docs/README.md'), group: 'The course' },
];
for (const chapter of chapters) {
    const page = {
        source: chapter.text, out: basename(chapter.text, '.md') + '.html', chapter,
        name: `${chapter.number} ${chapter.title}`, group: chapter.core ? 'Chapters' : 'Electives',
    };
    const part = (kind, name, source) => pages.push({
        out: `${basename(chapter.text, '.md')}-${kind}.html`, chapter, kind, parent: page, group: page.group,
        name: `${chapter.number} ${name}`, source,
    });
    pages.push(page);
    if (existsSync(join(root, 'tests/mistakes', chapter.name))) part('mistakes', 'Known mistakes', chapter.text);
    if (plotsOf(chapter).length > 0) part('studies', 'Measured', `docs/studies/${chapter.name}.md`);
}
const listed = new Set(pages.map(page => page.source));
for (const file of readdirSync(join(root, 'docs')).filter(name => name.endsWith('.md')).sort())
    if (!listed.has(`docs/${file}`))
        pages.push({ source: `docs/${file}`, out: basename(file, '.md') + '.html', name: titleOf(`docs/${file}`),
                     group: 'Reference' });
pages.push({ source: 'docs/studies/README.md', out: 'studies.html', name: titleOf('docs/studies/README.md'),
             group: 'Reference' });
const pageOf = new Map(pages.filter(page => page.kind !== 'mistakes').map(page => [page.source, page]));

// ---- What becomes of links and pictures ------------------------------------------------------

// A copy of a file of the course, and its path as the pages see it.
const copied = new Map(), converted = new Map(), cache = join(root, 'out/book-cache');
const placeOf = file => file.startsWith('docs/') ? file.slice(5) : `files/${file}`;
function copy(file) {
    copied.set(placeOf(file), file);
    return placeOf(file);
}
// A picture as the pages have it; of `crop`, only that part.
function shown(file, crop) {
    const to = placeOf(file).replace(/\.png$/, crop ? `-${Object.values(crop).join('-')}.webp` : '.webp');
    converted.set(to, { file, crop });
    return to;
}

// ---- The live figures -------------------------------------------------------------------------

const first = options.first && resolve(options.first), withoutFirst = new Set();
const words = file => first && existsSync(join(first, file)) ? readFileSync(join(first, file), 'utf8').split(/\s+/).filter(Boolean) : [];
// An answer that fails runs in the first chapter whose figures use it: compiling them all takes a minute.
const [failing] = words('failing.txt'), asItIs = failing && join(first, 'as_it_is');
const failsIn = failing && [...described.keys()].find(chapter => exercisesOf(chapter, asItIs).includes(failing));
const compiled = await modules(
    described.keys(), chapters, join(root, 'out/book-cache'), first,
    (chapter, error, folder) => {
        if (folder !== asItIs) withoutFirst.add(chapter);
        console.log(`chapter ${chapter}: its figures ` +
            (folder === asItIs ? `cannot run ${failing} as it is` : 'run the solution\'s code') +
            ', because they do not compile with yours: ' +
            (/^.*\berror: .*/m.exec(error.message)?.[0] ?? error.message.split('\n')[0]).replace(root + '/', ''));
    },
    chapter => chapter === failsIn ? asItIs : undefined);

// Those that the texts show.
const liveFigures = new Set();

const figured = (word, picture) => `<figure>${picture}<figcaption>${word}</figcaption></figure>`;
const sameSize = (a, b) => JSON.stringify(sizeOf(a)) === JSON.stringify(sizeOf(b));

// The ways in which a page treats what its text names, relative to its source.
function resolver(source) {
    const file = href => slashed(normalize(join(dirname(source), href)));
    const existing = href => {
        if (!existsSync(join(root, file(href)))) throw new Error(`${source} names ${href}, which does not exist`);
        return file(href);
    };
    const described = (src, text, crop) =>
        ({ src: shown(existing(src), crop), text, size: crop ?? sizeOf(join(root, file(src))) });
    const chapter = chapters.find(one => one.text === source);
    const rightOf = src => {
        const right = chapter && rightPicture(join(root, file(src)), chapter);
        return right && { src: slashed(relative(dirname(source), relative(root, right))), text: 'As it should be' };
    };
    return {
        pageOf(name) {
            const page = pages.find(one => one.chapter?.number === name.slice(0, 2) && !one.parent);
            if (!page) throw new Error(`a graph names ${name}, which is no chapter`);
            return page.out;
        },
        link(href) {
            if (/^[a-z]+:|^#/.test(href)) return href;
            const [path, anchor] = href.split('#');
            const page = pageOf.get(file(path));
            if (!page && statSync(join(root, existing(path))).isDirectory()) return undefined;  // no page shows it
            return (page ? page.out : copy(existing(path))) + (anchor ? `#${anchor}` : '');
        },
        picture(src, text, beside, words) {
            if (file(src).startsWith('docs/plots/')) return plot(read(existing(src)), text);
            if (src.endsWith('.svg')) return drawing(read(existing(src)), escape(text));
            const right = beside ?? rightOf(src), image = described(src, text);
            return right ? compared(image, described(right.src, right.text),
                                    words?.length ? words : /-(mistake|plain)/.test(src) ? ['wrong', 'right'] : []) : img(image);
        },
        // The wrong picture and the right one, beside each other, where they differ.
        async pair(src, text, beside) {
            const right = beside ?? rightOf(src);
            if (!right) return img(described(src, text));
            const [a, b] = [src, right.src].map(one => join(root, file(one)));
            if (!sameSize(a, b)) return `<div class="wrong-right">${figured('wrong', img(described(src, text)))}` +
                `${figured('right', img(described(right.src, right.text)))}</div>`;
            const crop = await differing(a, b, cache);
            return `<div class="wrong-right">${figured('wrong', img(described(src, text, crop)))}` +
                `${figured('right', img(described(right.src, right.text, crop)))}</div>`;
        },
        live(name, still) {
            if (!find(name)) throw new Error(`no live figure has the name ${name}: see book/live`);
            if (liveFigures.has(name)) throw new Error(`the live figure ${name} occurs twice`);
            liveFigures.add(name);
            return figure(name, still, compiled?.get(name.slice(0, 2)).shown[name.slice(3)]);
        },
    };
}

// ---- Writing them ----------------------------------------------------------------------------

// What was measured and does not stand in the chapter; then the plots that this text does not show.
function studiesPage(page) {
    const { chapter, source } = page, hasText = existsSync(join(root, source));
    const text = hasText ? textPage(page)
        : { html: `<h1>Chapter ${chapter.number}, measured</h1>\n`, headings: [], sections: [] };
    text.html += `<p>Point at a value to read it. <code>./course study ${chapter.number}</code> measures all this on your
machine. The <a href="${copy(`docs/studies/${chapter.name}.csv`)}">table</a> has every figure.</p>\n`;
    for (const { id: name, study, svg } of plotsOf(chapter)) {
        if (hasText && read(source).includes(`(../plots/${chapter.name}-${name}.svg)`)) continue;
        const id = `plot-${name}`;
        text.headings.push({ level: 2, id, text: study });
        text.sections.push({ id, text: study, words: '' });
        text.html += `<h2 id="${id}">${study}</h2>\n${plot(svg, study)}\n`;
    }
    return text;
}

function textPage(page) {
    let text;
    try {
        text = render(read(page.source), resolver(page.source));
    } catch (error) {
        throw new Error(`${page.source}: ${error.message}`);
    }
    if (page.source === 'docs/studies/README.md')
        text.html += `<ul>${pages.filter(one => one.kind === 'studies').map(one =>
            `<li><a href="${one.out}">${escape(one.parent.name)}</a></li>`).join('')}</ul>`;
    const parts = pages.filter(one => one.parent === page);
    if (parts.length)
        text.html += `<p class="parts">More of this chapter: ${parts.map(one =>
            `<a href="${one.out}">${escape(one.name.slice(3).toLowerCase())}</a>`).join(', ')}.</p>`;
    return text;
}

// What the search knows: a section each, also by words that learners have for it and the text has not.
const searched = [], learnersWords = new Map(Object.entries(JSON.parse(readFileSync(join(here, 'learners_words.json'), 'utf8'))));
for (const page of pages) {
    const { pair } = resolver(page.source);
    Object.assign(page, page.kind === 'studies' ? studiesPage(page)
        : page.kind === 'mistakes' ? await mistakesPage(page.chapter, join(root, 'tests/mistakes', page.chapter.name),
                                                         read(page.source), pair)
        : textPage(page));
    page.html = page.html.replace('loading="lazy"', 'fetchpriority="high"');  // the first picture
    for (const { id, text, words, code = '' } of page.sections)
        searched.push({ id: `${page.out}#${id}`, text, words, code, page: page.name, also: learnersWords.get(`${page.out}#${id}`) ?? '' });
}
for (const id of learnersWords.keys())
    if (!searched.some(section => section.id === id)) throw new Error(`learners_words.json names ${id}, which does not exist`);

rmSync(out, { recursive: true, force: true });
const write = (file, content) => {
    mkdirSync(dirname(join(out, file)), { recursive: true });
    writeFileSync(join(out, file), content);
};
const title = titleOf('README.md');
if (compiled) {
    for (const [chapter, { script }] of compiled) write(`assets/live-${chapter}.js`, script);
    write('assets/live.js', pageScript());
} else {
    console.log('live figures need Emscripten: install emcc (Debian: emscripten, 805 MB); the still pictures stay');
}
// The exercises whose answers in this folder the figures of a chapter run.
function exercisesOf(chapter, folder) {
    if (withoutFirst.has(chapter)) return [];
    return exercisesUsed(written(chapter), folders(chapter, chapters, folder), folder, chapters);
}
if (compiled && first) {
    const switched = [];  // pages
    for (const page of pages) {
        const shown = [...new Set([...page.html.matchAll(/data-live="(\d\d)\./g)].map(([, chapter]) => chapter))];
        const used = new Set(shown.flatMap(chapter => exercisesOf(chapter, first)));
        const refused = shown.some(one => withoutFirst.has(one)), switches = shown.some(one => compiled.get(one).runsAsItIs);
        if (switches) switched.push(page.out);
        if (shown.length > 0)
            page.html = page.html.replace('</h1>', `</h1>\n<p class="whose">${whose([...used].sort(), refused, switches && failing)}</p>`);
    }
    if (failing)
        console.log(switched.length > 0 ? `${failing} as it is: in the figures of ${switched.join(', ')}` : `no live figure can run ${failing}`);
}
const book = {
    pages, title, hasLiveFigures: compiled !== undefined, url: options.url?.replace(/\/*$/, '/'),
    passed: new Set(words('passed.txt')),
    sourceOf({ source }) {
        if (options.source) return `${options.source.replace(/\/*$/, '/')}${source}`;
        const to = `source/${source.replaceAll('/', '-')}.txt`;  // which every browser shows
        copied.set(to, source);
        return to;
    },
};
for (const page of pages) write(page.out, layout(page, book));
for (const [to, file] of copied) if (existsSync(join(root, file))) write(to, readFileSync(join(root, file)));
const toConvert = [...converted];
const convert = async () => {
    for (let one; (one = toConvert.pop());) write(one[0], await webp(join(root, one[1].file), cache, one[1].crop));
};
await Promise.all([convert(), convert()]);
if (book.url) {
    write('assets/card.jpg', await card(join(root, 'docs/images/final.png'), cache));
    write('sitemap.txt', pages.map(page => `${book.url}${page.out}\n`).join(''));
}

const asset = name => withoutComments(readFileSync(join(here, name), 'utf8'));
write('assets/book.js', ['slide.js', 'book.js'].map(asset).join(''));
// As a script, because pages of a folder may not fetch other files.
write('assets/search.js', readFileSync(packaged('minisearch').replace(/dist.*/, 'dist/umd/index.js'), 'utf8') +
    `\nwindow.bookSections = ${JSON.stringify(searched)};\n`);

// What is not the course's own, and is copied along.
write('assets/licenses.txt', ['minisearch/LICENSE.txt', 'temml/LICENSE', '@fontsource/stix-two-math/LICENSE', '@fontsource/stix-two-text/LICENSE']
    .map(file => `${file}\n\n${readFileSync(join(here, 'node_modules', file), 'utf8')}`).join('\n\n'));

// The font of formulas, with the characters that occur. A letter in a formula is shown as a slanted one,
// which is a character of its own; the root sign occurs in no text.
const slantedGreek = [...mathLetters].flatMap(letter => {
    const code = letter.codePointAt(0);
    return code >= 0x391 && code <= 0x3a9 ? [0x1d6e2 + code - 0x391] : code >= 0x3b1 && code <= 0x3f6 ? [0x1d6fc + code - 0x3b1] : [];
});
const others = [[0x1d434, 0x1d467], ...slantedGreek.map(code => [code, code]), [0x1d715, 0x1d71b], [0x210e, 0x210e], [0x221a, 0x221a], [0x20, 0x7e]]
    .flatMap(([from, to]) => Array.from({ length: to - from + 1 }, (_, i) => String.fromCodePoint(from + i)));
const font = packaged('@fontsource/stix-two-math').replace(/[^/]*$/, 'files/stix-two-math-latin-400-normal.woff2');
write('assets/formulas.woff2',
    await subsetFont(readFileSync(font), [...mathLetters, ...others].join(''), { targetFormat: 'woff2' }));
write('assets/formulas.css', `@font-face {\n  font-family: STIX2;\n  src: url(formulas.woff2);\n}\n` +
    readFileSync(packaged('temml').replace(/[^/]*$/, 'Temml-STIX2.css'), 'utf8')
        .replace(/\/\*[^]*?\*\/\s*|@font-face\s*{[^}]*}\s*/g, ''));
// The text's, of the same family, in the style sheet itself, so that a page is not laid out twice.
const textLetters = [...new Set(pages.map(page => page.html).join(''))].join('');
const faces = ['400-normal', '400-italic', '700-normal'].map(async face => {
    const file = packaged('@fontsource/stix-two-text').replace(/[^/]*$/, `files/stix-two-text-latin-${face}.woff2`);
    const [weight, style] = face.split('-');
    const bytes = await subsetFont(readFileSync(file), textLetters, { targetFormat: 'woff2', noLayoutClosure: true });
    return `@font-face {\n  font-family: Text; font-weight: ${weight}; font-style: ${style};\n` +
        `  src: url(data:font/woff2;base64,${bytes.toString('base64')});\n}\n`;
});
write('assets/book.css', (await Promise.all(faces)).join('') + ['palette.css', 'book.css'].map(asset).join(''));

console.log(`${pages.length} pages: ${join(out, 'index.html')}`);
