// Opens every page of the book in Chromium: node book/test.mjs FOLDER CHROMIUM [SAMPLES]. Pages are read from the
// folder as a person would, without a server, and some of them from a server, below a path. Each is looked at once on a
// large screen and once on a phone, in light and dark colors. SAMPLES holds pages as learners share them. The book must
// have been made with --url https://example.org/book.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { modules } from './live.mjs';
import { whose } from './yours.mjs';
import { chromium } from 'playwright-core';

const folder = resolve(process.argv[2]);
const root = pathToFileURL(folder).href + '/';
const here = dirname(fileURLToPath(import.meta.url)), course = dirname(here);
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const contrast = readFileSync(join(here, 'contrast.js'), 'utf8');
const pages = readdirSync(folder).filter(name => name.endsWith('.html'));
// Chapters that show something after each idea.
const ideaByIdea = /^(?:0[2-7]|1[0-3])-(?!.*-(mistakes|studies))/;
const most = 300_000;  // bytes of a page without its pictures

const faults = [];
const check = (holds, what) => { if (!holds) faults.push(what); };

const browser = await chromium.launch({
    executablePath: process.argv[3],
    args: process.getuid() === 0 ? ['--no-sandbox'] : [],
});

// In the page: how much has moved that nobody touched, the words that are written on canvases, and when it is drawn next.
function observe() {
    window.moved = { sum: 0, what: [] };
    new PerformanceObserver(list => {
        for (const { hadRecentInput, value, sources } of list.getEntries())
            if (!hadRecentInput) {
                moved.sum += value;
                moved.what.push(...sources.map(({ node }) => node?.textContent?.trim().slice(0, 30) || node?.nodeName));
            }
    }).observe({ type: 'layout-shift', buffered: true });
    window.written = new Map();
    const fillText = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...where) {
        // The rim is the paper behind the words; on pictures, words are white with a dark rim.
        written.set(`${text} ${this.fillStyle}`, { text, ink: this.fillStyle, paper: this.strokeStyle, alpha: this.globalAlpha });
        return fillText.call(this, text, ...where);
    };
    window.nextFrame = () => new Promise((drawn, never) => {
        setTimeout(() => never(new Error('the browser no longer draws')), 60_000);
        requestAnimationFrame(drawn);
    });
}

// A page that remembers what it requested, and records as faults what went wrong. It believes in so many cores.
async function opened(name, { cores = 1, ...options } = {}, from = root) {
    const context = await browser.newContext({ viewport: { width: 1300, height: 900 }, ...options });
    context.setDefaultTimeout(120_000);  // other programs may use the machine, too
    const page = await context.newPage();
    await page.addInitScript(observe);
    await page.addInitScript(cores => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => cores }), cores);
    page.asked = [];
    page.on('console', said => check(!['error', 'warning'].includes(said.type()), `${name}: console: ${said.text()}`));
    page.on('pageerror', error => check(false, `${name}: ${error.message}`));
    page.on('requestfailed', request =>  // a request is aborted if the page is left before the answer
        check(request.failure().errorText === 'net::ERR_ABORTED', `${name}: could not load ${request.url()}`));
    page.on('response', answer => check(answer.status() < 400, `${name}: ${answer.status()} for ${answer.url()}`));
    page.on('request', request => {
        if (/^(data|blob):/.test(request.url())) return;
        page.asked.push(request.url());
        check(request.url().startsWith(from), `${name}: asks another host: ${request.url()}`);
    });
    await page.goto(from + name);
    return page;
}

const close = page => page.context().close();

// ---- Every page ------------------------------------------------------------------------------

const anchors = new Map();  // for each page, what can be linked to
const links = [];

async function accessible(page, name, rules) {
    // Without the thousands of parts of formulas and plots, which are like the wholes that they belong to. Contrast is
    // measured by contrast.js, which knows drawings and canvases, too; axe's own rules of color take longer than all others.
    const violations = await page.evaluate(async rules => (await axe.run({ exclude: ['math', '.plot > *', '.drawing > *', 'pre > *'] }, {
        preload: false,  // it would ask for the style sheets, which pages of a folder may not
        resultTypes: ['violations'],
        ...(rules ? { runOnly: rules }
            : { rules: Object.fromEntries(['color-contrast', 'link-in-text-block'].map(rule => [rule, { enabled: false }])) }),
    })).violations, rules);
    for (const { id, impact, help, nodes } of violations)
        check(false,  `${name}: ${impact}, ${id}: ${help}: ` + nodes.slice(0, 3).map(node => node.html.slice(0, 120)).join(' | '));
}

async function readable(page, name) {
    for (const colorScheme of ['light', 'dark']) {
        await page.evaluate(() => written.clear());
        await page.emulateMedia({ colorScheme });
        await page.evaluate(() => nextFrame().then(nextFrame));
        const found = await page.evaluate(() => [...hardToRead(), ...[...written.values()]
            .map(({ text, ink, paper, alpha }) => ({ text, ratio: contrastOf(ink, paper, alpha) }))
            .filter(({ ratio }) => ratio < 4.5).map(({ text, ratio }) => `${text} (${ratio.toFixed(2)}, on a canvas)`)]);
        check(found.length === 0, `${name}, ${colorScheme}: hard to read: ${[...new Set(found)].slice(0, 8).join('; ')}`);
    }
    await page.emulateMedia({ colorScheme: 'light' });
}

async function still(page, name) {
    const { sum, what } = await page.evaluate(() => moved);
    check(sum < 0.02, `${name}: moves by ${sum.toFixed(3)}: ${[...new Set(what)].slice(0, 6).join(' | ')}`);
}

