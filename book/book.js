// What the pages do beyond being read. Everything else works without this script.
'use strict';

const root = document.documentElement;
root.classList.add('scripted');
const stored = {
    get: key => { try { return localStorage.getItem(key); } catch { return null; } },
    set(key, value) { try { localStorage.setItem(key, value); } catch { /* not remembered */ } },
};
if (stored.get('theme')) root.dataset.theme = stored.get('theme');  // before anything is drawn

// The text's faces are in the style sheet. Unpacking them takes a moment, in which nothing need be laid out twice; so does
// getting the formulas' one, which a page waits for that begins with formulas.
root.classList.add('unpacks');
const faces = ['Text', 'italic Text', 'bold Text', ...('formulas' in root.dataset ? ['STIX2'] : [])];
Promise.all([
    Promise.race([Promise.all(faces.map(face => document.fonts.load(face.replace(/\w+$/, '1rem $&')))),
                  new Promise(late => setTimeout(late, 300))]),
    new Promise(whole => document.addEventListener('DOMContentLoaded', whole)),
]).finally(() => {
    roots();
    root.classList.remove('unpacks');
    document.fonts.ready.then(roots);
});

// Chromium makes a root wider than what is under it; the rest would be a hole in the line.
function roots() {
    const all = [...document.querySelectorAll('msqrt')];
    const holes = all.map(one => (one.getBoundingClientRect().right - one.lastElementChild.getBoundingClientRect().right) /
        parseFloat(getComputedStyle(one).fontSize));
    all.forEach((one, i) => { if (holes[i] > 0.1) one.style.marginRight = `${0.05 - holes[i]}em`; });
}

function themeButton() {
    const button = document.querySelector('.theme');
    const system = matchMedia('(prefers-color-scheme: dark)');
    const isDark = () => (root.dataset.theme ?? (system.matches ? 'dark' : 'light')) === 'dark';
    const name = () => { button.textContent = isDark() ? 'Light' : 'Dark'; };
    button.addEventListener('click', () => {
        stored.set('theme', root.dataset.theme = isDark() ? 'light' : 'dark');
        name();
    });
    system.addEventListener('change', name);
    name();
}

// ---- The search ----

// Identifiers and numbers of exercises are one word each; anti-aliasing is found as antialiasing, too.
const words = text => (text.match(/\p{N}+(?:\.\p{N}+)+|[\p{L}\p{N}_]+(?:-[\p{L}\p{N}_]+)*/gu) ?? [])
    .flatMap(word => word.includes('-') ? [...word.split('-'), word.replaceAll('-', '')] : [word]);
const stopWords = new Set(('a an and are as at be but by can could did do does doing for from get has have how i if in into is it its ' +
    'make me my not of on or should so that the their them then there this to too use was what when where which why will with you your').split(' '));

// The sections are many, so they are loaded only when somebody is about to search.
let loading;
function load() {
    loading ??= new Promise((resolve, reject) => {
        const script = document.createElement('script');
        script.src = 'assets/search.js';
        script.onload = () => {
            const index = new MiniSearch({ fields: ['text', 'also', 'words', 'code'], tokenize: words });
            index.addAll(window.bookSections);
            resolve({ index, sections: new Map(window.bookSections.map(section => [section.id, section])) });
        };
        script.onerror = reject;
        document.head.append(script);
    });
    return loading;
}

// Sections with all words come first: those that have them exactly, then those with words that begin so. Then come those
// with some of them, the rarest first. A word that occurs nowhere may have another letter. Chapters come before what
// belongs to them.
function find(index, query) {
    const known = word => index.search(word, { prefix: true }).length > 0;
    const asked = query.toLowerCase().split(/\s+/).flatMap(word => {
        const joined = word.replaceAll('-', '');
        return words(word.includes('-') && known(joined) ? joined : word.replaceAll('-', ' '));
    });
    const telling = asked.filter(word => !stopWords.has(word)), terms = telling.length > 0 ? telling : asked;
    const unknown = new Set(terms.filter(word => !known(word)));
    const search = options => index.search(terms.join(' '), {
        boost: { also: 10, text: 4, words: 1.5 }, fuzzy: word => unknown.has(word) && word.length > 3 && 1,
        boostDocument: id => /-(mistakes|studies)\.html/.test(id) ? 0.4 : 1, ...options });
    const found = new Map(search({ combineWith: 'AND' }).map(one => [one.id, one]));
    for (const more of [{ combineWith: 'AND', prefix: true }, { combineWith: 'OR', prefix: true }])
        for (const one of search(more)) if (!found.has(one.id)) found.set(one.id, one);
    return [...found.values()];
}

// These words, with or without hyphens.
const either = terms => new RegExp(`(?<![\\p{L}\\p{N}_])(?:${terms.map(term =>
    [...term].map(letter => letter.replace(/[.*+?^${}()|[\]\\]/, '\\$&')).join('-?')).join('|')})(?![\\p{L}\\p{N}_])`, 'giu');

