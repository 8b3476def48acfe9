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
]).finally(() => root.classList.remove('unpacks'));

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

// Identifiers and numbers of exercises are one word each.
const words = text => text.match(/\p{N}+(?:\.\p{N}+)+|[\p{L}\p{N}_]+/gu) ?? [];

// The sections are many, so they are loaded only when somebody is about to search.
let loading;
function load() {
    loading ??= new Promise((resolve, reject) => {
        const script = document.createElement('script');
        script.src = 'assets/search.js';
        script.onload = () => {
            const index = new MiniSearch({ fields: ['text', 'words', 'code'], tokenize: words });
            index.addAll(window.bookSections);
            resolve({ index, sections: new Map(window.bookSections.map(section => [section.id, section])) });
        };
        script.onerror = reject;
        document.head.append(script);
    });
    return loading;
}

// Sections with all words: first those that have them exactly, then those with words that begin so; if there is none of
// these, those in which a letter is another. Chapters come before what belongs to them.
function find(index, query) {
    const search = options => index.search(query, {
        combineWith: 'AND', boost: { text: 4, words: 1.5 },
        boostDocument: id => /-(mistakes|studies)\.html/.test(id) ? 0.4 : 1, ...options });
    const found = new Map(search({}).map(one => [one.id, one]));
    for (const one of search({ prefix: true })) if (!found.has(one.id)) found.set(one.id, one);
    return found.size > 0 ? [...found.values()] : search({ fuzzy: term => term.length > 3 && 1 });
}

// The part of a section where the first of the terms is, with all of them marked.
function excerpt({ words, code }, terms) {
    const either = new RegExp(`(?<![\\p{L}\\p{N}_])(?:${terms.map(term => term.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')).join('|')})(?![\\p{L}\\p{N}_])`, 'giu');
    const text = [words, code].find(one => one.search(either) >= 0) ?? words;
    const at = text.search(either), from = at < 50 ? 0 : text.indexOf(' ', at - 40) + 1;
    const shown = (from > 0 ? '… ' : '') + text.slice(from, from + 150);
    const parts = [];
    let last = 0;
    for (const match of shown.matchAll(either)) {
        parts.push(shown.slice(last, match.index),
                   Object.assign(document.createElement('mark'), { textContent: match[0] }));
        last = match.index + match[0].length;
    }
    return [...parts, shown.slice(last)];
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
            await navigator.clipboard.writeText(code.querySelector('code').textContent);
            button.textContent = 'Copied';
            setTimeout(() => { button.textContent = 'Copy'; }, 1500);
        });
        code.append(button);
    }
}

// The line between two pictures moves with the slider's thumb, and with the pointer on them.
function sliders() {
    for (const figure of document.querySelectorAll('.compare')) {
        const slider = figure.querySelector('input'), pair = figure.querySelector('.pair');
        const [wrong, right] = figure.querySelectorAll('.word');
        const show = () => {
            figure.style.setProperty('--at', `${slider.value}%`);
            wrong?.style.setProperty('--seen', +(slider.value > 15));
            right?.style.setProperty('--seen', +(slider.value < 85));
        };
        slider.addEventListener('input', show);
        const drag = event => {
            const box = pair.getBoundingClientRect();
            slider.value = 100 * (event.clientX - box.left) / box.width;
            show();
        };
        pair.addEventListener('pointerdown', event => {
            if (event.button !== 0) return;
            if (event.pointerType === 'mouse') event.preventDefault();  // else it would drag the image
            pair.setPointerCapture(event.pointerId);
            if (event.pointerType !== 'touch') drag(event);
        });
        pair.addEventListener('pointermove', event => {
            if (pair.hasPointerCapture(event.pointerId)) drag(event);
        });
        pair.addEventListener('dragstart', event => event.preventDefault());
    }
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

// Whatever is wider than the page can be scrolled with the keyboard, and a table says so.
function scrolling() {
    for (const wide of document.querySelectorAll('.scroll')) {
        if (wide.scrollWidth <= wide.clientWidth) continue;
        wide.tabIndex = 0;
        if (wide.matches('pre') || !wide.querySelector('table')) continue;
        wide.before(Object.assign(document.createElement('p'), { className: 'scrolls', textContent: 'This table scrolls sideways →' }));
        wide.setAttribute('role', 'region');
        wide.setAttribute('aria-label', 'Table that scrolls sideways');
    }
}

document.addEventListener('DOMContentLoaded', () => {
    for (const begin of [themeButton, stars, search, copying, sliders, plots, folds, scrolling]) begin();
    document.querySelector('nav [aria-current]')?.scrollIntoView({ block: 'nearest' });
    contents();
});