async function tryPage(name) {
    const page = await opened(name, { viewport: { width: 1440, height: 900 } });
    const found = await page.evaluate(async () => {
        const images = [...document.images];
        for (const image of images) image.loading = 'eager';
        await Promise.all(images.map(image => image.complete || new Promise(end => { image.onload = image.onerror = end; })));
        // Where the longest stretch without these begins and ends, above an element: [top, bottom].
        const longestWithout = (what, end) => {
            if (!end) return [0, 0];
            let [bottom, longest] = [document.querySelector('main').getBoundingClientRect().top, [0, 0]];
            for (const { top, bottom: next } of [...[...document.querySelectorAll(what)].filter(one => one.checkVisibility()), end]
                .map(one => one.getBoundingClientRect()).sort((a, b) => a.top - b.top)) {
                if (top > end.getBoundingClientRect().top) break;
                if (top - bottom > longest[1] - longest[0]) longest = [bottom, top];
                bottom = Math.max(bottom, next);
            }
            return longest;
        };
        let [characters, lines] = [0, 0];  // in the paragraphs without formulas
        for (const p of document.querySelectorAll('main > p')) {
            if (p.querySelector('math, img')) continue;
            characters += p.textContent.length;
            const range = document.createRange();
            range.selectNodeContents(p);
            let [last, end] = [-Infinity, 0];  // of the line so far: its bottom and its right end
            for (const { bottom, right } of range.getClientRects()) {
                if (bottom > last + 12) [lines, last, end] = [lines + 1, bottom, 0];
                end = Math.max(end, right);
            }
            lines -= 1 - (end - p.getBoundingClientRect().left) / p.clientWidth;
        }
        return {
            unlisted: [...document.querySelectorAll('main :is(h2, h3, h4)[id]')].filter(({ id }) =>
                ![...document.querySelectorAll('.outline a')].some(({ hash }) => decodeURIComponent(hash) === `#${id}`)).map(({ id }) => id),
            ids: [...document.querySelectorAll('[id]')].map(element => element.id),
            links: [...document.querySelectorAll('a[href]')].map(link => link.getAttribute('href')),
            broken: images.filter(image => !image.complete || !image.naturalWidth).map(image => image.src),
            unnamed: images.filter(image => !image.alt).map(image => image.src),
            bald: [...document.querySelectorAll('main :is(img, svg.drawing)')].filter(picture =>
                picture.checkVisibility() && !picture.closest('table, .compare, .mistake, .live') &&
                !picture.nextElementSibling?.matches('.caption')).map(picture => picture.alt ?? picture.ariaLabel),
            titles: document.querySelectorAll('h1').length,
            empty: [...document.querySelectorAll('th')].filter(head => !head.textContent.trim()).length,
            bare: [...document.querySelectorAll('main :is(p, li, td) a')].filter(link =>
                getComputedStyle(link).textDecorationLine !== 'underline').map(link => link.textContent),
            about: document.querySelector('meta[name=description]')?.content.length,
            line: lines > 15 ? characters / lines : 65,
            carets: [...document.querySelectorAll('th')].filter(head => head.textContent.includes('^')).map(head => head.textContent),
            torn: [...document.querySelectorAll('code .whole')].filter(word => word.getClientRects().length > 1).map(word => word.textContent),
            options: [...document.querySelectorAll('main :not(pre) > code')].filter(({ textContent, innerHTML }) =>
                /^--?\w[\w-]{1,23}$/.test(textContent) && !innerHTML.startsWith('<span class="whole"')).map(code => code.textContent),
            holes: [...document.querySelectorAll('main :not(msqrt, mrow) > msqrt:last-child, main mrow:last-child > msqrt:last-child')].filter(one =>
                one.closest('math').getBoundingClientRect().right - one.lastElementChild.getBoundingClientRect().right > 4 &&
                !one.closest('mtable, .formula, mfrac') && one === [...one.closest('math').querySelectorAll('msqrt')].at(-1)).map(one => one.textContent),
            early: [...document.querySelectorAll('main math')].filter(math => {  // punctuation of a formula on the next line
                const next = math.nextSibling;
                const at = next?.nodeType === Node.TEXT_NODE ? next.data.search(/(?<=^\s*)[.,;:!?)]/) : -1;
                if (at < 0) return false;
                const range = document.createRange();
                range.setStart(next, at);
                range.setEnd(next, at + 1);
                const { left, width } = range.getBoundingClientRect();
                return width > 0 && left < [...math.querySelectorAll('mi, mn, mo')].at(-1).getBoundingClientRect().left;
            }).map(math => math.parentElement.textContent.slice(0, 60)),
            anchored: [...document.querySelectorAll('main .anchor')].filter(anchor => anchor.checkVisibility() &&
                anchor.getBoundingClientRect().right > anchor.parentElement.getBoundingClientRect().left + 1).map(anchor => anchor.hash),
            crowded: [...document.querySelectorAll('.graph .node')].filter(node =>
                node.querySelector('text').getBBox().width > node.querySelector('path').getBBox().width - 6).map(node => node.textContent.trim()),
            stretch: longestWithout('main :is(img, svg, .live, .code)', document.getElementById('where-to-read-on')),
            straight: [...document.querySelectorAll('main :is(p, li, td, h1, h2, h3, summary)')].filter(element => {
                const own = element.cloneNode(true);
                for (const code of own.querySelectorAll('code, pre, math, svg, .live')) code.remove();
                return /["']/.test(own.textContent);
            }).map(element => element.textContent.slice(0, 60)),
        };
    });
    anchors.set(name, new Set(found.ids));
    links.push(...found.links.map(href => ({ name, href })));
    check(found.unlisted.length === 0, `${name}: the contents lack ${found.unlisted}`);
    check(found.broken.length === 0, `${name}: broken pictures: ${found.broken}`);
    check(found.bald.length === 0, `${name}: pictures without a caption: ${found.bald.join(' | ')}`);
    check(found.unnamed.length === 0, `${name}: pictures without words: ${found.unnamed}`);
    check(found.ids.length === anchors.get(name).size, `${name}: an id that occurs twice`);
    if (ideaByIdea.test(name)) {
        const [top, bottom] = found.stretch;
        check(bottom > 0 && bottom - top <= 1500,
              `${name}: nothing but words for ${Math.round(bottom - top)} points, ${Math.round(top)} from the top`);
    }
    check(found.titles === 1, `${name}: ${found.titles} titles`);
    check(found.empty === 0, `${name}: ${found.empty} empty heads of tables`);
    check(found.bare.length === 0, `${name}: links that are not underlined: ${found.bare}`);
    check(found.about > 20, `${name}: no words about it for other sites`);
    // The pages of measurements hold many figures, which are narrower than letters.
    const widest = /-studies|^accuracy/.test(name) ? 71 : 68;
    check(Math.round(found.line) >= 62 && Math.round(found.line) <= widest, `${name}: lines of ${found.line.toFixed(1)} characters`);
    check(found.carets.length === 0, `${name}: heads with carets: ${found.carets}`);
    check(found.torn.length === 0 && found.options.length === 0, `${name}: a line may break in ${[...found.torn, ...found.options]}`);
    check(found.holes.length === 0, `${name}: a hole after the root of ${found.holes}`);
    check(found.early.length === 0, `${name}: punctuation begins a line: ${found.early.join(' | ')}`);
    check(found.anchored.length === 0, `${name}: a heading's link takes room: ${found.anchored.slice(0, 3)}`);
    check(found.crowded.length === 0, `${name}: a box is too narrow for: ${found.crowded}`);
    check(found.straight.length === 0, `${name}: straight quotes: ${found.straight.slice(0, 3).join(' | ')}`);
    await still(page, name);
    await page.evaluate(async () => {  // what is folded is tried, too
        for (const fold of document.querySelectorAll('details')) fold.open = true;
        await nextFrame().then(nextFrame);
        window.moved = { sum: 0, what: [] };
    });
    await page.evaluate(axe);
    await page.evaluate(contrast);
    const figures = hasLiveFigures ? liveOn(name) : [];
    for (const live of figures) await tryLiveFigure(page, name, live);
    if (figures.length > 0) await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }));  // figures sleep
    const drawings = await page.evaluate(() => [...document.querySelectorAll('svg')].reduce((sum, svg) => sum + svg.outerHTML.length, 0));
    const bytes = [...new Set(page.asked)].filter(url => !/\.(png|webp|svg)$/.test(url))
        .reduce((sum, url) => sum + statSync(new URL(url)).size, -drawings);
    check(bytes < most, `${name}: ${bytes} bytes without pictures`);
    // A heading's link to itself is seen only while the mouse is on the heading.
    if (await page.locator('main h2').count() > 0) await page.locator('main h2').first().hover();
    await accessible(page, name);
    if (name === 'map.html') await accessible(page, name, ['color-contrast', 'link-in-text-block']);
    await readable(page, name);
    await still(page, name);
    if (figures.length > 0) await tryPrintedFigures(page, name);
    await tryOnPhone(page, name);
    await close(page);
    return { bytes, figures: figures.length };
}

