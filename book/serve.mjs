// Serves the book and makes it again whenever a file that it is made from changes; open pages then load again:
// node book/serve.mjs FOLDER PORT [OPTIONS of build.mjs]. With PORT 0 the system chooses one.
import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const [folder, port, ...options] = process.argv.slice(2);
const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml', '.webp': 'image/webp',
                '.woff2': 'font/woff2' };

const open = new Set();  // pages that wait for news
const again = '<script>new EventSource("/news").onmessage = () => location.reload()</script></body>';

const server = createServer(({ url }, response) => {
    const { pathname } = new URL(url, 'http://host');
    if (pathname === '/news') {
        response.writeHead(200, { 'content-type': 'text/event-stream', 'cache-control': 'no-store' });
        response.write('\n');
        open.add(response);
        response.on('close', () => open.delete(response));
        return;
    }
    const file = join(folder, normalize(decodeURIComponent(pathname === '/' ? '/index.html' : pathname)));
    if (!existsSync(file) || statSync(file).isDirectory()) return response.writeHead(404).end('There is no such page.');
    const content = readFileSync(file);
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain; charset=utf-8', 'cache-control': 'no-store' });
    response.end(extname(file) === '.html' ? content.toString().replace('</body>', again) : content);
}).listen(+port, '127.0.0.1', () =>
    console.log(`The book is at http://127.0.0.1:${server.address().port}/ until you press Ctrl-C.`));
server.on('error', error => {
    console.error(error.code === 'EADDRINUSE' ? `course: port ${port} is in use: end the program that uses it` : `course: ${error.message}`);
    process.exit(1);
});

// When the newest of the files changed, and how many there are. Looking is cheap, and works on every system.
const watched = ['README.md', 'course.json', 'docs', 'tests/mistakes', 'book', 'solutions', 'chapters', 'common', 'build/mine'];
function newest(path) {
    if (!existsSync(path)) return [0, 0];
    const stat = statSync(path);
    if (!stat.isDirectory()) return [stat.mtimeMs, 1];
    return readdirSync(path).filter(name => name !== 'node_modules').map(name => newest(join(path, name)))
        .reduce(([time, count], [t, c]) => [Math.max(time, t), count + c], [0, 0]);
}
const state = () => watched.map(path => newest(join(root, path))).join();

let built = state(), builds = false;
setInterval(() => {
    const now = state();
    if (builds || now === built) return;
    built = now;
    builds = true;
    spawn(process.execPath, [join(root, 'book/build.mjs'), resolve(folder), ...options], { stdio: 'inherit' })
        .on('close', code => {
            builds = false;
            if (code === 0) for (const page of open) page.write('data: new\n\n');
        });
}, 500);
