// The plot of a study, drawn from its table: error and cost over x, or error over cost, or bars. The point
// under the pointer shows its values. The plot shows what companion/pages/plot.cpp draws with gnuplot.
import { csvParse } from 'd3-dsv';
import { extent, group, max, ticks } from 'd3-array';
import { escape } from './markdown.mjs';

// Okabe and Ito's colors, which people with any color vision tell apart.
const colorCount = 7;

export const slug = study => study.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'study';

// The studies of a table, each with its rows.
export function studies(table) {
    const number = text => (text === 'inf' ? Infinity : text === '-inf' ? -Infinity : Number(text));
    const rows = csvParse(table, row =>
        ({ ...row, x: number(row.x), error: number(row.error), cost: number(row.cost) }));
    return group(rows, row => row.study);
}

const superscript = number => [...String(number)].map(c => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('');
function shown(value) {
    if (!Number.isFinite(value)) return '∞';
    const size = Math.abs(value);
    if (value === 0 || (size >= 0.001 && size < 1e6)) return String(+value.toPrecision(4));
    const [digits, exponent] = value.toExponential(3).split('e');
    return (+digits === 1 ? '' : `${+digits}·`) + '10' + superscript(+exponent);
}

const measured = (row, quantity) => quantity === 'x' || row[`${quantity}_name`] !== '';
const nameOf = (rows, quantity) => rows.find(row => measured(row, quantity))[`${quantity}_name`];

// A quantity's axis: logarithmic if it spans more than a factor of 16. Zero, which does not fit a logarithmic
// axis, and infinity get positions of their own at the ends.
function axisOf(rows, quantity) {
    const values = rows.filter(row => measured(row, quantity)).map(row => row[quantity]);
    const ordinary = values.filter(value => Number.isFinite(value) && value !== 0);
    const [least, most] = ordinary.length ? extent(ordinary) : [1, 1];
    const logarithmic = least > 0 && most / 16 > least;
    const [low, high] = logarithmic ? [Math.log10(least), Math.log10(most)]
                                    : [Math.min(least, 0), Math.max(most, 0)];
    const step = 0.12 * (high - low), zero = logarithmic ? low - step : 0, infinite = high + step;
    const has = { zero: logarithmic && values.includes(0), infinite: values.some(v => !Number.isFinite(v)) };
    let marks = logarithmic
        ? ticks(low, high, 6).filter(Number.isInteger).map(e => ({ at: e, name: shown(10 ** e) }))
        : ticks(low, high, 5).map(value => ({ at: value, name: shown(value) }));
    if (logarithmic && high - low < 2.5)
        marks = ticks(Math.floor(low), Math.ceil(high), 4).filter(Number.isInteger)
            .flatMap(e => [1, 2, 5].map(digit => digit * 10 ** e)).filter(v => v >= least && v <= most)
            .map(value => ({ at: Math.log10(value), name: shown(value) }));
    if (has.zero) marks.push({ at: zero, name: '0' });
    if (has.infinite) marks.push({ at: infinite, name: '∞' });
    return {
        marks,
        from: (has.zero ? zero : low) - 0.05 * (high - low) * (logarithmic || low < 0),
        to: (has.infinite ? infinite : high) + 0.05 * (high - low),
        at: value => !Number.isFinite(value) ? infinite
            : !logarithmic ? value : value === 0 ? zero : Math.log10(value),
    };
}

const round = value => +value.toFixed(1);
const place = (axis, low, high) => value =>
    round(low + (high - low) * (value - axis.from) / (axis.to - axis.from));

// The lines of an axis' marks, with their names: x(at) or y(at) gives their position.
const columns = (axis, x, bottom, top) => axis.marks.map(({ at, name }) =>
    `<path class="grid" d="M${x(at)} ${bottom}V${top}"/>` +
    `<text x="${x(at)}" y="${bottom + 16}" text-anchor="middle">${name}</text>`).join('');
const lines = (axis, y, left, right) => axis.marks.map(({ at, name }) =>
    `<path class="grid" d="M${left} ${y(at)}H${right}"/>` +
    `<text x="${left - 6}" y="${y(at) + 4}" text-anchor="end">${name}</text>`).join('');

// One panel: one line for each variant and precision, double solid and float dashed.
function panel(rows, xQuantity, yQuantity, curves, width) {
    const height = 340, left = 62, right = width - 12, top = 34, bottom = height - 46;
    const usable = rows.filter(row => measured(row, yQuantity));
    const xAxis = axisOf(rows, xQuantity), yAxis = axisOf(usable, yQuantity);
    const x = place(xAxis, left, right), y = place(yAxis, bottom, top);
    const xName = nameOf(rows, xQuantity), yName = nameOf(rows, yQuantity);
    let drawn = '';
    for (const [name, { color, rows: own }] of curves)
        for (const [precision, some] of group(own.filter(row => measured(row, yQuantity)), row => row.precision)) {
            const points = some.map(row => ({
                px: x(xAxis.at(row[xQuantity])),
                py: y(yAxis.at(row[yQuantity])),
                says: `${name}, ${precision}: ${xName} ${shown(row[xQuantity])}, ${yName} ${shown(row[yQuantity])}`,
            })).sort((a, b) => a.px - b.px || a.py - b.py);
            drawn += `<g class="c${color} ${precision}"><path d="M${points.map(p => `${p.px} ${p.py}`).join('L')}"/>` +
                points.map(({ px, py, says }) =>
                    `<circle cx="${px}" cy="${py}" r="3.5"><title>${escape(says)}</title></circle>`).join('') + '</g>';
        }
    return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escape(`${yName} over ${xName}`)}">` +
        columns(xAxis, x, bottom, top) + lines(yAxis, y, left, right) +
        `<text class="name" x="8" y="16">${escape(yName)}</text>` +
        `<text class="name" x="${(left + right) / 2}" y="${height - 8}" text-anchor="middle">${escape(xName)}</text>` +
        `${drawn}</svg>`;
}