async function tryOnPhone(page, name) {
    await page.setViewportSize({ width: 390, height: 800 });
    await page.reload();
    const { width, silent } = await page.evaluate(async () => {
        for (let y = 0; y < document.documentElement.scrollHeight; y += 700) {
            scrollTo({ top: y, behavior: 'instant' });
            await nextFrame();
        }
        return {
            width: document.documentElement.scrollWidth,
            silent: [...document.querySelectorAll('.scroll:has(table)')].filter(table => table.checkVisibility() &&
                table.scrollWidth > table.clientWidth && !table.previousElementSibling?.matches('.scrolls')).length,
        };
    });
    check(width <= 390, `${name}: ${width} pixels wide on a phone of 390`);
    check(silent === 0, `${name}: ${silent} tables do not say that they scroll`);
    await page.evaluate(axe);
    await accessible(page, `${name} on a phone`);
    if (hasLiveFigures)
        for (const live of liveOn(name))
            if (await page.locator(`[data-live="${live}"]`).isVisible()) await runs(page, live);  // and is not folded
    await still(page, `${name} on a phone`);
}

function tryLinks() {
    for (const { name, href } of links) {
        if (/^(https?|mailto):/.test(href)) continue;
        const [file, anchor] = decodeURIComponent(href).split('#');
        check(existsSync(join(folder, file || name)), `${name}: leads to ${href}, which does not exist`);
        const ids = anchors.get(file || name);
        check(!anchor || !ids || ids.has(anchor), `${name}: leads to ${href}, where that anchor does not exist`);
    }
}

// ---- What the pages do -----------------------------------------------------------------------

async function trySearch(from, width = 1300) {
    const page = await opened('index.html', { viewport: { width, height: 800 } }, from);
    await page.keyboard.press('/');
    const first = page.locator('search li a').first();
    const search = async words => {
        await page.fill('search input', words);
        await page.waitForFunction(words => document.querySelector('search ol').dataset.query === words, words);
        return first;
    };
    for (const [words, leads] of [['sqrt', /sqrt/], ['difference_of_products', /difference_of_products/],
                                  ['cancellation', /[Cc]ancellation/], ['cancelation', /[Cc]ancellation/],
                                  ['the schlick angle of', /Schlick[^]*angle|angle[^]*Schlick/]]) {
        await search(words);
        const [file, id] = (await first.getAttribute('href')).split('#');
        const section = await page.evaluate(href => Object.values(window.bookSections.find(({ id }) => id === href)).join(' '), `${file}#${id}`);
        assert.match(section, leads, `${words} leads to a section that has it`);
        assert.match(await first.locator('span').textContent(), leads.source.includes('angle') ? /schlick|angle/i : leads, `${words}: the excerpt shows it`);
    }
    await search('cancellation');
    const box = await first.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= width, 'what was found can be seen');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    const second = page.locator('search li a').nth(1);
    assert.equal(await second.getAttribute('aria-selected'), 'true', 'arrow keys choose');
    const href = await second.getAttribute('href');
    await page.keyboard.press('Enter');
    await page.waitForURL(from + href);
    assert.match(await page.textContent('main'), /cancellation/);
    const marked = () => page.evaluate(() => [...CSS.highlights.get('sought') ?? []].map(String));
    assert.ok((await marked()).length > 0, 'the word is marked on the page');
    for (const word of await marked()) assert.match(word, /^cancellation$/i);
    await close(page);
}

// What learners type, and the section that they want.
async function tryQueries() {
    const page = await opened('index.html');
    const queries = Object.entries({
        'gamma': '03-sphere.html#a-picture-file', 'fov': '02-camera.html#how-large-the-viewport-is', 'field of view': '02-camera.html#how-large-the-viewport-is',
        'segfault': '00-toolchain.html#common-mistakes', 'why is my picture black': '09-own.html#when-the-picture-is-wrong',
        'black picture': '09-own.html#when-the-picture-is-wrong', 'too slow': '07-bvh.html#a-list-is-slow', 'depth of field': '08-effects.html#a-lens',
        'smart pointer': '00-toolchain.html#unique_ptr-one-owner', 'run the tests': 'your-day.html#your-day', 'vscode': 'your-day.html#your-day',
        'lerp': '12-triangles.html#a-color-from-an-image', 'shadow acne': '04-normals_aa.html#leaving-the-surface',
        'anti-aliasing': '04-normals_aa.html#smooth-edges', 'antialiasing': '04-normals_aa.html#smooth-edges', 'noisy': '04-normals_aa.html#how-fast-the-noise-falls',
        'diffuse': '04-normals_aa.html#lamberts-cosine', 'rendering equation': '04-normals_aa.html#a-sum-over-the-hemisphere',
        'monte carlo': '04-normals_aa.html#an-average-at-random', 'russian roulette': '04-normals_aa.html#the-end-of-a-path',
        'index of refraction': '05-metal_glass.html#refraction', 'inheritance': '05-metal_glass.html#values-or-virtual-functions',
        'data race': '06-threads.html#what-a-mutex-is-for-and-a-deadlock', 'seed': '06-threads.html#random-numbers-that-do-not-depend-on-the-order',
        'aabb': '07-bvh.html#a-ray-and-a-box', 'next event estimation': '08-effects.html#two-ways-to-one-light',
        'tone mapping': '11-samples.html#from-light-to-a-screen', 'load an obj': '12-triangles.html#meshes-and-their-files',
        'undefined reference': '00-toolchain.html#when-the-linker-complains', 'how do I install': 'index.html#start', 'simd': '10-batches.html#one-instruction-for-many-numbers',
        'normalise': '01-vectors.html#length', 'dot product': '01-vectors.html#the-dot-product', 'cross product': '01-vectors.html#the-cross-product',
    });
    const found = await page.evaluate(async queries => {
        const { index } = await load();
        return queries.map(query => find(index, query)[0]?.id);
    }, queries.map(([query]) => query));
    queries.forEach(([query, wanted], i) => check(found[i] === wanted, `${query} leads to ${found[i]}, not to ${wanted}`));
    assert.ok(queries.length >= 30);
    const formula = await page.evaluate(async () => {
        await load();
        const words = id => window.bookSections.find(section => section.id === id).words;
        return words('03-sphere.html#a-quadratic-equation');
    });
    assert.match(formula, /\(f\+td\)⋅\(f\+td\) = r²/, 'excerpts have formulas');
    await close(page);
}

async function tryTheme() {
    const page = await opened('index.html', { colorScheme: 'light' });
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await paper();
    await page.click('.theme');
    const dark = await paper();
    assert.notEqual(light, dark);
    await page.goto(root + 'map.html');
    assert.equal(await paper(), dark, 'the next page is dark, too');
    await close(page);
}

async function trySlider() {
    const page = await opened('03-sphere.html');
    const figure = page.locator('.compare').first(), slider = figure.locator('input'), pair = figure.locator('.pair');
    await page.locator('details:has(.compare) > summary').first().click();
    await pair.scrollIntoViewIfNeeded();
    await page.waitForFunction(() => [...document.querySelector('.compare').querySelectorAll('img')]
        .every(image => image.complete && image.naturalWidth));
    const divider = () => pair.evaluate(element => parseFloat(getComputedStyle(element, '::after').left) / element.clientWidth);
    const seen = word => pair.locator('.word', { hasText: word }).evaluate(element => +getComputedStyle(element).getPropertyValue('--seen') !== 0);
    await slider.fill('30');
    assert.ok(Math.abs(await divider() - 0.3) < 0.01, 'the line is where the thumb is');
    assert.match(await pair.locator('.over').evaluate(element => getComputedStyle(element).clipPath), /30%\)$/, 'right of it is the right picture');
    assert.ok(await seen('textbook') && await seen('star'));
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await slider.inputValue(), '31', 'the keyboard moves it');
    const box = await pair.boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 20);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.9 * box.width, box.y + 30, { steps: 3 });
    await page.mouse.up();
    assert.ok(Math.abs(await divider() - 0.9) < 0.02, 'it can be dragged on the picture');
    assert.equal(await seen('star'), false, 'a word goes with its picture');
    await close(page);
}