// The part of a section where the first of the terms is, with all of them marked.
function excerpt({ words, code }, terms) {
    const sought = either(terms);
    const text = [words, code].find(one => one.search(sought) >= 0) ?? words;
    const at = text.search(sought), from = at < 50 ? 0 : text.indexOf(' ', at - 40) + 1;
    const shown = (from > 0 ? '… ' : '') + text.slice(from, from + 150);
    const parts = [];
    let last = 0;
    for (const match of shown.matchAll(sought)) {
        parts.push(shown.slice(last, match.index),
                   Object.assign(document.createElement('mark'), { textContent: match[0] }));
        last = match.index + match[0].length;
    }
    return [...parts, shown.slice(last)];
}

// What was searched for is marked on the page to which it led.
function markSought() {
    const { page, terms } = JSON.parse(stored.get('sought') ?? '{}');
    if (!CSS.highlights || page !== location.pathname) return;
    stored.set('sought', '{}');
    const ranges = [];
    for (const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT); walker.nextNode();)
        for (const { 0: { length }, index } of walker.currentNode.data.matchAll(either(terms))) {
            const range = new Range();
            range.setStart(walker.currentNode, index);
            range.setEnd(walker.currentNode, index + length);
            ranges.push(range);
        }
    CSS.highlights.set('sought', new Highlight(...ranges));
}

function search() {
    const input = document.querySelector('search input'), list = document.querySelector('search ol');
    const element = (name, ...content) => {
        const made = document.createElement(name);
        made.append(...content);
        return made;
    };
    const show = open => {
        list.hidden = !open;
        input.setAttribute('aria-expanded', String(open));
    };
    const select = link => {
        list.querySelector('[aria-selected=true]')?.setAttribute('aria-selected', 'false');
        link?.setAttribute('aria-selected', 'true');
        link?.scrollIntoView({ block: 'nearest' });
        if (link) input.setAttribute('aria-activedescendant', link.id);
        else input.removeAttribute('aria-activedescendant');
    };
    input.addEventListener('focus', load);
    input.addEventListener('input', async () => {
        const query = input.value, { index, sections } = await load();
        if (query !== input.value) return;
        const found = find(index, query).slice(0, 12);
        list.replaceChildren(...found.map(({ id, terms }, i) => {
            const section = sections.get(id);
            const link = element('a', element('strong', section.text), element('small', section.page),
                                 element('span', ...excerpt(section, terms)));
            Object.assign(link, { href: id, id: `found-${i}`, tabIndex: -1 });
            link.addEventListener('click', () => {
                stored.set('sought', JSON.stringify({ page: link.pathname, terms }));
                markSought();
            });
            link.setAttribute('role', 'option');
            link.setAttribute('aria-selected', 'false');
            const item = element('li', link);
            item.setAttribute('role', 'presentation');
            return item;
        }));
        if (query && !found.length) list.append(element('li', 'Nothing found'));
        list.dataset.query = query;
        select();
        show(Boolean(query));
    });
    document.addEventListener('keydown', event => {
        const typing = /^(input|textarea|select)$/i.test(event.target.tagName ?? '');
        if (event.key === '/' && !typing) {
            event.preventDefault();
            input.focus();
        } else if (event.key === 'Escape') {
            show(false);
        } else if (event.target === input && !list.hidden) {
            const links = [...list.querySelectorAll('a')], at = links.findIndex(link => link.getAttribute('aria-selected') === 'true');
            const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
            if (event.key === 'Enter') (links[at] ?? links[0])?.click();
            if (!step || !links.length) return;
            event.preventDefault();
            select(links[at < 0 && step < 0 ? links.length - 1 : (at + step + links.length) % links.length]);
        }
    });
    document.addEventListener('click', event => {
        if (!event.target.closest('search input')) show(false);
    });
}

// ---- Around the text ----

// The section that is being read is marked in the contents, which close on a phone when one is chosen.
function contents() {
    const nav = document.querySelector('#contents');
    const links = new Map([...nav.querySelectorAll('.outline a')].map(link => [decodeURIComponent(link.hash.slice(1)), link]));
    const headings = [...document.querySelectorAll('main :is(h2, h3)[id]')].filter(heading => links.has(heading.id));
    let waits = false;
    const mark = () => {
        waits = false;
        const read = headings.filter(heading => heading.getBoundingClientRect().top < 120).at(-1);
        const link = read && links.get(read.id), before = nav.querySelector('.here');
        if (link === before) return;
        before?.classList.remove('here');
        before?.removeAttribute('aria-current');
        link?.classList.add('here');
        link?.setAttribute('aria-current', 'location');
        if (!link || !nav.checkVisibility()) return;
        const [box, own] = [link.getBoundingClientRect(), nav.getBoundingClientRect()];
        if (box.top < own.top || box.bottom > own.bottom) nav.scrollTop += box.top - own.top - own.height / 2;
    };
    addEventListener('scroll', () => {
        if (!waits) requestAnimationFrame(mark);
        waits = true;
    }, { passive: true });
    mark();
    nav.addEventListener('click', event => {
        if (event.target.closest('a') && nav.matches(':popover-open')) nav.hidePopover();
    });
}

