// Opens every page of the book in Chromium: node book/test.mjs FOLDER CHROMIUM [SAMPLES]. Pages are read from the
// folder as a person would, without a server, and some of them from a server, below a path. SAMPLES holds pages as
// learners share them.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const folder = resolve(process.argv[2]);
const root = pathToFileURL(folder).href + '/';
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const pages = readdirSync(folder).filter(name => name.endsWith('.html'));
const most = 300_000;  // bytes of a page without its pictures

const faults = [];
const check = (holds, what) => { if (!holds) faults.push(what); };

const browser = await chromium.launch({
    executablePath: process.argv[3],
    args: process.getuid() === 0 ? ['--no-sandbox'] : [],
});

// A page that remembers what it requested, and records as faults what went wrong.
async function opened(name, options = {}, from = root) {
    const context = await browser.newContext({ viewport: { width: 1300, height: 900 }, ...options });
    context.setDefaultTimeout(120_000);  // other programs may use the machine, too
    const page = await context.newPage();
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
    // Without the thousands of parts of formulas and plots, which are like the wholes that they belong to.
    const violations = await page.evaluate(async rules => (await axe.run({ exclude: ['math', '.plot > *'] }, {
        preload: false,  // it would ask for the style sheets, which pages of a folder may not
        resultTypes: ['violations'],
        ...(rules && { runOnly: rules }),
    })).violations, rules);
    for (const { id, impact, help, nodes } of violations)
        check(!['serious', 'critical'].includes(impact), `${name}: ${impact}, ${id}: ${help}: ` +
              nodes.slice(0, 3).map(node => node.html.slice(0, 120)).join(' | '));
}

async function tryPage(name) {
    const page = await opened(name);
    const found = await page.evaluate(async () => {
        const images = [...document.images];
        for (const image of images) image.loading = 'eager';
        await Promise.all(images.map(image => image.decode().catch(() => {})));
        return {
            ids: [...document.querySelectorAll('[id]')].map(element => element.id),
            links: [...document.querySelectorAll('a[href]')].map(link => link.getAttribute('href')),
            broken: images.filter(image => !image.complete || !image.naturalWidth).map(image => image.src),
            unnamed: images.filter(image => !image.alt).map(image => image.src),
            titles: document.querySelectorAll('h1').length,
        };
    });
    anchors.set(name, new Set(found.ids));
    links.push(...found.links.map(href => ({ name, href })));
    check(found.broken.length === 0, `${name}: broken pictures: ${found.broken}`);
    check(found.unnamed.length === 0, `${name}: pictures without words: ${found.unnamed}`);
    check(found.ids.length === anchors.get(name).size, `${name}: an id that occurs twice`);
    check(found.titles === 1, `${name}: ${found.titles} titles`);
    const bytes = [...new Set(page.asked)].filter(url => !/\.(png|svg)$/.test(url))
        .reduce((sum, url) => sum + statSync(new URL(url)).size, 0);
    check(bytes < most, `${name}: ${bytes} bytes without pictures`);

    await page.evaluate(axe);
    // A heading's link to itself is seen only while the mouse is on the heading.
    if (await page.locator('main h2').count() > 0) await page.locator('main h2').first().hover();
    await accessible(page, name);
    if (!/-(mistakes|studies)/.test(name)) {  // which have no colors of their own
        await page.emulateMedia({ colorScheme: 'dark' });
        await accessible(page, `${name}, dark`, ['color-contrast']);
    }

    await page.setViewportSize({ width: 390, height: 800 });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    check(width <= 390, `${name}: ${width} pixels wide on a phone of 390`);
    await close(page);
    return bytes;
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
    await page.keyboard.type('cancellat');
    const link = page.locator('search li a').first();
    await link.waitFor();
    const box = await link.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= width, 'what was found can be seen');
    const first = await link.getAttribute('href');
    await page.keyboard.press('Enter');
    await page.waitForURL(from + first);
    assert.match(await page.textContent('main'), /cancellation/);
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
    const figure = page.locator('.compare').first(), slider = figure.locator('input');
    await page.locator('details:has(.compare) > summary').first().click();
    await figure.scrollIntoViewIfNeeded();
    await page.waitForFunction(() => [...document.querySelector('.compare').querySelectorAll('img')]
        .every(image => image.complete && image.naturalWidth));
    const shown = async value => {
        await slider.fill(String(value));
        return (await figure.screenshot()).toString('base64');
    };
    const pictures = new Set([await shown(0), await shown(50), await shown(100)]);
    assert.equal(pictures.size, 3, 'each place of the slider shows another picture');
    await slider.focus();
    await page.keyboard.press('ArrowLeft');
    assert.equal(await slider.inputValue(), '99', 'the keyboard moves it');
    await close(page);
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
    await contents.getByText('05 Metal and glass').click();
    await page.waitForURL(root + '05-metal_glass.html');
    const next = page.locator('a[rel=next]'), previous = page.locator('a[rel=prev]');
    const here = page.url();
    await next.click();
    await previous.click();
    assert.equal(page.url(), here, 'next, then previous');
    await close(page);
}