async function tryMistakes() {
    const page = await opened('04-normals_aa-mistakes.html');
    const pairs = page.locator('.wrong-right');
    assert.ok(await pairs.count() > 5);
    assert.deepEqual(await pairs.first().locator('figcaption').allTextContents(), ['wrong', 'right']);
    const [wrong, right] = await pairs.first().locator('img').evaluateAll(all => all.map(one => `${one.width} ${one.height} ${one.y}`));
    assert.equal(wrong, right, 'the pictures are as large as each other, side by side');
    assert.ok(await page.locator('.mistake math').count() > 0 || !/\$/.test(await page.textContent('main')), 'formulas are typeset');
    await page.goto(root + '03-sphere-mistakes.html');
    await page.getByText('b*b - 4*a*c', { exact: false }).first().waitFor();
    assert.equal(await page.locator('.mistake em').count(), 0, 'stars are products and pointers');
    await close(page);
}

async function tryPictureTables() {
    const page = await opened('04-normals_aa.html');
    const widths = await page.locator('tr:has(> td:nth-child(3) > img) > td').evaluateAll(all => all.map(one => one.offsetWidth));
    assert.equal(widths.length, 3);
    assert.ok(Math.max(...widths) - Math.min(...widths) <= 1, `three pictures are as wide as each other: ${widths}`);
    await page.goto(root + '12-triangles.html');
    const words = page.locator('.compare', { hasText: 'keep_side returns direction' }).locator('.word');
    assert.deepEqual(await words.allTextContents(), ['keep_side returns direction', 'with the rule below'], 'heads of a table are words on its pictures');
    assert.ok(await words.first().isVisible() && await words.last().isVisible());
    await close(page);
}

async function tryCopy() {
    const page = await opened('00-toolchain.html');
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    const copied = async begin => {
        const code = page.locator('.code').filter({ hasText: begin }).first();
        await code.hover();
        await code.locator('.copy').click();
        await code.getByText('Copied').waitFor();
        const [button, first] = await code.evaluate(element => {
            const text = document.createRange();
            text.selectNodeContents(element.querySelector('code'));
            return [element.querySelector('.copy'), text].map(one => one.getBoundingClientRect());
        });
        assert.ok(button.bottom <= first.top, 'the button covers no code');
        return page.evaluate(() => navigator.clipboard.readText());
    };
    assert.equal(await copied(/^g\+\+ .* first\.cpp/), 'g++ -std=c++20 -O2 first.cpp -o first && ./first > first.ppm\n');
    assert.equal(await copied(/-    return discriminant >= 0;/), `    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return -1;
    double front = (-b - std::sqrt(discriminant)) / (2 * a);
    return front;
}\n`, 'of a change, the new lines');
    assert.equal(await copied(/^\$ g.. main\.o shade\.o/),
                 "g++ main.o shade.o -o raytracer\n./raytracer > second.ppm\nnm -C raytracer | grep -E ' (shade|main)'\n", 'of a session, the commands');
    await close(page);
}

async function tryStars() {
    const page = await opened('03-sphere.html');
    const open = () => page.locator('details[open]:has(> summary:text-matches("^★"))').count();
    assert.equal(await open(), 0, 'stars are folded until they are wanted');
    await page.click('.stars');
    assert.ok(await open() > 0);
    await page.goto(root + '05-metal_glass.html');
    assert.ok(await open() > 0, 'they are open on the next page, too');
    await page.click('.stars');
    assert.equal(await open(), 0);
    await close(page);
}

async function tryPublished() {
    const url = 'https://example.org/book/', index = readFileSync(join(folder, 'index.html'), 'utf8');
    assert.deepEqual(readFileSync(join(folder, 'sitemap.txt'), 'utf8').trim().split('\n').sort(), pages.map(name => url + name).sort());
    assert.ok(index.includes(`<link rel="canonical" href="${url}index.html">`));
    assert.ok(index.includes(`<meta property="og:image" content="${url}assets/card.jpg">`) && existsSync(join(folder, 'assets/card.jpg')));
}

async function tryPlot() {
    const page = await opened('03-sphere.html');
    const plot = page.locator('.measured').first(), mark = plot.locator('circle:has(title)').nth(5);
    await mark.scrollIntoViewIfNeeded();
    await mark.hover({ force: true });
    const said = () => plot.locator('output').textContent();
    const first = await said();
    assert.match(first, /, (double|float): .* \d/);
    await plot.press('ArrowRight');
    assert.match(await said(), /, (double|float): .* \d/);
    assert.notEqual(await said(), first, 'the arrow keys lead to the next value');
    await close(page);
}

async function tryContents() {
    const page = await opened('03-sphere.html', { viewport: { width: 390, height: 800 } });
    const contents = page.locator('#contents');
    assert.equal(await contents.isVisible(), false);
    await page.click('.menu');
    assert.equal(await contents.isVisible(), true);
    await contents.getByText('Hard cases', { exact: true }).click();
    assert.equal(await contents.isVisible(), false, 'they close when a section is chosen');
    await page.waitForFunction(() => Math.abs(document.querySelector('#hard-cases').getBoundingClientRect().top) < 200);
    await page.waitForFunction(() => document.querySelector('#contents .here')?.textContent === 'Hard cases');
    for (const id of ['hard-cases', 'the-discriminant-of-a-far-sphere', 'a-quadratic-equation']) {
        await page.locator(`#${id}`).evaluate(heading => heading.scrollIntoView({ behavior: 'instant' }));
        await page.waitForFunction(id => document.querySelector('#contents .here')?.hash === `#${id}`, id);
    }
    await page.locator('.menu').evaluate(button => button.click());
    await contents.getByText('05 Metal and glass').click();
    await page.waitForURL(root + '05-metal_glass.html');
    const next = page.locator('a[rel=next]'), previous = page.locator('a[rel=prev]');
    const here = page.url();
    await next.click();
    await previous.click();
    assert.equal(page.url(), here, 'next, then previous');
    await page.waitForFunction(() => document.readyState === 'complete');
    await page.keyboard.press('ArrowRight');
    await page.waitForURL(root + '05-metal_glass-mistakes.html');
    await page.waitForFunction(() => document.readyState === 'complete');
    await page.keyboard.press('ArrowLeft');
    await page.waitForURL(here);
    await page.waitForFunction(() => document.readyState === 'complete');
    await page.locator('.compare input').first().evaluate(slider => {
        for (let fold = slider; (fold = fold.parentElement.closest('details'));) fold.open = true;
        slider.focus();
    });
    await page.keyboard.press('ArrowRight');
    await page.waitForTimeout(300);
    assert.equal(page.url(), here, 'a slider keeps the arrow keys');
    await page.goto(root + 'map.html');
    assert.equal(await page.locator('.graph .node').count(), await page.locator('.graph a[href]').count(), 'boxes of the map are links');
    await page.locator('.graph a', { hasText: '05 metal and glass' }).click();
    await page.waitForURL(root + '05-metal_glass.html');
    await close(page);
}

