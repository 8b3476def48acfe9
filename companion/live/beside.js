'use strict';

// In the pages of the book, beside `./course watch`: a link to the learner's work, the ticks of the exercises that pass,
// and a note of the section that is read.
(() => {
    const back = Object.assign(document.createElement('a'), { href: '../', textContent: 'Your work' });
    document.querySelector('header .title')?.after(back);

    const tick = passed => {
        for (const link of document.querySelectorAll('#contents .outline .level3 > a')) {
            const [id] = link.textContent.replace('passed: ', '').split(' ');
            link.querySelector('.tick')?.remove();
            if (!passed.includes(id)) continue;
            const mark = Object.assign(document.createElement('span'), { className: 'tick', title: 'Your answer passes' });
            mark.append(Object.assign(document.createElement('span'), { className: 'aside', textContent: 'passed: ' }));
            link.prepend(mark);
        }
    };
    const renew = () => fetch('../state').then(answer => answer.json()).then(({ passed }) => tick(passed)).catch(() => {});
    renew();
    document.addEventListener('visibilitychange', () => {
        if (!document.hidden) renew();
    });

    let noted;
    const note = () => {
        const headings = [...document.querySelectorAll('main :is(h2, h3)[id]')];
        const section = headings.findLast(heading => heading.getBoundingClientRect().top < innerHeight / 3)?.id ?? '';
        if (section === noted) return;
        noted = section;
        const page = location.pathname.split('/').at(-1) || 'index.html';
        fetch(`../at?page=${encodeURIComponent(page)}&section=${encodeURIComponent(section)}`).catch(() => {});
    };
    let soon;
    addEventListener('scroll', () => {
        clearTimeout(soon);
        soon = setTimeout(note, 1000);
    }, { passive: true });
})();
