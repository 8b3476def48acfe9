// From Markdown to HTML: what a code host shows of the texts. Formulas are set and code is highlighted now,
// so that the page needs no script for them.
import MarkdownIt from 'markdown-it';
import { tex } from '@mdit/plugin-tex';
import temml from 'temml';
import hljs from 'highlight.js/lib/common';
import GithubSlugger from 'github-slugger';
import { instance as graphviz } from '@viz-js/viz';

export const escape = text =>
    text.replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

// Every character of every formula, for the font.
export const mathLetters = new Set();

function formula(source, displayMode) {
    const math = temml.renderToString(source, { displayMode, throwOnError: true, wrap: displayMode ? 'none' : 'tex' });
    for (const letter of math.replace(/<[^>]*>/g, '')) mathLetters.add(letter);
    return displayMode ? `<div class="formula scroll">${math}</div>\n` : math;
}

const languages = { sh: 'bash', console: 'shell' };

function highlighted(code, language) {
    const name = languages[language] ?? language;
    return hljs.getLanguage(name) ? hljs.highlight(code, { language: name }).value : escape(code);
}

// The subset of Mermaid that the texts use, left to right: A["name"] --> B["name"], -.-> for dots.
const viz = await graphviz();
function graph(source, pageOf) {
    const names = new Map(), edges = [];
    for (const line of source.trim().split('\n').slice(1)) {
        const match = /^\s*(\w+)(?:\["(.*?)"\])?(?: (-->|-\.->) (\w+)(?:\["(.*?)"\])?)?$/.exec(line);
        if (!match) throw new Error(`not understood in a graph: ${line}`);
        const [, from, fromName, arrow, to, toName] = match;
        if (fromName) names.set(from, fromName);
        if (toName) names.set(to, toName);
        if (arrow) edges.push(`${from} -> ${to} [style=${arrow === '-->' ? 'solid' : 'dashed'}]`);
    }
    // Graphviz does not know the page's font: a box is as wide as its words in a wide one.
    const nodes = [...names].map(([id, name]) =>
        `${id} [label=${JSON.stringify(name)}, width=${(0.25 + 0.1 * name.length).toFixed(2)}, URL=${JSON.stringify(pageOf(name))}]`);
    const svg = viz.renderString(
        `digraph { rankdir=LR; ranksep=0.3; bgcolor=transparent; edge [arrowsize=0.7];
         node [shape=box, style=rounded, fontname="system-ui, sans-serif", fontsize=12, height=0.35, margin=0];
         ${nodes.join(';')}; ${edges.join(';')} }`, { format: 'svg' });
    const label = 'What needs what: ' + [...names.values()].join('; ');
    return `<div class="graph scroll">${svg.slice(svg.indexOf('<svg'))
        .replace(/<title>.*?<\/title>|<!--[^]*?-->| xlink:title="[^"]*"/g, '').replaceAll('xlink:href', 'href').replace(/#000000|black/g, 'currentColor')
        .replace('<svg ', `<svg role="group" aria-label="${escape(label)}" `)}</div>\n`;
}

const md = new MarkdownIt({ html: true, typographer: true }).disable('replacements').use(tex, { render: formula });
const rules = md.renderer.rules;

// What can be pasted: of a change the new lines, of a session the commands.
const pasted = {
    diff: text => text.replace(/^-.*\n/gm, '').replace(/^[+ ]/gm, ''),
    console: text => text.match(/^\$ (?:.*\\\n)*.*\n/gm)?.map(command => command.slice(2)).join(''),
};
const code = (html, copied) =>
    `<div class="code"${copied === undefined ? '' : ` data-copied="${escape(copied)}"`}><pre class="scroll"><code>${html}</code></pre></div>\n`;
rules.fence = (tokens, index, options, env) => {
    const { content, info } = tokens[index];
    return info === 'mermaid' ? graph(content, env.pageOf) : code(highlighted(content, info), pasted[info]?.(content));
};
rules.code_block = (tokens, index) => code(escape(tokens[index].content));
rules.table_open = () => '<div class="scroll"><table>\n';
// To a screen reader, a head that is a formula alone may be empty: it gets the formula's words.
rules.th_open = (tokens, index, options, env, self) => {
    const { children } = tokens[index + 1];
    const html = content => ({ type: 'html_inline', content });
    if (children.length > 0 && children.every(({ type }) => type === 'math_inline'))
        tokens[index + 1].children = [html(`<span class="aside">${escape(plain(tokens[index + 1]))}</span><span aria-hidden="true">`),
                                      ...children, html('</span>')];
    return self.renderToken(tokens, index, options);
};
rules.table_close = () => '</table></div>\n';
// A still picture, or the live figure in its place; a live figure below has no still.
const withLive = ({ meta }, still, env) => meta?.live ? env.live(meta.live, still) : still;

