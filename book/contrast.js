// For test.mjs, in the page: words that are hard to read, with less contrast than 4.5 to what is behind them.
(() => {
    const pen = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
    const known = new Map();
    const rgba = color => {
        if (!known.has(color)) {
            pen.clearRect(0, 0, 1, 1);
            pen.fillStyle = color;
            pen.fillRect(0, 0, 1, 1);
            const [r, g, b, a] = pen.getImageData(0, 0, 1, 1).data;
            known.set(color, [r, g, b, a / 255]);
        }
        return known.get(color);
    };
    const over = ([r, g, b, a], [R, G, B]) => [a * r + (1 - a) * R, a * g + (1 - a) * G, a * b + (1 - a) * B, 1];
    const luminance = color => {
        const [r, g, b] = color.map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (a, b) => {
        const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
        return (high + 0.05) / (low + 0.05);
    };
    window.contrastOf = (words, behind, alpha = 1) => {
        const paper = rgba(behind);
        return contrast(over([...rgba(words).slice(0, 3), alpha * rgba(words)[3]], paper), paper);
    };

    const backgrounds = new Map();
    const behind = element => {
        if (!element) return rgba('white');
        if (!backgrounds.has(element)) {
            const own = rgba(getComputedStyle(element).backgroundColor);
            backgrounds.set(element, own[3] === 1 ? own : over(own, behind(element.parentElement)));
        }
        return backgrounds.get(element);
    };
    // In a drawing, the shapes below the middle of the words count, too.
    const shapesBelow = text => {
        const svg = text.closest('svg'), box = text.getBBox(), matrix = text.getCTM();
        const point = new DOMPoint(box.x + box.width / 2, box.y + box.height / 2).matrixTransform(matrix);
        const below = [...svg.querySelectorAll('rect, circle, ellipse, path, polygon')].filter(shape =>
            shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING && !shape.closest('defs, marker') &&
            getComputedStyle(shape).fill !== 'none' && shape.isPointInFill(point.matrixTransform(shape.getCTM().inverse())));
        return below.reduce((color, shape) => {
            const { fill, fillOpacity, opacity } = getComputedStyle(shape);
            if (fill.startsWith('url')) return color;
            const own = rgba(fill);
            return over([...own.slice(0, 3), own[3] * fillOpacity * opacity], color);
        }, behind(svg.parentElement));
    };

    window.hardToRead = () => {
        backgrounds.clear();
        const found = [];
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT,
            node => node.data.trim() ? NodeFilter.FILTER_ACCEPT : NodeFilter.FILTER_SKIP);
        for (const seen = new Set(); walker.nextNode();) {
            const element = walker.currentNode.parentElement;
            if (seen.has(element) || !element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
            seen.add(element);
            if (element.closest('.word, title, style, .anchor')) continue;  // words on pictures; a link that is seen only with the mouse
            const isDrawn = element instanceof SVGElement, style = getComputedStyle(element);
            const paper = isDrawn ? shapesBelow(element.closest('text')) : behind(element);
            const ink = rgba(isDrawn ? style.fill : style.color);
            const ratio = contrast(over([...ink.slice(0, 3), ink[3] * (isDrawn ? style.fillOpacity * style.opacity : 1)], paper), paper);
            if (ratio < 4.5) found.push(`${walker.currentNode.data.trim().slice(0, 40)} (${ratio.toFixed(2)})`);
        }
        return found;
    };
})();
