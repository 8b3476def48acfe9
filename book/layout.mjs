// One page of the book around its text.
import { escape } from './markdown.mjs';

// In the contents, a part of a chapter is below it, and needs no number.
const entry = (page, current) =>
    `<li${page.parent ? ' class="part"' : ''}><a href="${page.out}"${page === current ? ' aria-current="page"' : ''}>` +
    `${escape(page.parent ? page.name.slice(3) : page.name)}</a>`;

const tick = '<span class="tick" title="Your answer passes"><span class="aside">passed: </span></span>';

// The sections of the current page, and the exercises in them.
function outline(page, passed) {
    const items = page.headings.filter(({ level }) => level > 1).map(({ level, id, text }) =>
        `<li class="level${level}"><a href="#${id}">${passed.has(text.split(' ')[0]) ? tick : ''}` +
        `${escape(text.replace(/ \(about.*\)$/, ''))}</a></li>`);
    return items.length === 0 ? '' : `<ul class="outline">${items.join('')}</ul>`;
}

function contents(pages, current, passed) {
    let html = '', group;
    for (const page of pages) {
        if (page.parent && page.parent !== (current.parent ?? current)) continue;
        if (page.group !== group) html += `${html && '</ul>'}<h2>${escape(group = page.group)}</h2><ul>`;
        html += entry(page, current) + (page === current ? outline(page, passed) : '') + '</li>';
    }
    return html + '</ul>';
}

const step = (page, relation, arrow) => !page ? '<span></span>'
    : `<a rel="${relation}" href="${page.out}" aria-keyshortcuts="Arrow${relation === 'prev' ? 'Left' : 'Right'}"><small>${arrow}</small> ${escape(page.name)}</a>`;

// The first words of a page, for those who have only a link to it.
function description({ html }) {
    const words = /<p>([^]*?)<\/p>/.exec(html)[1].replace(/<[^>]*>/g, '').replace(/\s+/g, ' ').trim();
    return words.length < 200 ? words : words.slice(0, 200).replace(/\s\S*$/, ' …');
}

// What other sites show of a link to the page.
function meta(page, { title, url }) {
    const of = (property, content) => `<meta property="og:${property}" content="${content}">`;
    const about = description(page).replaceAll('"', '&quot;');
    const all = [`<meta name="description" content="${about}">`, of('title', escape(page.name)), of('description', about),
                 of('site_name', escape(title)), of('type', 'article')];
    if (url) all.push(`<link rel="canonical" href="${url}${page.out}">`, of('url', url + page.out),
                      of('image', `${url}assets/card.jpg`), '<meta name="twitter:card" content="summary_large_image">');
    return all.join('\n');
}

// Whether a formula may be on the first screen: what is below a second picture is not.
const beginsWithFormulas = ({ html }) => html.slice(0, 5000).split(/<(?:img|svg)/, 2).join('').includes('<math');

// A book has all pages, its title, the exercises that have passed, where it is going to be and where its sources are. If
// the live figures were not compiled, the page shows only their still pictures.
export function layout(page, book) {
    const { pages, title, passed, hasLiveFigures, sourceOf } = book;
    const live = hasLiveFigures && page.html.includes('<figure class="live') ? '\n<script src="assets/live.js"></script>' : '';
    const at = pages.indexOf(page);
    return `<!DOCTYPE html>
<html lang="en"${beginsWithFormulas(page) ? ' data-formulas' : ''}>
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${page.out === 'index.html' ? '' : escape(page.name) + ' · '}${escape(title)}</title>
${meta(page, book)}
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
<input type="search" placeholder="Search" aria-label="Search the book" autocomplete="off" role="combobox" aria-expanded="false" aria-controls="found" aria-autocomplete="list">
<ol id="found" role="listbox" aria-label="Found" hidden></ol>
</search>
${page.html.includes('<summary>★') ? '<button class="stars" aria-pressed="false">★<span class="wide-only"> open</span></button>\n' : ''}<button class="theme">Dark</button>
</header>
<nav id="contents" popover aria-label="Contents">${contents(pages, page, passed)}</nav>
<main id="text">
${page.html}
<p class="source"><a href="${sourceOf(page)}">Source of this page</a></p>
<nav class="steps" aria-label="Previous and next">
${step(pages[at - 1], 'prev', '← previous')}
${step(pages[at + 1], 'next', 'next →')}
</nav>
</main>
</body>
</html>
`;
}