// The errors alone: one bar for each variant and precision, the largest on top.
function bars(rows) {
    const axis = axisOf(rows, 'error'), width = 720, thick = 16;
    const order = [...group(rows, row => row.variant)]
        .sort((a, b) => max(b[1], row => axis.at(row.error)) - max(a[1], row => axis.at(row.error)));
    const left = Math.min(380, 20 + 7.2 * max(order, ([name]) => name.length));
    const x = place(axis, left, width - 16), name = nameOf(rows, 'error');
    let drawn = '', y = 10;
    for (const [variant, some] of order) {
        drawn += `<text x="${left - 8}" y="${y + thick * some.length / 2 + 4}" text-anchor="end">` +
            `${escape(variant)}</text>`;
        for (const row of some) {
            const length = Math.max(1, round(x(axis.at(row.error)) - left));
            const says = `${variant}, ${row.precision}: ${name} ${shown(row.error)}`;
            drawn += `<rect class="bar c${row.precision === 'float' ? 1 : 0}" x="${left}" y="${y}" width="${length}" ` +
                `height="${thick - 2}"><title>${escape(says)}</title></rect>`;
            y += thick;
        }
        y += 8;
    }
    return `<svg viewBox="0 0 ${width} ${y + 44}" role="img" aria-label="${escape(name)}">` +
        columns(axis, x, y, 4) + drawn +
        `<text class="name" x="${(left + width) / 2}" y="${y + 38}" text-anchor="middle">${escape(name)}</text></svg>`;
}

// Whether a quantity changes with x by more than times fluctuate.
function dependsOnX(rows, quantity) {
    return [...group(rows, row => row.variant + row.precision).values()].some(some => {
        const [least, most] = extent(some, row => row[quantity]);
        return !(most <= 1.25 * least);
    });
}

const key = (color, precision, name) =>
    `<li><svg viewBox="0 0 34 12" width="34" height="12" aria-hidden="true"><g class="c${color} ${precision}">` +
    `<path d="M1 6H33"/><circle cx="17" cy="6" r="3.5"/></g></svg>${escape(name)}</li>`;

// The plot of one study's rows.
export function plot(rows, description = '') {
    const precisions = new Set(rows.map(row => row.precision));
    const begin = `<figure class="plot"${description ? ` aria-label="${escape(description)}"` : ''}>`;
    if (rows.every(row => measured(row, 'error') && !measured(row, 'cost'))) {
        const keys = [...precisions].map(p => `<li><span class="swatch c${p === 'float' ? 1 : 0}"></span>${p}</li>`);
        return `${begin}${bars(rows)}<ul class="key">${keys.join('')}</ul></figure>`;
    }
    const overX = new Set(rows.map(row => row.x)).size >= 3;
    const withX = !overX && new Set(rows.map(row => row.x)).size > 1;
    const curves = new Map();
    for (const [name, own] of group(rows, row => row.variant + (withX ? `, ${row.x_name} ${row.x}` : '')))
        curves.set(name, { color: curves.size % colorCount, rows: own });
    const hasError = rows.some(row => measured(row, 'error'));
    const panels = !hasError ? [['x', 'cost']]
        : !overX ? [['cost', 'error']]
        : dependsOnX(rows, 'cost') || !dependsOnX(rows, 'error') ? [['x', 'error'], ['x', 'cost']]
        : [['x', 'error']];
    const keys = [...curves].map(([name, { color }]) => key(color, 'double', name));
    if (precisions.size > 1) keys.push(...['double', 'float'].map(p => key('none', p, p)));
    return `${begin}<div class="panels">` +
        panels.map(([x, y]) => panel(rows, x, y, curves, panels.length > 1 ? 470 : 720)).join('') +
        `</div><ul class="key">${keys.join('')}</ul></figure>`;
}
