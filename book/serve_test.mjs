// The server of `./course book --serve` survives requests that no browser sends, and shows the book and nothing else.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, unlinkSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const place = mkdtempSync(join(tmpdir(), 'served-')), book = join(place, 'book');
mkdirSync(join(book, 'assets'), { recursive: true });
writeFileSync(join(book, 'index.html'), '<body>first page</body>');
writeFileSync(join(book, 'two words.html'), '<body>second page</body>');
writeFileSync(join(place, 'secret.txt'), 'secret');
mkdirSync(join(place, 'book.beside'));
writeFileSync(join(place, 'book.beside/secret.txt'), 'secret');
symlinkSync('../secret.txt', join(book, 'link.txt'));
symlinkSync('../book.beside', join(book, 'folder'));

const served = spawn(process.execPath, [fileURLToPath(new URL('serve.mjs', import.meta.url)), book, '0'],
                     { stdio: ['ignore', 'pipe', 'inherit'] });
const port = await new Promise(resolve => served.stdout.on('data', said => resolve(/:(\d+)\//.exec(said)[1])));

// The answer to what is sent as it is: clients correct what they send.
const answer = (request, method = 'GET') => new Promise((resolve, reject) => {
    let text = '';
    connect(port, '127.0.0.1', function () { this.write(`${method} ${request} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n`); })
        .on('data', bytes => { text += bytes; }).on('end', () => resolve(text)).on('error', reject);
});
const code = async (...request) => +/^HTTP\/1.1 (\d+)/.exec(await answer(...request))?.[1];

try {
    assert.match(await answer('/'), /first page/);
    assert.match(await answer('/two%20words.html?x#y'), /second page/);
    for (const bad of ['/%', '//', '//x:99999/', '/%ff', '/%00', '*', 'http://x/', '/a\\b', '/../secret.txt', '/%2e%2e/secret.txt',
                       '/assets/../../secret.txt'])
        assert.equal(await code(bad), 400, bad);
    for (const missing of ['/none.html', '/assets', '/assets/', '/link.txt', '/folder/secret.txt'])
        assert.equal(await code(missing), 404, missing);
    for (const method of ['POST', 'DELETE', 'PUT', 'OPTIONS']) {
        assert.equal(await code('/', method), 405, method);
        assert.match(await answer('/', method), /allow: GET, HEAD/i);
    }
    const head = await answer('/', 'HEAD');
    assert.match(head, /^HTTP\/1.1 200/);
    assert.doesNotMatch(head, /first page/);
    unlinkSync(join(book, 'index.html'));
    assert.equal(await code('/'), 404);
    assert.equal(await code('/two%20words.html'), 200, 'it still serves');
} finally {
    served.kill();
    rmSync(place, { recursive: true });
}
