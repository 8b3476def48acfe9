// One page of the book around its text.
import { escape } from './markdown.mjs';

// In the contents, a part of a chapter is below it, and needs no number.
const entry = (page, current) =>
    `<li${page.parent ? ' class="part"' : ''}><a href="${page.out}"${page === current ? ' aria-current="page"' : ''}>` +
    `${escape(page.parent ? page.name.slice(3) : page.name)}</a>`;

// The sections of the current page, and the exercises in them.
function outline(page) {
    const shown = page.headings.filter(h => h.level === 2 || (h.level === 3 && /^\d\d\.\d/.test(h.text)));
    const items = shown.map(({ level, id, text }) =>
        `<li class="level${level}"><a href="#${id}">${escape(text.replace(/ \(about.*\)$/, ''))}</a></li>`);
    return items.length === 0 ? '' : `<ul class="outline">${items.join('')}</ul>`;
}

function contents(pages, current) {
    let html = '', group;
    for (const page of pages) {
        if (page.parent && page.parent !== (current.parent ?? current)) continue;
        if (page.group !== group) html += `${html && '</ul>'}<h2>${escape(group = page.group)}</h2><ul>`;
        html += entry(page, current) + (page === current ? outline(page) : '') + '</li>';
    }
    return html + '</ul>';
}

const step = (page, relation, arrow) => !page ? '<span></span>'
    : `<a rel="${relation}" href="${page.out}"><small>${arrow}</small> ${escape(page.name)}</a>`;

// If the live figures were not compiled, the page shows only their still pictures.
export function layout(page, pages, title, hasLiveFigures) {
    const live = hasLiveFigures && page.html.includes('<figure class="live') ? '\n<script src="assets/live.js"></script>' : '';
    const at = pages.indexOf(page);
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${page.out === 'index.html' ? '' : escape(page.name) + ' · '}${escape(title)}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/formulas.css">
<link rel="stylesheet" href="assets/book.css">
<script src="assets/book.js"></script>${live}
</head>
<body>
<a class="skip" href="#text">To the text</a>
<header>
<button popovertarget="contents" class="menu">Contents</button>
<a class="title" href="index.html">${escape(title)}</a>
<search>
<input type="search" placeholder="Search" aria-label="Search the book" autocomplete="off">
<ol hidden></ol>
</search>
<button class="theme" hidden>Dark</button>
</header>
<nav id="contents" popover aria-label="Contents">${contents(pages, page)}</nav>
<main id="text">
${page.html}
<nav class="steps" aria-label="Previous and next">
${step(pages[at - 1], 'prev', 'previous')}
${step(pages[at + 1], 'next', 'next')}
</nav>
</main>
</body>
</html>
`;
}
