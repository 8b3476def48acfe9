// Compiles one live figure and photographs it: node book/live/try.mjs 03.roots shot.png [name=value ...]
//     --dark, --width PIXELS (of the page, 900), --wait SECONDS (1), --drag x0,y0,x1,y1 (pixels of the figure)
// It prints how long the first picture took, what the figure says, and what went wrong.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { figure, find, modules, pageScript } from '../live.mjs';

const book = dirname(dirname(fileURLToPath(import.meta.url))), root = dirname(book);
const { values: options, positionals: [name, picture = 'out/live.png', ...settings] } = parseArgs({
    allowPositionals: true,
    options: { dark: { type: 'boolean' }, width: { type: 'string', default: '900' },
               wait: { type: 'string', default: '1' }, drag: { type: 'string' } },
});
if (!name || !find(name)) throw new Error(`no live figure has the name ${name}`);

const chapter = name.slice(0, 2);
const chapters = JSON.parse(readFileSync(join(root, 'course.json'))).chapters
    .map(one => ({ ...one, number: one.name.slice(0, 2) }));
const compiled = await modules([chapter], chapters, join(root, 'out/book-cache')).catch(error => {
    console.log(error.message);
    process.exit(1);
});
if (!compiled) throw new Error('emcc is missing');

const folder = mkdtempSync(join(tmpdir(), 'live-'));
mkdirSync(join(folder, 'assets'));
const { script, shown } = compiled.get(chapter);
writeFileSync(join(folder, `assets/live-${chapter}.js`), script);
writeFileSync(join(folder, 'assets/live.js'), pageScript());
writeFileSync(join(folder, 'index.html'), `<!DOCTYPE html><html lang="en"><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>${name}</title>
${['palette.css', 'book.css'].map(name => `<link rel="stylesheet" href="${pathToFileURL(join(book, name)).href}">`).join('')}
<script src="assets/live.js"></script>
<body style="display: block"><main>${figure(name, '<p>The still picture</p>', shown[name.slice(3)])}</main>`);

const chromiumPath = process.env.CHROMIUM ?? execFileSync('which', ['chromium'], { encoding: 'utf8' }).trim();
const browser = await chromium.launch({ executablePath: chromiumPath,
                                        args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
const page = await browser.newPage({ viewport: { width: +options.width, height: 800 },
                                     colorScheme: options.dark ? 'dark' : 'light',
                                     deviceScaleFactor: +options.width < 500 ? 2 : 1 });
page.on('console', said => console.log('console:', said.text()));
page.on('pageerror', error => console.log('error:', error.message));
await page.goto(pathToFileURL(join(folder, 'index.html')).href);
const live = page.locator('figure.live');
await page.waitForFunction(() => document.querySelector('.runs'), undefined, { timeout: 20_000 })
    .catch(() => console.log('it does not run'));
for (const setting of settings) {
    const [control, value] = setting.split('=');
    await live.locator(`[data-control=${control}]`).evaluate((input, value) => {
        input.value = value;
        input.dispatchEvent(new Event('input', { bubbles: true }));
    }, value);
}
if (options.drag) {
    const [x0, y0, x1, y1] = options.drag.split(',').map(Number), box = await live.locator('canvas').boundingBox();
    await page.mouse.move(box.x + x0, box.y + y0);
    await page.mouse.down();
    await page.mouse.move(box.x + x1, box.y + y1, { steps: 5 });
    await page.mouse.up();
}
await page.waitForTimeout(1000 * +options.wait);
console.log(`first picture after ${await live.getAttribute('data-first')} ms; ` +
            `${Math.round(script.length / 1000)} kB; page ` +
            `${await page.evaluate(() => document.documentElement.scrollWidth)} pixels wide`);
console.log(await live.locator('.said').textContent());
await live.screenshot({ path: picture });
await browser.close();
rmSync(folder, { recursive: true });
