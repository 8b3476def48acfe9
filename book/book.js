// What the pages do beyond being read. Everything else works without this script.
'use strict';

const root = document.documentElement;
root.classList.add('scripted');
const stored = {
    get: () => { try { return localStorage.getItem('theme'); } catch { return null; } },
    set: theme => { try { localStorage.setItem('theme', theme); } catch { /* not remembered */ } },
};
if (stored.get()) root.dataset.theme = stored.get();  // before anything is drawn

function themeButton() {
    const button = document.querySelector('.theme');
    const system = matchMedia('(prefers-color-scheme: dark)');
    const isDark = () => (root.dataset.theme ?? (system.matches ? 'dark' : 'light')) === 'dark';
    const name = () => { button.textContent = isDark() ? 'Light' : 'Dark'; };
    button.hidden = false;
    button.addEventListener('click', () => {
        stored.set(root.dataset.theme = isDark() ? 'light' : 'dark');
        name();
    });
    system.addEventListener('change', name);
    name();
}

// The index is large, so it is loaded only when somebody is about to search.
let index;
function loadIndex() {
    index ??= new Promise((resolve, reject) => {
        const script = document.createElement('script');
        script.src = 'assets/search.js';
        script.onload = () => resolve(MiniSearch.loadJSON(window.bookIndex,
            { fields: ['text', 'words'], storeFields: ['text', 'page', 'start'] }));
        script.onerror = reject;
        document.head.append(script);
    });
    return index;
}

function search() {
    const input = document.querySelector('search input'), list = document.querySelector('search ol');
    const element = (name, text) => Object.assign(document.createElement(name), { textContent: text });
    input.addEventListener('focus', loadIndex);
    input.addEventListener('input', async () => {
        const found = (await loadIndex()).search(input.value, { prefix: true, fuzzy: 0.15, boost: { text: 4 } });
        list.replaceChildren(...found.slice(0, 12).map(({ id, text, page, start }) => {
            const link = Object.assign(document.createElement('a'), { href: id });
            link.append(element('strong', text), element('small', page), element('span', start));
            const item = document.createElement('li');
            item.append(link);
            return item;
        }));
        if (input.value && !found.length) list.append(element('li', 'Nothing found'));
        list.hidden = !input.value;
    });
    document.addEventListener('keydown', event => {
        const typing = /^(input|textarea|select)$/i.test(event.target.tagName ?? '');
        if (event.key === '/' && !typing) {
            event.preventDefault();
            input.focus();
        } else if (event.key === 'Escape') {
            list.hidden = true;
        } else if (event.key === 'Enter' && event.target === input) {
            list.querySelector('a')?.click();
        }
    });
    document.addEventListener('click', event => {
        if (!event.target.closest('search input')) list.hidden = true;
    });
}

function sliders() {
    for (const slider of document.querySelectorAll('.compare input'))
        slider.addEventListener('input', () => slider.parentElement.style.setProperty('--at', `${slider.value}%`));
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

// Whatever is wider than the page can be scrolled with the keyboard.
function scrolling() {
    for (const wide of document.querySelectorAll('.scroll'))
        if (wide.scrollWidth > wide.clientWidth) wide.tabIndex = 0;
}

document.addEventListener('DOMContentLoaded', () => {
    for (const begin of [themeButton, search, sliders, plots, folds, scrolling]) begin();
    document.querySelector('nav [aria-current]')?.scrollIntoView({ block: 'nearest' });
});