// What is marked with a star stays folded until it is wanted; then it is open on every page.
function stars() {
    const folds = [...document.querySelectorAll('details')].filter(fold => fold.querySelector('summary').textContent.startsWith('★'));
    const button = document.querySelector('.stars');
    if (!button) return;
    const show = open => {
        for (const fold of folds) fold.open = open;
        button.setAttribute('aria-pressed', String(open));
        button.setAttribute('aria-label', open ? 'Fold the stars' : 'Open the stars');
        button.title = button.getAttribute('aria-label');
    };
    button.addEventListener('click', () => {
        const open = button.getAttribute('aria-pressed') === 'false';
        stored.set('stars', open ? 'open' : 'folded');
        show(open);
    });
    if (stored.get('stars') === 'open') show(true);
    else button.setAttribute('aria-label', button.title = 'Open the stars');
}

function copying() {
    for (const code of document.querySelectorAll('.code')) {
        const button = Object.assign(document.createElement('button'), { className: 'copy', type: 'button', textContent: 'Copy' });
        button.addEventListener('click', async () => {
            await navigator.clipboard.writeText(code.dataset.copied ?? code.querySelector('code').textContent);
            button.textContent = 'Copied';
            setTimeout(() => { button.textContent = 'Copy'; }, 1500);
        });
        code.append(button);
    }
}

function sliders() {
    for (const figure of document.querySelectorAll('.compare')) slide(figure);
}

// Paper has nothing to unfold: whatever is folded is open while the page is printed.
function folds() {
    let folded = [];
    addEventListener('beforeprint', () => {
        folded = [...document.querySelectorAll('details:not([open])')];
        for (const fold of folded) fold.open = true;
    });
    addEventListener('afterprint', () => {
        for (const fold of folded) fold.open = false;
    });
}

// The point of a plot that is nearest to the pointer shows its values below the plot. So does the one to
// which the arrow keys move.
function plots() {
    for (const figure of document.querySelectorAll('.measured')) {
        const said = Object.assign(document.createElement('output'), { textContent: 'Point at a value to read it.' });
        const marks = [...figure.querySelectorAll('g > :has(> title), .bar')];
        const say = mark => {
            figure.querySelector('.near')?.classList.remove('near');
            mark?.classList.add('near');
            if (mark) said.textContent = mark.querySelector('title').textContent;
        };
        const point = event => {
            let nearest, least = 40;
            for (const mark of marks) {
                const box = mark.getBoundingClientRect();
                const across = Math.max(box.left - event.clientX, event.clientX - box.right, 0);
                const down = Math.max(box.top - event.clientY, event.clientY - box.bottom, 0);
                if (Math.hypot(across, down) < least) [nearest, least] = [mark, Math.hypot(across, down)];
            }
            say(nearest);
        };
        figure.append(said);
        figure.tabIndex = 0;
        figure.addEventListener('pointermove', point);
        figure.addEventListener('pointerdown', point);
        figure.addEventListener('keydown', event => {
            const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
            if (!step) return;
            event.preventDefault();
            const now = marks.findIndex(mark => mark.classList.contains('near'));
            say(marks[now < 0 ? 0 : (now + step + marks.length) % marks.length]);
        });
    }
}

// The arrow keys lead to the page before and the one after, unless they move something.
function turning() {
    addEventListener('keydown', event => {
        const relation = { ArrowLeft: 'prev', ArrowRight: 'next' }[event.key];
        const plain = !(event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.defaultPrevented);
        if (relation && plain && !event.target.closest('input, select, textarea, figure, .scroll, [popover]'))
            document.querySelector(`.steps [rel=${relation}]`)?.click();
    });
}

// Whatever is wider than the page can be scrolled with the keyboard, and a table says so.
function scrolling() {
    let tables = 0;
    for (const wide of document.querySelectorAll('.scroll')) {
        if (wide.scrollWidth <= wide.clientWidth) continue;
        wide.tabIndex = 0;
        if (wide.matches('pre') || !wide.querySelector('table')) continue;
        wide.before(Object.assign(document.createElement('p'), { className: 'scrolls', textContent: 'This table scrolls sideways →' }));
        wide.setAttribute('role', 'region');
        wide.setAttribute('aria-label', `Table ${++tables} that scrolls sideways`);
    }
}

// The lake in slices is drawn from left to right, once, when half of it is to be seen. Where motion is unwanted, it stays
// as it is: see book.css.
function lake() {
    const picture = document.querySelector('img[src*="overview"]');
    if (!picture) return;
    new IntersectionObserver(([seen], observer) => {
        if (!seen.isIntersecting) return;
        picture.classList.add('drawn');
        observer.disconnect();
    }, { threshold: 0.5 }).observe(picture);
}

document.addEventListener('DOMContentLoaded', () => {
    for (const begin of [themeButton, stars, search, markSought, copying, sliders, plots, folds, turning, scrolling, lake]) begin();
    document.querySelector('nav [aria-current]')?.scrollIntoView({ block: 'nearest' });
    contents();
});
