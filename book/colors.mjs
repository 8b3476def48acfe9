// The drawings of docs/images name plain colors, so that they can be read anywhere. In a page they get its palette,
// which the plots and the live figures have, too, and so they are right on dark paper as well.

// Lightness (0 to 1), chroma and hue (degrees) in Oklab: https://bottosson.github.io/posts/oklab/
function oklch(hex) {
    const digits = hex.length === 4 ? [...hex.slice(1)].map(c => c + c) : hex.slice(1).match(/../g);
    const [r, g, b] = digits.map(pair => parseInt(pair, 16) / 255)
        .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    const x = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const y = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return { lightness: 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, chroma: Math.hypot(x, y),
             hue: (Math.atan2(y, x) * 180 / Math.PI + 360) % 360 };
}

// Where the hues of the palette end, in degrees.
const hues = [[18, 'c3'], [58, 'c1'], [110, 'c4'], [185, 'c2'], [235, 'c5'], [285, 'c0'], [360, 'c3']];
const mixed = (color, part, base = 'paper') => part >= 0.97 ? `var(--${color})`
    : `color-mix(in oklab, var(--${color}) ${Math.round(100 * part)}%, var(--${base}))`;

// What a color of a drawing is in a page. Words can be read: dark ones on paper and on tints, white ones on strong colors.
export function inPage(hex, tag, isFill, isWords) {
    const { lightness, chroma, hue } = oklch(hex), isArea = isFill && !isWords;
    if (isWords && lightness > 0.9) return 'var(--paper)';
    if (chroma < 0.015) return mixed('ink', Math.max((1 - lightness) / 0.72, isWords ? 0.78 : 0));
    const color = hues.find(([end]) => hue < end)[1];
    if (isWords) return mixed(color, 0.75, 'ink');
    if (lightness > 0.85) return mixed(color, Math.min((1 - lightness) / 0.4, 0.25));
    return mixed(color, isArea && lightness > (tag === 'rect' ? 0.6 : 0.75) ? 0.35 : 1);
}

// What a drawing has for dark pages where it is not part of a page, by dark.mjs.
export const ownStyle = /\n<style>@media\(prefers-color-scheme:dark\).*?<\/style>/s;

let drawings = 0;

// A drawing as a part of the page. Its names are made unique.
export function drawing(svg, text) {
    const prefix = `drawing-${++drawings}-`;
    const plain = svg.replace(ownStyle, '');
    return plain.slice(plain.indexOf('<svg'))
        .replace(/<(\w+)([^>]*)>/g, (_, tag, rest) => `<${tag}${rest.replace(/(fill|stroke|stop-color)="(#[0-9a-fA-F]+)"/g,
            (_, what, hex) => `${what}="${inPage(hex, tag, what === 'fill', /^t(ext|span)$/.test(tag) || rest.includes('text-anchor'))}"`)}>`)
        .replace(/ id="/g, ` id="${prefix}`).replace(/url\(#/g, `url(#${prefix}`).replace(/href="#/g, `href="#${prefix}`)
        .replace('<svg ', `<svg class="drawing" role="img" aria-label="${text}" `);
}