// Plain text with the quotes that a book has.
export const typographic = text => text.replace(/(^|[\s(])"/g, '$1“').replaceAll('"', '”').replaceAll("'", '’');

rules.html_block = rules.html_inline = (tokens, index, options, env) =>
    tokens[index].content.replace(/<!--[^]*?-->/g, '')
        .replace(/(<summary>)([^<]*)/g, (_, tag, text) => tag + typographic(text)) + withLive(tokens[index], '', env);
rules.heading_open = (tokens, index, options, env, self) => {
    env.slugger ??= new GithubSlugger();
    const token = tokens[index], text = plain(tokens[index + 1]);
    token.attrSet('id', env.slugger.slug(text));
    env.headings.push({ level: +token.tag[1], id: token.attrGet('id'), text });
    return self.renderToken(tokens, index, options);
};
rules.heading_close = (tokens, index, options, env, self) => {
    const { id, text } = env.headings.at(-1);
    return ` <a class="anchor" href="#${id}" aria-label="Link to: ${escape(text)}">#</a>` +
        self.renderToken(tokens, index, options);
};
// A line does not break at the hyphen of an option.
rules.code_inline = (tokens, index) =>
    `<code>${escape(tokens[index].content).replace(/[^\s-]*-\S{1,24}(?=\s|$)/g, '<span class="whole">$&</span>')}</code>`;
rules.image = (tokens, index, options, env, self) => {
    const token = tokens[index], { heads, ...beside } = token.meta?.beside ?? {};
    const words = heads?.map(({ children }) => self.renderInline(children, options, env)).filter(Boolean);
    const picture = env.picture(token.attrGet('src'), token.content, token.meta?.beside && beside, words);
    return withLive(token, picture, env);
};
rules.link_open = (tokens, index, options, env) => {
    const href = env.link(tokens[index].attrGet('href'));
    env.linked = href ? 'a' : 'span';
    return href ? `<a href="${escape(href)}">` : '<span>';
};
rules.link_close = (tokens, index, options, env) => `</${env.linked}>`;

// A formula as a line of text, for the search: √(b² − 4ac)/2.
function linear(source) {
    const bracketed = text => [...text].length > 1 ? `(${text})` : text, raised = '⁰¹²³⁴⁵⁶⁷⁸⁹', lowered = '₀₁₂₃₄₅₆₇₈₉';
    const digits = (text, signs, sign) =>
        /^\d+$/.test(text) ? text.replace(/\d/g, digit => signs[digit]) : text === '′' ? text : sign + bracketed(text);
    const written = {
        mfrac: (above, below) => `${bracketed(above)}/${bracketed(below)}`,
        msqrt: (...parts) => `√${bracketed(parts.join(''))}`,
        msup: (base, power) => base + digits(power, raised, '^'),
        msub: (base, index) => base + digits(index, lowered, '_'),
        msubsup: (base, index, power) => base + digits(index, lowered, '_') + digits(power, raised, '^'),
        mover: base => base,
        munder: base => base,
        mtr: (...cells) => cells.join(' ') + ' ',
    };
    const open = [{ parts: [] }];
    for (const [, close, name, text] of temml.renderToString(source).matchAll(/<(\/?)(\w+)[^>]*>|([^<]+)/g))
        if (text !== undefined) open.at(-1).parts.push(text.replace('&lt;', '<').replace('&gt;', '>').replace('&amp;', '&'));
        else if (!close) open.push({ name, parts: [] });
        else {
            const { name, parts } = open.pop(), whole = (written[name] ?? ((...all) => all.join('')))(...parts);
            open.at(-1).parts.push(name === 'mo' ? whole.replace(/^[=<>≤≥≈→∈]$/, ' $& ').replace('\u2061', ' ').replace(/[\u2062-\u2064]/g, '') : whole);
        }
    return open[0].parts.join('').replace(/[\u{1d400}-\u{1d7ff}]/gu, bold => bold.normalize('NFKC'));
}

// What a reader sees of an inline token.
function plain(token) {
    return (token.children ?? []).map(child => {
        if (child.type === 'softbreak') return ' ';
        if (/^math_/.test(child.type)) return linear(child.content);
        return child.type === 'text' || child.type === 'code_inline' ? child.content : '';
    }).join('');
}

const picturesOf = token => (token.children ?? []).filter(child => child.type === 'image');

// A picture alone is a figure, not a paragraph. Two pictures in neighboring cells of a row are one figure,
// whose second picture is beside the first.
md.core.ruler.push('pictures', ({ tokens }) => {
    for (let i = 1; i + 1 < tokens.length; ++i) {
        if (tokens[i].type !== 'inline') continue;
        const [first, ...more] = picturesOf(tokens[i]);
        if (!first || more.length) continue;
        if (tokens[i - 1].type === 'paragraph_open' && tokens[i].children.length === 1)
            tokens[i - 1].hidden = tokens[i + 1].hidden = true;
        if (tokens[i - 2]?.type !== 'tr_open') continue;
        const cells = [];  // of this row
        for (let k = i; tokens[k - 1].type === 'td_open'; k += 3) cells.push(tokens[k]);
        if (cells.filter(cell => picturesOf(cell).length).length !== 2) continue;
        const [second] = picturesOf(cells[1]);
        if (!second) continue;
        const begin = tokens.slice(0, i).findLastIndex(({ type }) => type === 'table_open');
        first.meta = { beside: { src: second.attrGet('src'), text: second.content } };
        tokens[i - 1].attrSet('colspan', '2');
        tokens.splice(i + 2, 3);
        // If the table has nothing else, no table is needed: its heads are words on the pictures.
        if (cells.length > 2 || tokens[i - 3].type !== 'tbody_open' || tokens[i + 3].type !== 'tbody_close') continue;
        first.meta.beside.heads = tokens.slice(begin, i).filter((_, k, all) => all[k - 1]?.type === 'th_open');
        tokens.splice(i + 1, 4);
        tokens.splice(begin, i - begin);
        i = begin;
    }
});

// A paragraph in italics, all of it: `open` is its first token.
function isCaption(open, inline) {
    if (open?.type !== 'paragraph_open' || open.hidden) return false;
    const [first, ...rest] = inline.children.filter(child => child.type !== 'text' || child.content);
    return first?.type === 'em_open' && rest.findIndex(child => child.type === 'em_close') === rest.length - 1;
}

// <!-- live: 03.roots --> in a paragraph of its own, below a picture: this figure takes the picture's place.
// <!-- live: 03.roots below -->: it comes below a picture and its caption, or below whatever else says the same in
// print, such as a table.
md.core.ruler.push('live', ({ tokens }) => {
    for (let i = 0; i < tokens.length; ++i) {
        const comment = tokens[i].content.trim();
        if (tokens[i].type !== 'html_block' || !comment.startsWith('<!-- live')) continue;
        const [, name, below] = /^<!-- live: (\d\d\.\w+)( below)? -->$/.exec(comment) ?? [];
        if (!name) throw new Error(`not understood: ${comment}: it must be <!-- live: 03.name --> or ` +
                                   '<!-- live: 03.name below -->, in a paragraph of its own');
        const [picture, ...more] = tokens[i - 2]?.type === 'inline' ? tokens[i - 2].children : [];
        const isPicture = picture?.type === 'image' && more.length === 0 && !picture.meta?.live;
        if (!isPicture && !below) throw new Error(`no picture alone above ${comment}`);
        if (below) {
            tokens[i].meta = { live: name };
            if (isPicture && isCaption(tokens[i + 1], tokens[i + 2]))
                throw new Error(`${comment} must come below the picture's caption`);
        } else {
            picture.meta = { ...picture.meta, live: name };
            tokens.splice(i--, 1);
        }
    }
});

// How a description begins: its first sentence, or what comes before a semicolon, or before a colon that ends more
// than a word or two.
export const beginning = text => /^.*?(?=\.(\s|$)|;\s|(?<=\S\s+\S+\s+\S+):\s|$)/s.exec(text)[0].replace(/\s+/g, ' ') + '.';

// The caption of a picture alone is the paragraph in italics below it, or else how its description begins. Plots have
// a title of their own, and so does a live figure in a picture's place.
md.core.ruler.push('captions', ({ tokens, Token }) => {
    for (let i = 1; i < tokens.length; ++i) {
        if (tokens[i].type !== 'inline') continue;
        if (isCaption(tokens[i - 1], tokens[i])) tokens[i - 1].attrJoin('class', 'caption');
        const [picture] = tokens[i].children;
        const isAlone = tokens[i - 1].type === 'paragraph_open' && tokens[i - 1].hidden && picture.type === 'image';
        if (!isAlone || picture.meta?.live || picture.attrGet('src').includes('plots/')) continue;
        if (isCaption(tokens[i + 2], tokens[i + 3])) continue;
        const caption = new Token('html_block', '', 0);
        caption.content = `<p class="caption" aria-hidden="true">${escape(typographic(beginning(picture.content)))}</p>\n`;
        tokens.splice(i + 2, 0, caption);
    }
});

// A head of a table has powers, not carets.
md.core.ruler.push('powers', ({ tokens }) => {
    for (const [i, { children }] of tokens.entries())
        if (tokens[i - 1]?.type === 'th_open')
            for (const child of children)
                if (child.type === 'text') child.content = child.content.replace(/\^(\d+)/g, (_, power) => power.replace(/\d/g, digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]));
});

// Smart quotes leave out those between a sign and a letter: C++'s.
md.core.ruler.push('apostrophes', ({ tokens }) => {
    for (const child of tokens.flatMap(({ children }) => children ?? []))
        if (child.type === 'text') child.content = child.content.replace(/(?<=\S)'(?=\p{L})/gu, '’');
});

// A line does not break between a formula and its punctuation.
md.core.ruler.push('punctuation', ({ tokens, Token }) => {
    for (const token of tokens)
        token.children = token.children?.flatMap((child, i, all) => {
            const after = one => one?.type === 'text' ? /^[.,;:!?)’”]*/.exec(one.content)[0] : '';
            const made = (type, content) => Object.assign(new Token(type, '', 0), { content });
            if (child.type === 'math_inline' && after(all[i + 1]))
                return [made('html_inline', '<span class="whole">'), child, made('text', after(all[i + 1])), made('html_inline', '</span>')];
            if (all[i - 1]?.type === 'math_inline') child.content = child.content.slice(after(child).length);
            return [child];
        }) ?? null;
});

// The parts of a text between its headings, for the search.
function sections(tokens, headings) {
    const parts = [];
    tokens.forEach((token, i) => {
        if (token.type === 'heading_open') parts.push({ ...headings[parts.length], words: [], code: [] });
        else if (!parts.length) return;
        else if (token.type === 'inline' && tokens[i - 1].type !== 'heading_open') parts.at(-1).words.push(plain(token));
        else if (token.type === 'math_block') parts.at(-1).words.push(linear(token.content));
        else if (token.type === 'fence' && token.info !== 'mermaid') parts.at(-1).code.push(token.content);
    });
    return parts.map(({ id, text, words, code }) =>
        ({ id, text, words: words.join(' ').replace(/\s+/g, ' ').trim(), code: code.join('\n') }));
}

// The sections of a text for a page of another form: each heading and the paragraphs below it, as they are written.
// Code is left out.
export function sectionsOf(source) {
    const tokens = md.parse(source, {}), sections = [];
    tokens.forEach(({ type, content }, i) => {
        if (type !== 'inline') return;
        if (tokens[i - 1].type === 'heading_open') sections.push({ heading: content, paragraphs: [] });
        else sections.at(-1)?.paragraphs.push(content);
    });
    return sections;
}

// A paragraph or a title without pictures, as HTML. If the terminal shows it, too, a star is a product or a pointer.
export const inline = source => md.renderInline(source, { link: href => href });
export function inlineOfTerminal(source) {
    md.disable('emphasis');
    try {
        return inline(source);
    } finally {
        md.enable('emphasis');
    }
}

// picture(src, text, beside, words) and link(href) decide what a picture becomes and where a link leads, if anywhere;
// live(name, still) brings the picture `still` to life, if there is one; pageOf(name) is where a box of a graph leads.
export function render(source, { picture, link, live, pageOf }) {
    const env = { headings: [], picture, link, live, pageOf };
    const tokens = md.parse(source, env);
    const html = md.renderer.render(tokens, md.options, env)
        .replace(/<thead>\s*<tr>\s*(<th[^>]*><\/th>\s*)+<\/tr>\s*<\/thead>/g, '').replace(/<th><\/th>/g, '<td></td>');
    return { html, headings: env.headings, sections: sections(tokens, env.headings) };
}