async function tryWithoutScripts() {
    const page = await opened('03-sphere.html', { javaScriptEnabled: false });
    const figure = page.locator('.compare').first();
    assert.equal(await figure.locator('input').isVisible(), false);
    for (const moving of await page.locator('.live .moving').all())
        assert.equal(await moving.isVisible(), false, 'live figures are still');
    const [left, right] = await Promise.all([0, 1].map(i => figure.locator('img').nth(i).boundingBox()));
    assert.ok(left.x + left.width <= right.x, 'both pictures stand beside each other');
    assert.equal(await page.locator('math').first().isVisible(), true);
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

async function tryLiveFigures(name) {
    const page = await opened(name);
    for (const live of liveOn(name)) {
        const figure = page.locator(`[data-live="${live}"]`), canvas = figure.locator('canvas');
        const says = what => `${name}: live figure ${live} ${what}`;
        await figure.scrollIntoViewIfNeeded();
        await page.waitForFunction(live => document.querySelector(`[data-live="${live}"].runs`), live, { timeout: 30_000 })
            .catch(() => {});
        if (!await canvas.isVisible()) {
            check(false, says('does not run'));
            continue;
        }
        await canvas.scrollIntoViewIfNeeded();
        // What is shown, and whether an answer is still on its way.
        const state = () => figure.evaluate(element => ({
            values: element.figure.values.join(), pixels: element.querySelector('canvas').toDataURL(),
            waits: Boolean(element.figure.waiting),
        }));
        const changed = async (before, by) => {
            for (let i = 0; i < 200; ++i) {
                const now = await state();
                if (!now.waits && now.values !== before.values && now.pixels !== before.pixels) return;
                await page.waitForTimeout(25);
            }
            check(false, says(`does not change by ${by}`));
        };
        let before = await state();
        const control = figure.locator('[data-control]').first();
        await control.focus();
        const atEnd = await control.evaluate(input => input.type === 'range' && +input.value >= +input.max);
        await page.keyboard.press(await control.evaluate(input => input.tagName) === 'SELECT' ? 'ArrowDown'
            : atEnd ? 'ArrowLeft' : 'ArrowRight');
        await changed(before, 'a key');

        before = await state();
        const [x, y, radius] = await figure.evaluate(element => element.figure.handles[0] ?? []);
        await canvas.evaluate((canvas, y) => scrollBy({
            top: canvas.getBoundingClientRect().top + Math.max(0, y) - 300, behavior: 'instant',
        }), y);
        const box = await canvas.boundingBox();
        check(x !== undefined, says('has nothing to drag'));
        const from = radius < 0 ? { x: box.x + box.width / 2, y: box.y + box.height / 3 } : { x: box.x + x, y: box.y + y };
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        await page.mouse.move(from.x + 40, from.y + 25, { steps: 4 });
        await page.mouse.up();
        await changed(before, 'dragging');

        await figure.locator('[type=reset]').click();
        await page.waitForFunction(live => !document.querySelector(`[data-live="${live}"]`).figure.waiting, live);
        check(await figure.locator('.said').textContent() !== '', says('says nothing'));

        await page.emulateMedia({ media: 'print' });
        check(!await canvas.isVisible(), says('is printed'));
        check(await figure.locator('.still').count() === 0 || await figure.locator('.still').isVisible(),
              says('has no still picture in print'));
        await page.emulateMedia({ media: 'screen' });
    }
    const bytes = [...new Set(page.asked)].filter(url => url.startsWith('file:') && !/\.(png|svg)$/.test(url))
        .reduce((sum, url) => sum + statSync(new URL(url)).size, 0);
    check(bytes < most, `${name}: ${bytes} bytes with its live figures`);
    await page.evaluate(axe);
    // A heading's link to itself is seen only while the mouse is on the heading.
    if (await page.locator('main h2').count() > 0) await page.locator('main h2').first().hover();
    await accessible(page, name);
    await page.emulateMedia({ colorScheme: 'dark' });
    await accessible(page, `${name}, dark`, ['color-contrast']);
    await page.setViewportSize({ width: 390, height: 800 });
    await page.waitForTimeout(300);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    check(width <= 390, `${name}: ${width} pixels wide with its live figures on a phone of 390`);

    // The first picture of the page's first figure: within 0.3 s, or longer on a busy machine.
    let first, limit;
    for (let i = 0; i < 4 && !(first <= limit); ++i) {
        await page.reload();
        const figure = page.locator('figure.live').first();
        await figure.scrollIntoViewIfNeeded();
        await page.waitForFunction(() => document.querySelector('figure.live').dataset.first);
        first = +await figure.getAttribute('data-first');
        limit = 300 * Math.max(1, await workerAnswers(page) / 40);
    }
    check(first <= limit, `${name}: ${first} ms until the first picture`);
    await close(page);
    return liveOn(name).length;
}

async function tryOneLiveFigure(from) {
    const page = await opened('03-sphere.html', {}, from);
    await page.locator('figure.live').first().scrollIntoViewIfNeeded();
    await page.locator('figure.live.runs').first().waitFor();
    await close(page);
}

async function tryAllLiveFigures() {
    const figuresOf = new Map(pages.map(name => [name, liveOn(name)]).filter(([, figures]) => figures.length));
    for (let chapter = 1; chapter <= 8; ++chapter) {
        const count = [...figuresOf.values()].flat().filter(figure => figure.startsWith(`0${chapter}.`)).length;
        check(count >= 2, `chapter 0${chapter} has ${count} live figures, fewer than 2`);
    }
    if (!hasLiveFigures) return console.log('skipped: live figures, which need Emscripten'), 0;
    let count = 0;
    for (const name of figuresOf.keys())
        count += await tryLiveFigures(name).catch(error => check(false, `${name}: ${error.message}`)) ?? 0;
    return count;
}

// The book as a host may serve it, below a path.
async function underPath(path, use) {
    const types = { html: 'text/html', css: 'text/css', js: 'text/javascript', png: 'image/png',
                    svg: 'image/svg+xml', woff2: 'font/woff2' };
    const server = createServer((request, response) => {
        const { pathname } = new URL(request.url, 'http://host');
        const file = join(folder, decodeURIComponent(pathname.slice(path.length)));
        if (!pathname.startsWith(path) || !existsSync(file)) return response.writeHead(404).end();
        response.writeHead(200, { 'content-type': types[file.split('.').at(-1)] ?? 'text/plain' });
        response.end(readFileSync(file));
    });
    await new Promise(listening => server.listen(0, '127.0.0.1', listening));
    await use(`http://127.0.0.1:${server.address().port}${path}`);
    server.close();
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
    'the search finds a word and leads to it': () => trySearch(root),
    'so it does on a phone': () => trySearch(root, 390),
    'dark stays dark': tryTheme,
    'the slider uncovers the other picture': trySlider,
    'a plot says its values': tryPlot,
    'the contents open on a phone': tryContents,
    'pages can be read without scripts': tryWithoutScripts,
    'pages can be printed': tryPrint,
    ...(process.argv[4] && { 'a learner’s page can be shared': () => trySamples(process.argv[4]) }),
    'search and live figures work below a path of a host': () => underPath('/some/path/', async at => {
        await trySearch(at);
        if (hasLiveFigures) await tryOneLiveFigure(at);
    }),
};

let largest = 0;
const waiting = [...pages];
const worker = async () => {
    for (let name; (name = waiting.shift());)
        largest = Math.max(largest, await tryPage(name).catch(error => check(false, `${name}: ${error.message}`)) ?? 0);
};
await Promise.all([worker(), worker()]);
tryLinks();
for (const [what, attempt] of Object.entries(behaviors))
    await attempt().catch(error => check(false, `${what}: ${error.message}`));
const live = await tryAllLiveFigures();
await browser.close();

for (const fault of new Set(faults)) console.log(fault);
console.log(`${pages.length} pages, the largest ${Math.round(largest / 1000)} kB without pictures; ` +
            `${links.length} links; ${live} live figures; ${Object.keys(behaviors).length} behaviors; ${new Set(faults).size} faults`);
process.exit(faults.length ? 1 : 0);
