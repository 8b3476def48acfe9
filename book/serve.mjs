// Serves the book and makes it again whenever a file that it is made from changes; open pages then load again:
// node book/serve.mjs FOLDER PORT [OPTIONS of build.mjs]. With PORT 0 the system chooses one.
import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { existsSync, readFileSync, readdirSync, realpathSync, renameSync, rmSync, statSync } from 'node:fs';
import { extname, join, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const [named, port, ...options] = process.argv.slice(2);
const folder = resolve(named);
const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml', '.webp': 'image/webp',
                '.woff2': 'font/woff2' };

const open = new Set();  // pages that wait for news
const again = '<script>new EventSource("/news").onmessage = () => location.reload()</script></body>';

// The part of an address before ? and #, decoded; nothing if it is none that a browser asks for.
function pathOf(url) {
    try {
        const path = decodeURIComponent(/^[^?#]*/.exec(url)[0]);
        return /^\/(?!\/)[^\\\0]*$/.test(path) && !path.split('/').includes('..') ? path : undefined;
    } catch {
        return undefined;
    }
}

// A file of the book; nothing if there is none, or if it lies elsewhere and a link leads there. A page may vanish at any
// time, because somebody else may make the book.
function contentOf(path) {
    try {
        const file = realpathSync(join(folder, path === '/' ? 'index.html' : path));
        return file.startsWith(realpathSync(folder) + sep) ? readFileSync(file) : undefined;
    } catch {
        return undefined;
    }
}

const server = createServer(({ method, url }, response) => {
    const refuse = (code, why, headers = {}) => response.writeHead(code, headers).end(why);
    if (method !== 'GET' && method !== 'HEAD') return refuse(405, 'Pages can be read, and no more.', { allow: 'GET, HEAD' });
    const path = pathOf(url);
    if (!path) return refuse(400, 'This is no address of a page.');
    if (path === '/news' && method === 'GET') {
        response.writeHead(200, { 'content-type': 'text/event-stream', 'cache-control': 'no-store' });
        response.write('\n');
        open.add(response);
        response.on('close', () => open.delete(response));
        return;
    }
    const content = contentOf(path), ending = path === '/' ? '.html' : extname(path);
    if (!content) return refuse(404, 'There is no such page.');
    response.writeHead(200, { 'content-type': types[ending] ?? 'text/plain; charset=utf-8', 'cache-control': 'no-store' });
    response.end(ending === '.html' ? content.toString().replace('</body>', again) : content);
}).listen(+port, '127.0.0.1', () =>
    console.log(`The book is at http://127.0.0.1:${server.address().port}/ until you press Ctrl-C.`));
server.on('error', error => {
    console.error(error.code === 'EADDRINUSE' ? `course: port ${port} is in use: end the program that uses it` : `course: ${error.message}`);
    process.exit(1);
});

// When the newest of the files changed, and how many there are. Looking is cheap, and works on every system.
const watched = ['README.md', 'course.json', 'docs', 'tests/mistakes', 'book', 'solutions', 'chapters', 'common', 'build/mine'];
function newest(path) {
    const stat = statSync(path, { throwIfNoEntry: false });
    if (!stat?.isDirectory()) return stat ? [stat.mtimeMs, 1] : [0, 0];
    return readdirSync(path).filter(name => name !== 'node_modules').map(name => newest(join(path, name)))
        .reduce(([time, count], [t, c]) => [Math.max(time, t), count + c], [0, 0]);
}
const state = () => watched.map(path => newest(join(root, path))).join();

// The new book is made beside the old one, which is shown until then.
const beside = `${folder}.new`, old = `${folder}.old`;
function swap() {
    rmSync(old, { recursive: true, force: true });
    if (existsSync(folder)) renameSync(folder, old);
    renameSync(beside, folder);
    rmSync(old, { recursive: true, force: true });
}

let built = state(), builds = false;
setInterval(() => {
    const now = state();
    if (builds || now === built) return;
    built = now;
    builds = true;
    spawn(process.execPath, [join(root, 'book/build.mjs'), beside, ...options], { stdio: 'inherit' })
        .on('close', code => {
            builds = false;
            if (code !== 0) return rmSync(beside, { recursive: true, force: true });
            swap();
            for (const page of open) page.write('data: new\n\n');
        });
}, 500);
