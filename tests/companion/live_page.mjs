// The live page in a browser: node live_page.mjs ADDRESS HEADER PROGRAM. HEADER is the file of the tiny course's first
// exercise, see live_page.py, and PROGRAM the browser's: a kind of Chromium, or Firefox.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const [address, header, executablePath] = process.argv.slice(2);
const require = createRequire(new URL('../../book/package.json', import.meta.url));
const { chromium, firefox } = require('playwright-core');
const isFirefox = /firefox/.test(executablePath);
const browser = await (isFirefox ? firefox.launch({ executablePath, channel: 'moz-firefox' })
    : chromium.launch({ executablePath, args: process.getuid() === 0 ? ['--no-sandbox'] : [] }));
const page = await browser.newPage({ viewport: { width: 1300, height: 900 } });
page.setDefaultTimeout(240_000);  // other programs may use the machine, too
const faults = [];
page.on('console', said => ['error', 'warning'].includes(said.type()) && faults.push(said.text()));
page.on('pageerror', error => faults.push(error.message));
page.on('request', request => request.url().startsWith(address) || /^(data|blob):/.test(request.url()) || faults.push(request.url()));

// The color of the first pixel of a picture, once the page shows a newer one than number.
const color = id => page.evaluate(id => {
    const image = document.getElementById(id), context = document.createElement('canvas').getContext('2d');
    context.drawImage(image, 0, 0);
    return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
}, id);
const pictureAfter = async number => {
    await page.waitForFunction(number => +document.getElementById('look').dataset.number > number &&
        document.getElementById('words').textContent !== '', number);
    return +await page.getAttribute('#look', 'data-number');
};
async function isAccessible(what) {
    const { violations } = await page.evaluate(() => axe.run());
    for (const { id, help, nodes } of violations) faults.push(`${what}: ${id}: ${help}: ${nodes[0].html.slice(0, 200)}`);
}

try {
    await page.goto(address);
    await page.locator('#next', { hasText: 'Number one' }).waitFor();
    assert.match(await page.textContent('#contract'), /^Exercise 01\.1\./);
    const before = await page.getAttribute('#look', 'data-number') ?? 0;

    writeFileSync(header, 'wrong, draws 200\ncounts 4;3 1 0 4;2 2 2 2\n');
    await page.locator('#verdict', { hasText: 'expected 2, but yours gives 3' }).waitFor();
    let number = await pictureAfter(+before);
    while ((await color('mine'))[0] !== 200) number = await pictureAfter(number);
    assert.deepEqual(await color('solution'), [10, 0, 0]);
    assert.match(await page.textContent('#whose'), /These do not pass yet, but are used anyway: 01\.1/);
    assert.match(await page.textContent('#words'), /differ/);
    assert.equal(await page.getAttribute('#ticks li >> nth=0', 'data-passes'), 'false');

    for (const id of ['counts_expected', 'counts_yours']) await page.locator(`#${id}`).waitFor();
    assert.deepEqual(await page.locator('#counts figcaption').allTextContents(), ['expected', 'yours']);
    assert.notDeepEqual(await page.getAttribute('#counts_expected', 'src'), await page.getAttribute('#counts_yours', 'src'));

    // By keyboard: the line between the pictures, what is drawn, a hint.
    const slider = page.getByLabel('From yours to the solution’s');
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await slider.inputValue(), '51');
    await page.getByRole('button', { name: 'Show a hint' }).focus();
    await page.keyboard.press('Enter');
    await page.locator('#hints li', { hasText: 'idea' }).waitFor();
    await page.getByRole('button', { name: 'normal' }).focus();
    await page.keyboard.press('Enter');
    await page.locator('[aria-pressed=true]', { hasText: 'normal' }).waitFor();
    while ((await color('mine'))[2] !== 200) number = await pictureAfter(number);
    await page.getByRole('button', { name: 'picture' }).click();
    while ((await color('mine'))[0] !== 200) number = await pictureAfter(number);

    // The light of the picture's right pixel.
    const pair = page.locator('.pair'), { x, y, width, height } = await pair.boundingBox();
    if (isFirefox)  // of which Playwright's two clicks are no double click
        await pair.dispatchEvent('dblclick', { clientX: x + 0.75 * width, clientY: y + height / 2 });
    else
        await pair.dblclick({ position: { x: 0.75 * width, y: height / 2 } });
    await page.locator('#told', { hasText: 'Pixel 1,0, sample 0' }).waitFor();
    await page.waitForFunction(() => document.getElementById('path').naturalWidth > 0);

    await page.evaluate(readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8'));
    await page.locator('#apart summary').click();
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await paper();
    await isAccessible('light');
    await page.emulateMedia({ colorScheme: 'dark' });
    if (!isFirefox) {  // which Playwright cannot ask for dark colors
        assert.notEqual(await paper(), light);
        await isAccessible('dark');
    }
    await page.setViewportSize({ width: 390, height: 800 });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390, 'it fits a phone');
    await isAccessible('phone');
    if (process.env.SHOT) await page.screenshot({ path: process.env.SHOT, fullPage: true });

    writeFileSync(header, 'right\n');
    await page.locator('#ticks li[data-passes=true]', { hasText: '01.1' }).waitFor();
    await page.locator('#next', { hasText: 'Number two' }).waitFor();
    await page.locator('#counts').waitFor({ state: 'hidden' });
    await page.locator('#words', { hasText: 'The same as the solution' }).waitFor();
    assert.deepEqual(faults, []);
} finally {
    await browser.close();
}
