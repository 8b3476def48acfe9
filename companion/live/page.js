'use strict';

const at = id => document.getElementById(id);

// Each text of the course becomes a text of the page: none of it is read as HTML.
function tell(id, parts) {
    const now = JSON.stringify(parts);
    if (at(id).dataset.said === now) return;  // or a screen reader would say it again
    at(id).dataset.said = now;
    at(id).replaceChildren(...parts.map(([color, text]) =>
        color ? Object.assign(document.createElement('span'), { className: color, textContent: text }) : text));
}
const say = (id, text) => tell(id, text ? [['', text]] : []);

function link(id, href, text) {
    at(id).hidden = !href;
    if (href) at(id).href = href;
    if (text) at(id).textContent = text;
}

const ask = wish => fetch(wish).catch(() => {});

function showTicks({ ticks, exercise }) {
    at('ticks').replaceChildren(...ticks.map(({ id, title, symbol, words, passes }) => {
        const item = document.createElement('li'), mark = document.createElement('b'), more = document.createElement('small');
        mark.textContent = passes ? '✓' : symbol;
        mark.setAttribute('aria-hidden', 'true');
        more.textContent = ` ${words}`;
        item.append(mark, `${id} ${title}`, more);
        item.dataset.passes = passes;
        if (id === exercise) item.className = 'here';
        return item;
    }));
}

function showHints({ hints, exercise }) {
    const { shown, count } = hints ?? { shown: [], count: 0 };
    if (at('hints').childElementCount !== shown.length || at('hints').dataset.of !== exercise) {
        at('hints').dataset.of = exercise;
        at('hints').replaceChildren(...shown.map(text => Object.assign(document.createElement('li'), { textContent: text })));
    }
    at('hint').hidden = shown.length >= count;
    at('hint').textContent = shown.length ? 'Show another hint' : 'Show a hint';
    at('hint').onclick = () => ask(`hint?of=${encodeURIComponent(exercise)}`);
}

// A picture replaces the one before only when it is there.
async function load(id, number) {
    const image = new Image();
    image.src = `${id}.png?number=${number}`;
    await image.decode();
    at(id).src = image.src;
    at(id).width = image.naturalWidth;
    at(id).height = image.naturalHeight;
}

let number;
async function showPicture({ picture }) {
    const { shown, whose, trouble, waits, seconds, words, isOld, isFine, isDone, shows, show, told, path } = picture;
    at('picture').textContent = show ? `Your picture: ${show}` : 'Your picture';
    say('whose', whose);
    say('trouble', trouble);
    at('draw').hidden = !waits;
    at('draw').textContent = `Draw it at each save, which takes about ${seconds} s of processor time`;
    document.querySelector('.compare').classList.toggle('old', isOld);
    say('words', isOld ? shown.includes('mine') ? 'This is the picture of an earlier save.' : ''
        : words && (words + (isFine || isDone ? '' : '\nA finer picture follows.')));
    at('shows').replaceChildren(...(shows.length ? ['', ...shows] : []).map(word => {
        const button = Object.assign(document.createElement('button'), { type: 'button', textContent: word || 'picture' });
        button.setAttribute('aria-pressed', word === show);
        button.onclick = () => ask(`show?what=${word}`);
        return button;
    }));
    at('ask-light').hidden = !shown.includes('mine') || isOld;
    say('told', told);
    at('told').hidden = !told;
    at('path').hidden = !path;
    if (path) at('path').src = `path.svg?number=${path}`;
    if (picture.number === number) return;
    number = picture.number;
    delete at('look').dataset.number;  // until all of them are there
    const has = name => shown.includes(name);
    try {
        await Promise.all(shown.map(name => load(name, picture.number)));
    } catch {  // a newer one has come
        return;
    }
    at('counts').hidden = !has('counts_expected');
    document.querySelector('.compare').hidden = !has('mine');
    document.querySelector('.pair').classList.toggle('alone', !has('solution'));
    document.querySelector('.compare label').hidden = !has('solution');
    at('apart').hidden = !has('difference') || words.startsWith('The same');
    at('look').dataset.number = picture.number;
}

let latest = 0;
async function renew() {
    const turn = ++latest;
    const answer = await fetch('state');
    const state = await answer.json();
    if (turn !== latest) return;
    at('lost').hidden = true;
    document.title = `${state.checked ? state.checked.split(' ')[0] + ' · ' : ''}Your work`;
    say('chapter', state.chapter ?? '');
    at('says').textContent = state.checked || 'Your work';
    tell('verdict', state.verdict.length || state.checking ? state.verdict.length ? state.verdict : [['dim', 'Checking …']]
        : [['dim', 'Save a file in exercises/ to check it.']]);
    at('verdict').setAttribute('aria-busy', state.checking);
    tell('next', state.next);
    link('section', state.link);
    link('book', state.link && 'book/index.html');
    link('reading', state.reading?.link, state.reading && `Continue reading: ${state.reading.title}`);
    say('contract', state.contract ?? '');
    at('contract').hidden = at('contract-of').hidden = !state.contract;
    showHints(state);
    showTicks(state);
    await showPicture(state);
}

// Only a page that is seen listens: pictures are drawn for nobody else.
let news;
function listen() {
    news?.close();
    news = undefined;
    if (document.hidden) return;
    news = new EventSource('news');
    news.onmessage = () => renew().catch(() => {});
    news.onerror = () => { at('lost').hidden = false; };
}
document.addEventListener('visibilitychange', listen);
listen();

slide(document.querySelector('.compare'));
document.querySelector('.pair').addEventListener('dblclick', event => {
    const { naturalWidth, naturalHeight } = at('mine'), box = at('mine').getBoundingClientRect();
    const column = Math.floor((event.clientX - box.left) / box.width * naturalWidth);
    const row = Math.floor((event.clientY - box.top) / box.height * naturalHeight);
    ask(`follow?x=${column}&y=${row}`);
});