async function tryWithoutScripts() {
    const page = await opened('03-sphere.html', { javaScriptEnabled: false });
    const figure = page.locator('.compare').first();
    assert.equal(await figure.locator('input').isVisible(), false);
    for (const moving of await page.locator('.live canvas, .live form').all())
        assert.equal(await moving.isVisible(), false, 'live figures are still');
    const [left, right] = await Promise.all([0, 1].map(i => figure.locator('img').nth(i).boundingBox()));
    assert.ok(left.x + left.width <= right.x, 'both pictures stand beside each other');
    assert.ok((await figure.locator('.word').last().boundingBox()).y >= right.y + right.height, 'their words are below them');
    assert.equal(await page.locator('math').first().isVisible(), true);
    await page.goto(root + '05-metal_glass.html');
    assert.equal(await page.locator('.live .still').first().isVisible(), true);
    await close(page);
}

async function tryPrint() {
    const page = await opened('03-sphere.html', { colorScheme: 'dark' });
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    for (const selector of ['header', '#contents', '.steps'])
        assert.equal(await page.locator(selector).isVisible(), false, `${selector} is not printed`);
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
    const folded = () => page.locator('details:not([open])').count(), before = await folded();
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    assert.equal(await folded(), 0, 'what is folded is printed, too');
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await folded(), before, 'and folded again after it');
    await close(page);
}

// ---- The live figures ------------------------------------------------------------------------

const hasLiveFigures = existsSync(join(folder, 'assets/live.js'));  // else they were not compiled
const liveOn = name => [...readFileSync(join(folder, name), 'utf8').matchAll(/data-live="([^"]*)"/g)].map(m => m[1]);

// How many milliseconds a new worker takes to answer: 20 to 40 on an idle machine.
const workerAnswers = page => page.evaluate(() => new Promise(resolve => {
    const begin = performance.now();
    const worker = new Worker(URL.createObjectURL(new Blob(['postMessage(0)'])));
    worker.onmessage = () => resolve(performance.now() - begin);
}));

// Scrolls to a figure and waits until it runs.
async function runs(page, live) {
    const figure = page.locator(`[data-live="${live}"]`);
    await figure.evaluate(element => element.scrollIntoView({ block: 'center', behavior: 'instant' }));
    await page.waitForFunction(live => document.querySelector(`[data-live="${live}"].runs`), live, { timeout: 120_000 }).catch(() => {});
    return figure;
}

// What is shown, or that an answer is still on its way. A figure that is reset asks for its picture after the event.
const stateOf = figure => figure.evaluate(async element => {
    await new Promise(later => setTimeout(later));
    const waits = Boolean(element.figure.waits || element.figure.shows);
    return { waits, values: element.figure.values.join(), pixels: waits ? '' : element.querySelector('canvas').toDataURL() };
});

// The figure's picture for the first time without a request on its way.
async function settled(figure) {
    for (let i = 0; i < 4000; ++i) {  // a minute and more: other programs may use the machine, too
        const state = await stateOf(figure);
        if (!state.waits) return state;
        await figure.page().waitForTimeout(15);
    }
}

async function tryLiveFigure(page, name, live) {
    const figure = await runs(page, live), canvas = figure.locator('canvas');
    const says = what => `${name}: live figure ${live} ${what}`;
    if (!await figure.evaluate(element => element.matches('.runs'))) return check(false, says('does not run'));
    const changed = async (before, by) => {
        for (let i = 0; i < 2000; ++i) {
            const now = await stateOf(figure);
            if (!now.waits && now.values !== before.values && now.pixels !== before.pixels) return;
            await page.waitForTimeout(15);
        }
        check(false, says(`does not change by ${by}`));
    };
    let before = await settled(figure);
    const control = figure.locator('[data-control]').first();
    await control.focus();
    const atEnd = await control.evaluate(input => input.type === 'range' && +input.value >= +input.max);
    await page.keyboard.press(await control.evaluate(input => input.tagName) === 'SELECT' ? 'ArrowDown'
        : atEnd ? 'ArrowLeft' : 'ArrowRight');
    await changed(before, 'a key');

    before = await settled(figure);
    const [x, y, radius] = await figure.evaluate(element => element.figure.handles[0] ?? []);
    if (x === undefined) return check(false, says('has nothing to drag'));
    await canvas.evaluate((canvas, y) => scrollBy({
        top: canvas.getBoundingClientRect().top + Math.max(0, y) - 300, behavior: 'instant',
    }), y);
    const box = await canvas.boundingBox();
    const from = radius < 0 ? { x: box.x + box.width / 2, y: box.y + box.height / 3 } : { x: box.x + x, y: box.y + y };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 40, from.y + 25, { steps: 4 });
    await page.mouse.up();
    await changed(before, 'dragging');

    await figure.locator('[type=reset]').click();
    await settled(figure);
    check(await figure.locator('.said').textContent() !== '', says('says nothing'));
    const missing = await figure.evaluate(element => {  // letters of the still picture whose place it takes
        written.clear();
        element.figure.show();
        const words = new Set([...written.values()].flatMap(({ text }) => text.match(/\p{L}+/gu) ?? []));
        return [...element.querySelectorAll('.stage .still text')].map(text => text.textContent.trim())
            .filter(text => /^\p{L}$/u.test(text) && !words.has(text));
    });
    check(missing.length === 0, says(`lacks the letters ${missing} of its still picture`));
}

async function tryPrintedFigures(page, name) {
    await page.emulateMedia({ media: 'print' });
    for (const figure of await page.locator('figure.live').all()) {
        check(!await figure.locator('canvas').isVisible(), `${name}: a live figure is printed`);
        check(await figure.locator('.still').count() === 0 || await figure.locator('.still').isVisible(),
              `${name}: a live figure has no still picture in print`);
    }
    await page.emulateMedia({ media: 'screen' });
}

// The first picture of a page's first figure: within 0.3 s, or longer on a busy machine.
async function tryFirstPicture() {
    const page = await opened('08-effects.html');
    let first, limit;
    for (let i = 0; i < 4 && !(first <= limit); ++i) {
        if (i > 0) await page.reload();
        await page.locator('figure.live').first().scrollIntoViewIfNeeded();
        await page.waitForFunction(() => document.querySelector('figure.live').dataset.first);
        first = +await page.locator('figure.live').first().getAttribute('data-first');
        limit = 300 * Math.max(1, await workerAnswers(page) / 40);
    }
    await close(page);
    assert.ok(first <= limit, `${first} ms until the first picture`);
}

// Several workers draw the same picture as one.
async function tryWorkers() {
    const pictureOf = async cores => {
        const page = await opened('08-effects.html', { viewport: { width: 390, height: 800 }, cores });
        const figure = await runs(page, '08.lamps');
        await figure.locator('[data-control=samples]').fill('2');
        await page.waitForFunction(() => {
            const { figure } = document.querySelector('[data-live="08.lamps"]');
            return !figure.waits && !figure.shows && figure.answer.parts === Math.min(4, navigator.hardwareConcurrency) &&
                figure.answer.samples === 2 && figure.merge() === 2;
        });
        const drawn = await figure.evaluate(element => {
            element.figure.show();
            return { workers: element.figure.module.workers.length, pixels: element.querySelector('canvas').toDataURL() };
        });
        await close(page);
        return drawn;
    };
    const [one, three] = [await pictureOf(1), await pictureOf(3)];
    assert.deepEqual([one.workers, three.workers], [1, 3]);
    assert.ok(one.pixels === three.pixels, 'three workers draw what one draws');
}

