// The known mistakes of a chapter, from tests/mistakes: what is wrong, the picture that it draws, and the cure.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { escape, inlineOfTerminal, sectionsOf, typographic } from './markdown.mjs';

// The pictures of mistakes in a chapter's text: for each mistake's name, "03.2_far_side", what shows it.
export function picturesOfMistakes(text) {
    const found = new Map();
    for (const row of text.split('\n').filter(line => line.startsWith('|'))) {
        const pictures = [...row.matchAll(/!\[([^\]]*)\]\(([^)]*)\)/g)].map(([, text, src]) => ({ text, src }));
        const name = /-mistake-(\w+)\.png/.exec(pictures[0]?.src), exercise = /\*\*(\d\d\.\d+)\*\*/.exec(row);
        if (name && exercise) found.set(`${exercise[1]}_${name[1]}`, { picture: pictures[0], beside: pictures[1] });
    }
    return found;
}

// The mistakes of one file, whose form is that of companion/model/mistakes.hpp. As text they need no compiler: below a
// heading, the first paragraph has lines "key: value", and the others explain.
function mistakesOf(source) {
    return sectionsOf(source).slice(1).map(({ heading: id, paragraphs: [lines = '', ...explanation] }) => {
        const facts = Object.fromEntries(lines.split('\n').map(line => line.split(/: (.*)/s, 2)));
        if (!facts.title || !explanation.length) throw new Error(`${id}: no title, or no words for the learner`);
        return { id, title: facts.title, caught: facts['caught by'], explanation };
    });
}

// The page's parts, one for each exercise. pair(src, text, beside) shows what the mistake draws, and the right picture
// beside it.
export async function mistakesPage(chapter, folder, text, pair) {
    const shown = picturesOfMistakes(text), headings = [], sections = [];
    let html = `<h1>Known mistakes of chapter ${chapter.number}</h1>
<p>Wrong answers that people give, or might. The checkpoints catch each of them; if your answer is one of these,
<code>./course check</code> tells you so. The pictures show the part that differs.</p>\n`;
    for (const file of readdirSync(folder).filter(name => name.endsWith('.md')).sort()) {
        const id = file.slice(0, -3), exercise = chapter.exercises?.find(one => one.id === id);
        const title = exercise ? `${id} ${typographic(exercise.title)}` : id[0].toUpperCase() + id.slice(1);
        headings.push({ level: 2, id, text: title });
        html += `<h2 id="${id}">${escape(title)}</h2>\n`;
        const mistakes = mistakesOf(readFileSync(join(folder, file), 'utf8'));
        mistakes.sort((a, b) => shown.has(b.id) - shown.has(a.id));
        for (const mistake of mistakes) {
            const image = shown.get(mistake.id);
            html += `<section class="mistake" id="${escape(mistake.id)}"><div><h3>${inlineOfTerminal(mistake.title)}</h3>` +
                mistake.explanation.map(paragraph => `<p>${inlineOfTerminal(paragraph)}</p>`).join('') +
                (mistake.caught ? `<p class="caught">Caught by “${inlineOfTerminal(mistake.caught)}”</p>` : '') + '</div>' +
                (image ? await pair(image.picture.src, image.picture.text, image.beside) : '') + '</section>\n';
        }
        sections.push({ id, text: title, words: mistakes.map(m => `${m.title}. ${m.explanation.join(' ')}`).join(' ') });
    }
    return { html, headings, sections };
}