// A learner's header that loops for rays that rise, and traps for steep ones that fall: what answers does so again. The
// page's switch turns it off and on.
async function tryBadCode() {
    const chapters = JSON.parse(readFileSync(join(course, 'course.json'))).chapters
        .map(chapter => ({ ...chapter, number: chapter.name.slice(0, 2) }));
    const first = mkdtempSync(join(tmpdir(), 'bad-')), cache = join(course, 'out/book-cache');
    const header = readFileSync(join(course, 'solutions/03_sphere/rt/hit_sphere.hpp'), 'utf8');
    const put = code => {
        mkdirSync(join(first, 'rt'), { recursive: true });
        writeFileSync(join(first, 'rt/hit_sphere.hpp'),
                      header.replace(/(hit_sphere\(const Sphere& sphere.*\{\n)/, (_, begin) => begin + code));
    };
    const refused = [];
    let compiled;
    try {
        put('return nothing_that_exists;');
        compiled = await modules(['03'], chapters, cache, first, chapter => refused.push(chapter));
        assert.deepEqual(refused, ['03'], 'a header that does not compile is refused');
        assert.match(compiled.get('03').script, /"The"\);\n$/, 'the solution’s code runs in its place');
        put('    if (ray.direction.y > 0.2) { volatile bool forever = true; while (forever) {} }\n' +
            '    if (ray.direction.y < -0.2) __builtin_trap();\n');
        compiled = await modules(['03'], chapters, cache, undefined, assert.fail, () => first);
        assert.ok(compiled.get('03').runsAsItIs);
    } finally {
        rmSync(first, { recursive: true });
    }
    const page = await opened('index.html');
    await page.route('**/assets/live-03.js', route => route.fulfill({ contentType: 'text/javascript', body: compiled.get('03').script }));
    await page.route('**/03-sphere.html', async route => {
        const html = readFileSync(join(folder, '03-sphere.html'), 'utf8');
        await route.fulfill({ contentType: 'text/html', body: html.replace('</h1>', `</h1><p class="whose">${whose([], false, '03.2')}</p>`) });
    });
    await page.goto(root + '03-sphere.html');
    const figure = await runs(page, '03.roots'), said = () => figure.locator('.said').textContent();
    const until = fails => page.waitForFunction(fails => {
        const { figure, classList } = document.querySelector('[data-live="03.roots"]');
        return fails ? classList.contains('failed') : !figure.waits && !figure.shows && !classList.contains('failed');
    }, fails);
    const slope = async value => {
        await figure.locator('[data-control=slope]').fill(value);
        await until(Math.abs(value) > 0.2);
    };
    const right = await said();
    await slope('0.3');
    assert.match(await said(), /^Your code did not return: Start of the ray .*Slope 0\.3.* Change a value, or reset\.$/);
    await slope('-0.1');
    assert.equal(await said(), right, 'harmless values work again');
    await slope('-0.3');
    assert.match(await said(), /^Your code failed: .*Slope −0\.3/);
    await page.getByLabel('Your answer to 03.2').uncheck();
    await until(false);
    assert.match(await said(), /^D = /, 'without it, the same values work');
    await page.getByLabel('Your answer to 03.2').check();
    await until(true);
    await figure.locator('[type=reset]').click();
    await page.waitForFunction(right => document.querySelector('[data-live="03.roots"] .said').textContent === right, right);
    await runs(page, '03.nearest');
    assert.equal(await page.locator('[data-live="03.nearest"].runs').count(), 1, 'the other figure of the chapter runs');
    await close(page);
}

// The counter of two threads: what was counted between another's read and its write is lost.
async function tryTurns() {
    const page = await opened('06-threads.html');
    const figure = await runs(page, '06.counter');
    const press = async (...names) => {
        for (const name of names) await figure.getByRole('button', { name }).click();
        await settled(figure);
        return figure.locator('.said').textContent();
    };
    assert.equal(await press('Thread 0', 'Thread 1', 'Thread 0', 'Thread 0', 'Thread 1', 'Thread 1'),
                 'Thread 1 writes 1. The counter was 1: counts lost: 1.');
    assert.equal(await press('Back', 'Back', 'Back', 'Back', 'Back'), 'Thread 0 reads 0.');
    const box = await figure.locator('canvas').boundingBox();
    await page.mouse.click(box.x + 0.9 * box.width, box.y + 40);
    await settled(figure);
    assert.equal(await figure.locator('.said').textContent(), 'Thread 1 reads 0.', 'a thread takes a step where it is clicked');
    await figure.locator('select').selectOption('1');
    assert.equal(await press('Thread 0'), 'Thread 0 takes tile 2 and leaves 3, in one step.');
    assert.equal(await press('Reset'), 'Both threads are about to take their first tile.');
    await close(page);
}

// A finger that swipes over a figure scrolls the page, and one that taps focuses.
async function tryTouch() {
    const page = await opened('08-effects.html', { viewport: { width: 390, height: 800 }, hasTouch: true });
    const client = await page.context().newCDPSession(page);
    const finger = (type, ...points) =>
        client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
    // A finger that a busy machine moves or lifts too late presses instead: it tries again.
    const untilSeen = async (gesture, seen, values) => {
        for (let more = 5; ; --more) {
            await gesture();
            const missed = await page.waitForFunction(seen, values, { timeout: 60_000 }).then(() => null, error => error);
            if (!missed) return;
            if (!more) throw missed;
        }
    };
    for (const live of ['08.lens', '08.lamps']) {
        const figure = await runs(page, live);
        await page.waitForTimeout(100);
        const values = async () => (await settled(figure)).values, before = await values(), top = await page.evaluate(() => scrollY);
        const box = await figure.locator('canvas').boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
        await untilSeen(async () => {
            await finger('touchStart', [x, y]);
            for (let i = 1; i <= 12; ++i) await finger('touchMove', [x + 2 * i, y - 15 * i]);
            await finger('touchEnd');
        }, top => scrollY > top + 50, top);
        assert.equal(await values(), before, `${live} is not changed by a swipe`);
        const now = await figure.locator('canvas').boundingBox(), low = now.y + 0.8 * now.height;
        await untilSeen(async () => {
            await finger('touchStart', [x, low]);
            if (live === '08.lamps') for (let i = 1; i <= 5; ++i) await finger('touchMove', [x + 12 * i, low + i]);
            await finger('touchEnd');
        }, ([live, before]) => {
            const { figure } = document.querySelector(`[data-live="${live}"]`);
            return !figure.waits && figure.values.join() !== before;
        }, [live, before]);
    }
    await close(page);
}

// What figures say about the cases that their texts ask about, by the wrong way, the plain way and the solution's.
async function tryAnswers() {
    for (const [name, live, ...cases] of [
        ['04-normals_aa.html', '04.leave', [{ way: 0 }, /^([4-9]|\d\d) of 61 rays meet/], [{ way: 1, angle: 88, far: 4 }, /^0 of 61 rays meet/],
         [{ way: 2, radius: 5 }, /^0 of 61 rays meet/], [{ angle: 120 }, /^0 of 61 rays into/]],
        ['03-sphere.html', '03.bytes', [{ byte: 188 }, /send 0\.50 of full light\. A byte of 188 stands for 0\.50\.$/],
         [{ byte: 137, light: 0 }, /send 0\.25 .* 137 stands for 0\.25\.$/], [{ byte: 225, light: 2 }, /send 0\.75 .* 225 stands for 0\.75\.$/]],
        ['07-bvh.html', '07.slab', [{ px: 1, py: 3 }, /^A miss: the latest entry is 1\.00, the earliest exit 0\.67\.$/],
         [{ ox: 4, px: 5, oy: 2.5 }, /^A miss: the box is behind O, .* −1\.00\.$/],
         [{ ox: 2, px: 2, oy: 0, py: 1 }, /entry −∞, exit ∞\. A hit: the latest entry is 1\.00, the earliest exit 2\.00\.$/],
         [{ ox: 0.4, px: 0.4 }, /the same infinity\. A miss\.$/], [{ ox: 3, px: 3 }, /is NaN, and this plane does not count\. A hit/]],
        ['08-effects.html', '08.instance', [{ stretch: 2 }, /at t = 2\.39 in the world, and at t = 2\.39 in/], [{ way: 1 }, /at t = 2\.39 in the world, and at t = 1\.35 in/],
         [{ y: 2.2 }, /misses/]],
        ['11-samples.html', '11.adaptive', [{ budget: 32 }, /error is 0\.004\d; if each tile gets its share, it is 0\.003\d, for which [45]\d in each/],
         [{ column: 9, row: 5 }, /saw the spreads 0\.033 and 0\.040, so the halves took 33 and 27 samples\.$/],
         [{ budget: 8 }, /the halves took 4 and 4 samples\.$/], [{ budget: 32, lamp: 1, radius: 0.2 }, /where no pilot met the lamp, tiles got the fewest\./]],
        ['12-triangles.html', '12.normals', [{ way: 0 }, /^From all/], [{ way: 1 }, /^From [1-9]\d? of/], [{ way: 2 }, /^From all/], [{ way: 3 }, /^From all/]],
        ['12-triangles.html', '12.edge', [{ closer: -6 }, /plain test lets [1-9]\d* through, and with 0 it .* is 0 and 0\.$/],
         [{ corners: 1 }, /lets 0 through, and with [1-9]\d* it .* is 0 and 0\.$/],
         [{ corners: 2, closer: -2 }, /lets 0 through, and with 40 it .* is 0 and 0\.$/]],
        ['09-own.html', '09.judge', [{ mistake: 0 }, /in 0 of 144 tiles: the line passes\.$/], [{ mistake: 2, pictures: 1 }, /in 0 of 144 .* passes\.$/],
         [{ pictures: 3 }, /in [1-9]\d* of 144 tiles: the line fails\.$/], [{ mistake: 3, pictures: 0 }, /in [1-9]\d of 144 .* fails\.$/]],
        ['13-cluster.html', '13.schedule', [{ ranks: 4 }, /^4 slices keep the ranks busy [67]\d\.\d %/], [{ share: 3 }, /^135 tiles .* busy 9\d\.\d %/],
         [{ share: 1, slow: 3 }, /^12 tiles .* busy 7\d\.\d %/], [{ share: 5, slow: 1, ranks: 6, latency: 1.30103 }, /^2040 tiles .* busy 2\d\.\d %/]],
        ['12-triangles.html', '12.ears', [{ cut: 0 }, /^8 of 12 corners are ears\. .* corner 0\.$/], [{ cut: 3 }, /^4 of 9 corners are ears\. .* corner 6\.$/],
         [{ cut: 10 }, /10 triangles/], [{ dx: -2.4 }, /^Sides cross/], [{ dx: 0, letter: 2, cut: 0 }, /^5 of 10 corners/]],
        ['12-triangles.html', '12.terminator', [{ lift: 0 }, /^Of 5944 points .*, 132 are black/], [{ lift: 0.05 }, /, 33 are black/],
         [{ lift: 1 }, /, 0 are black/], [{ cuts: 0 }, /, 0 are black/], [{ lift: 0, cuts: 3 }, /, [1-9]\d* are black/]],
        ['14-light.html', '14.shares', [{ number: 0.234375 }, /chooses entry 0, whose share 0\.250 .* rest of the number is 0\.94\.$/],
         [{ number: 0.25 }, /chooses entry 2, .* 0\.375 .* is 0\.125, and the rest of the number is 0\.00\.$/], [{ number: 0.375 }, /chooses entry 3,/],
         [{ number: 0, w0: 0 }, /chooses entry 2,/], [{ w2: 0, w3: 0 }, /nothing to choose/]],
        ['14-light.html', '14.plates', [{ bounces: 0 }, /sharpest plate 18\.\d\d, in the second picture 0\.10; .* dullest plate 0\.00 and 0\.03\.$/],
         [{ bounces: 0.5 }, /plate 9\.\d\d, .* plate 17\.\d\d and 0\.03\.$/],
         [{ bounces: 1, heuristic: 1 }, /plate 0\.00, in the second picture 0\.04; .* plate 34\.\d\d and 0\.00\.$/]],
        ['14-light.html', '14.lobe', [{ angle: 0, roughness: 0.5 }, /within 18° .* within 15° of it to the side\. Of 100, 6 lead/],
         [{ angle: 80 }, /within 21° .* within 6° of it to the side\. Of 100, 5 lead/], [{ roughness: 0.1 }, /Of 100, 0 lead/]],
        ['12-triangles.html', '12.triangle', [{ x: 4, y: 2 }, /weights of a, b and c are −0\.44, 0\.81 and 0\.62/],
         [{ tilt: 90, x: 1, y: 1 }, /determinant is 0/], [{ tilt: 0, start: -1 }, /^No hit: .* behind/], [{ start: 2 }, /^A hit at t = 2\.00/]],
    ]) {
        const page = await opened(name);
        await page.evaluate(() => { for (const fold of document.querySelectorAll('details')) fold.open = true; });
        const figure = await runs(page, live);
        for (const [values, says] of cases) {
            for (const [control, value] of Object.entries(values)) await figure.locator(`[data-control=${control}]`).evaluate((input, value) => {
                input.value = value;
                input.dispatchEvent(new Event('input', { bubbles: true }));
            }, value);
            await settled(figure);
            assert.match(await figure.locator('.said').textContent(), says, `${live} with ${JSON.stringify(values)}`);
        }
        await close(page);
    }
}

async function tryOneLiveFigure(from) {
    const page = await opened('03-sphere.html', {}, from);
    await page.locator('figure.live').first().scrollIntoViewIfNeeded();
    await page.locator('figure.live.runs').first().waitFor();
    await close(page);
}

function tryLiveFigureCount() {
    const figures = pages.flatMap(liveOn);
    for (const chapter of ['01', '02', '03', '04', '05', '06', '07', '08', '11', '12', '14']) {
        const count = figures.filter(figure => figure.startsWith(`${chapter}.`)).length;
        check(count >= 2, `chapter ${chapter} has ${count} live figures, fewer than 2`);
    }
    for (const chapter of ['00', '09', '10', '13'])
        check(figures.some(figure => figure.startsWith(chapter)), `chapter ${chapter} has no live figure`);
    if (!hasLiveFigures) console.log('skipped: live figures, which need Emscripten');
}

// The book as a host may serve it, below a path.
async function underPath(path, use) {
    const types = { html: 'text/html', css: 'text/css', js: 'text/javascript', png: 'image/png',
                    svg: 'image/svg+xml', webp: 'image/webp', woff2: 'font/woff2' };
    const server = createServer((request, response) => {
        const { pathname } = new URL(request.url, 'http://host');
        const file = join(folder, decodeURIComponent(pathname.slice(path.length)));
        if (!pathname.startsWith(path) || !existsSync(file)) return response.writeHead(404).end();
        const ending = file.split('.').at(-1), zipped = /html|css|js/.test(ending);
        response.writeHead(200, { 'content-type': types[ending] ?? 'text/plain', ...(zipped && { 'content-encoding': 'gzip' }) });
        response.end(zipped ? gzipSync(readFileSync(file)) : readFileSync(file));
    });
    await new Promise(listening => server.listen(0, '127.0.0.1', listening));
    await use(`http://127.0.0.1:${server.address().port}${path}`);
    server.close();
}

// On a phone's network, as Lighthouse has it, the largest thing at the top of a chapter is there within a second.
// What else the machine does only adds time, so the shortest of 15 loads counts.
async function tryThrottled(at) {
    const page = await opened('index.html', {}, at), client = await page.context().newCDPSession(page);
    let shown;
    for (let i = 0; i < 15 && !(shown < 1000); ++i) {
        await client.send('Network.enable');
        await client.send('Network.setCacheDisabled', { cacheDisabled: true });
        await client.send('Network.emulateNetworkConditions',
            { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: 750e3 / 8 });
        await page.goto(`${at}03-sphere.html`, { waitUntil: 'load' });
        shown = await page.evaluate(() => new Promise(resolve => new PerformanceObserver(list =>
            resolve(list.getEntries().at(-1).startTime)).observe({ type: 'largest-contentful-paint', buffered: true })));
    }
    pageShown = Math.round(shown);
    await close(page);
    assert.ok(shown < 1000, `${Math.round(shown)} ms until the largest part is shown`);
}
let pageShown;

// `./course book --serve`: a text that is saved is there again in the open page.
async function tryServe() {
    const text = join(course, 'docs/scene-files.md'), before = readFileSync(text);
    const copy = mkdtempSync(join(tmpdir(), 'served-'));
    writeFileSync(join(copy, 'index.html'), '<!DOCTYPE html><html lang="en"><link rel="icon" href="data:,"><title>The old one</title><body><h1>The old one</h1></body></html>');
    const served = spawn(process.execPath, [join(here, 'serve.mjs'), copy, '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
    try {
        const at = await new Promise(resolve => served.stdout.on('data', said => {
            const [url] = /http:\S+/.exec(said) ?? [];
            if (url) resolve(url);
        }));
        const page = await opened('', {}, at);
        await page.getByText('The old one').first().waitFor();
        writeFileSync(text, before);  // saved
        await page.locator('main h1').waitFor();
        await close(page);
    } finally {
        served.kill();
        rmSync(copy, { recursive: true });
    }
}

// A learner's page to share: one file, which needs no other.
async function trySample(name, from) {
    const page = await opened(name, { colorScheme: 'light' }, from);
    assert.deepEqual(page.asked, [from + name], 'it asks for nothing else');
    const images = await page.evaluate(async () => {
        await Promise.all([...document.images].map(image => image.decode()));
        return [...document.images].map(image => image.alt && image.naturalWidth);
    });
    check(images.every(Boolean), `${name}: a picture is broken, or has no words`);
    await page.evaluate(axe);
    // A heading's link to itself is seen only while the mouse is on the heading.
    if (await page.locator('main h2').count() > 0) await page.locator('main h2').first().hover();
    await accessible(page, name);
    await accessible(page, name, ['color-contrast']);
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await paper();
    await page.emulateMedia({ colorScheme: 'dark' });
    assert.notEqual(await paper(), light);
    await accessible(page, `${name}, dark`, ['color-contrast']);
    await page.setViewportSize({ width: 390, height: 800 });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    check(width <= 390, `${name}: ${width} pixels wide on a phone of 390`);
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('h1')).color), 'rgb(29, 31, 35)',
                 'it is printed dark on light');
    await close(page);
}

async function trySamples(samples) {
    const names = readdirSync(samples);
    assert.ok(names.length > 0);
    for (const name of names) await trySample(name, pathToFileURL(resolve(samples)).href + '/');
}

// ---- All of it -------------------------------------------------------------------------------

const behaviors = {
    ...(hasLiveFigures && {
        'code that loops or traps is survived': tryBadCode,
        'fingers scroll and tap': tryTouch,
        'workers share a picture': tryWorkers,
        'threads take turns': tryTurns,
        'figures answer what their texts ask': tryAnswers,
    }),
    'a saved text is shown again': tryServe,
    'the search finds words and leads to them': () => trySearch(root),
    'learners’ words lead to the right section': tryQueries,
    'so it does on a phone': () => trySearch(root, 390),
    'dark stays dark': tryTheme,
    'the slider moves the line between two pictures': trySlider,
    'mistakes are beside what is right': tryMistakes,
    'pictures in tables have words and equal widths': tryPictureTables,
    'code can be copied': tryCopy,
    'stars stay open': tryStars,
    'a plot says its values': tryPlot,
    'the contents open on a phone': tryContents,
    'pages can be read without scripts': tryWithoutScripts,
    'pages can be printed': tryPrint,
    'other sites can show the book': tryPublished,
    ...(process.argv[4] && { 'a learner’s page can be shared': () => trySamples(process.argv[4]) }),
    'search and live figures work below a path of a host': () => underPath('/some/path/', async at => {
        await trySearch(at);
        if (hasLiveFigures) await tryOneLiveFigure(at);
    }),
};
// These measure time, so nothing else runs meanwhile.
const timed = {
    ...(hasLiveFigures && { 'a figure is soon there': tryFirstPicture }),
    'a page is soon there': () => underPath('/', tryThrottled),
};

// For a part of them.
const { ONLY: only, EXCEPT: except } = process.env;
const isChosen = ([what]) => (!only || RegExp(only).test(what)) && (!except || !RegExp(except).test(what));
let largest = 0, live = 0;
const attempts = [
    ...Object.entries(behaviors),
    ...pages.map(name => [name, async () => {
        const { bytes, figures } = await tryPage(name);
        largest = Math.max(largest, bytes);
        live += figures;
    }]),
].filter(isChosen);
const attempt = async ([what, use]) => {
    const begin = performance.now();
    // On a busy machine, Chromium may stop drawing a page. Then all is tried once more, in a new page.
    await use().catch(error => {
        if (!/no longer draws|Timeout \d+ms exceeded/.test(error.message)) throw error;
        console.log(`${what}: ${error.message.split('\n')[0]}; tried again`);
        return use();
    }).catch(error => check(false, `${what}: ${error.message}`));
    if (process.env.TIMES) console.log(`${Math.round(performance.now() - begin)} ms: ${what}`);
};
const waiting = [...attempts];
const work = async () => {
    while (waiting.length) await attempt(waiting.shift());
};
await Promise.all([work(), work()]);
for (const one of Object.entries(timed).filter(isChosen)) await attempt(one);
if (!only) tryLinks();
tryLiveFigureCount();
await browser.close();

for (const fault of new Set(faults)) console.log(fault);
if (pageShown) console.log(`a page is shown after ${pageShown} ms on a slow network`);
console.log(`${pages.length} pages, the largest ${Math.round(largest / 1000)} kB without pictures; ` +
            `${links.length} links; ${live} live figures; ${attempts.length - pages.length + 2} behaviors; ${new Set(faults).size} faults`);
process.exit(faults.length ? 1 : 0);
