// The page's side of its live figures: it sends the controls to the worker that computes, and draws the strokes
// that come back. Until the first of them arrive, and if anything fails, the still picture stays.
'use strict';

(() => {
    const names = ['paper', 'ink', 'muted', 'line', 'accent', 'c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'panel'];
    const colors = [];
    function readColors() {
        const probe = document.createElement('span');
        document.body.append(probe);
        names.forEach((name, i) => {
            probe.className = name;  // it selects a plot's color
            probe.style.color = /^c\d/.test(name) ? 'var(--c)' : `var(--${name})`;
            colors[i] = getComputedStyle(probe).color;
        });
        probe.remove();
    }
    const colorOf = code => code < 256 ? colors[code] : `#${(code - 256).toString(16).padStart(6, '0')}`;

    // ---- Numbers ----

    const superscript = text => [...text].map(c => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('');
    const minus = text => text.replace('-', '−');
    function scientific(value) {
        if (value === 0 || !Number.isFinite(value)) return plain(value);
        const [digits, exponent] = value.toExponential(1).split('e');
        return `${minus(digits)}·10${superscript(exponent.replace('+', ''))}`;
    }
    function plain(value) {
        if (Number.isNaN(value)) return 'none';
        if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞';
        const size = Math.abs(value);
        if (size !== 0 && (size < 1e-4 || size >= 1e7)) return scientific(value);
        return minus(String(+value.toPrecision(4)));
    }
    function shown(value, how) {
        if (how === 'e') return scientific(value);
        if (how === '+') return (value >= 0 ? '+' : '') + plain(value);
        if (how.startsWith('.') && Number.isFinite(value))
            return minus(value.toFixed(+how.slice(1)).replace(/^-(?=[0.]*$)/, ''));  // no negative zero
        return plain(value);
    }
    const filled = (words, values) => {
        let next = 0;
        return words.replace(/\{(e|\+|\.\d+|)\}/g, (_, how) => shown(values[next++], how));
    };

    // ---- Strokes ----

    const family = 'system-ui, sans-serif';
    const draws = [
        function path(pen, [width, dash, ...points]) {
            pen.lineWidth = width;
            pen.setLineDash(dash ? [dash, dash] : []);
            pen.stroke(along(points));
        },
        function polygon(pen, points) { pen.fill(along(points)); },
        function disc(pen, [x, y, radius]) { pen.fill(round(x, y, radius)); },
        function circle(pen, [width, dash, x, y, radius]) {
            pen.lineWidth = width;
            pen.setLineDash(dash ? [dash, dash] : []);
            pen.stroke(round(x, y, radius));
        },
        function text(pen, [x, y, align, size, bold, onPicture, number, ...values], { words }) {
            pen.font = `${bold ? 600 : 400} ${size}px ${family}`;
            pen.textAlign = ['left', 'center', 'right'][align];
            pen.textBaseline = 'middle';
            pen.setLineDash([]);
            pen.lineWidth = 4;
            if (onPicture) pen.fillStyle = '#fff';
            pen.strokeStyle = onPicture ? '#000a' : colors[0];
            const line = filled(words[number], values);
            pen.strokeText(line, x, y);
            pen.fillText(line, x, y);
        },
        undefined,  // a handle
        function picture(pen, [x, y, width, height, columns, rows, smooth, number], { pictures }) {
            const canvas = new OffscreenCanvas(columns, rows);
            canvas.getContext('2d').putImageData(new ImageData(pictures[number], columns, rows), 0, 0);
            pen.imageSmoothingEnabled = Boolean(smooth);
            pen.imageSmoothingQuality = 'high';
            pen.drawImage(canvas, x, y, width, height);
        },
    ];
    const handleOp = 5, sayOp = 7;

    function along(points) {
        const path = new Path2D();
        for (let i = 0; i < points.length; i += 2) path.lineTo(points[i], points[i + 1]);
        return path;
    }
    function round(x, y, radius) {
        const path = new Path2D();
        path.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI);
        return path;
    }

    function* entries(list) {
        for (let at = 0; at < list.length; at += 2 + list[at + 1])
            yield { op: list[at], color: list[at + 2], alpha: list[at + 3],
                    numbers: list.subarray(at + 4, at + 2 + list[at + 1]) };
    }

    // ---- A figure ----

    class Figure {
        constructor(element, module) {
            this.element = element;
            element.figure = this;  // for tests
            this.module = module;
            this.number = +element.dataset.number;
            this.form = element.querySelector('form');
            this.canvas = element.querySelector('canvas');
            this.said = element.querySelector('.said');
            this.progress = element.querySelector('.progress');
            this.inputs = [...this.form.querySelectorAll('[data-control]')];
            this.handles = [];
            this.form.addEventListener('input', () => this.changed());
            this.form.addEventListener('submit', event => event.preventDefault());
            this.form.addEventListener('reset', () => setTimeout(() => this.changed()));
            for (const button of this.form.querySelectorAll('[data-plays]')) this.play(button);
            this.dragging();
            new ResizeObserver(() => this.request({})).observe(element.querySelector('.stage'));
        }

        // ---- Controls ----

        get values() {
            return this.inputs.map(input => +input.value);
        }
        get ranges() {
            return this.inputs.map(input => input.type === 'range' ? [+input.min, +input.max] : [0, 1e9]);
        }
        setValues(values) {
            this.inputs.forEach((input, i) => { input.value = values[i]; });
            this.nameValues();
        }
        nameValues() {
            for (const input of this.inputs) {
                const output = input.parentElement.querySelector('.value');
                if (!output) continue;
                const value = input.dataset.log ? 10 ** +input.value : +input.value;
                output.textContent = plain(value < 100 ? value : Math.round(value)) + (input.dataset.unit ?? '');
                input.setAttribute('aria-valuetext', output.textContent);
            }
        }
        changed() {
            this.nameValues();
            this.request({});
        }

        // Moves a slider on, step by step; from its start if it is at its end.
        play(button) {
            const input = this.inputs.find(one => one.dataset.control === button.dataset.plays);
            const name = button.textContent;
            let timer;
            const stop = () => {
                clearInterval(timer);
                timer = undefined;
                button.textContent = name;
            };
            button.addEventListener('click', () => {
                if (timer) return stop();
                button.textContent = 'Pause';
                if (+input.value >= +input.max) {
                    input.value = input.min;
                    this.changed();
                }
                timer = setInterval(() => {
                    if (!this.element.classList.contains('runs')) return stop();
                    if (this.waiting) return;  // the worker is behind
                    input.stepUp();
                    this.changed();
                    if (+input.value >= +input.max) stop();
                }, 1000 / +input.dataset.play);
            });
            this.form.addEventListener('reset', stop);
            this.canvas.addEventListener('pointerdown', stop);
        }

        // ---- The worker ----

        // Only one request is on its way at a time. Of those made meanwhile, only the last one counts.
        request(what) {
            const width = this.element.querySelector('.stage').clientWidth;
            if (width === 0) return;
            const request = { figure: this.number, values: this.values, ranges: this.ranges, width,
                              ratio: devicePixelRatio, ...what };
            if (this.waiting) this.next = request;
            else this.send(request);
        }
        send(request) {
            this.waiting = request;
            this.module.worker.postMessage(request);
        }
        receive(answer) {
            if (answer.failed) {
                this.element.classList.remove('runs');
                console.info(`live figure ${this.element.dataset.live}: ${answer.failed}`);
                return;
            }
            if (answer.answers) {
                // The values of a drag that is over would undo what has been set since.
                if (answer.values && !(this.next && !this.next.drag)) this.setValues(answer.values);
                this.width = this.waiting.width;
                this.waiting = undefined;
                if (this.next) this.send(this.next);
                this.next = undefined;
            }
            this.answer = answer;
            this.show();
        }

        // ---- Drawing ----

        show() {
            if (!this.answer) return;
            const { list, height, done, samples } = this.answer, { canvas, width } = this;
            const ratio = devicePixelRatio;
            const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)];
            if (canvas.width !== columns || canvas.height !== rows)
                [canvas.width, canvas.height] = [columns, rows];
            canvas.style.aspectRatio = `${width} / ${height}`;
            const pen = canvas.getContext('2d');
            pen.setTransform(ratio, 0, 0, ratio, 0, 0);
            pen.clearRect(0, 0, width, height);
            pen.lineCap = pen.lineJoin = 'round';
            this.handles = [];
            for (const { op, color, alpha, numbers } of entries(list)) {
                if (op === handleOp) this.handles.push([...numbers]);
                else if (op === sayOp) {
                    const said = filled(this.answer.words[numbers[0]], numbers.subarray(1));
                    if (this.said.textContent !== said) this.said.textContent = said;
                } else {
                    pen.globalAlpha = alpha;
                    pen.fillStyle = pen.strokeStyle = colorOf(color);
                    draws[op](pen, numbers, this.answer);
                }
            }
            pen.globalAlpha = 1;
            this.isDraggedAnywhere = this.handles.some(([,, radius]) => radius < 0);
            canvas.style.touchAction = this.isDraggedAnywhere ? 'pan-y' : '';
            this.progress.hidden = samples < 2;
            if (samples > 1) {
                this.progress.style.setProperty('--done', done / samples);
                this.progress.textContent = `${done} of ${samples} samples per pixel`;
            }
            if (!this.element.dataset.first) {
                this.element.dataset.first = Math.round(performance.now() - this.module.loaded);
                this.nameValues();
            }
            this.element.classList.add('runs');
        }

        // ---- Dragging ----

        placeOf(event) {
            const box = this.canvas.getBoundingClientRect();
            const scale = this.width / box.width;
            return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
        }
        isOnHandle([x, y], reach) {
            return this.handles.some(([hx, hy, radius]) => radius > 0 && Math.hypot(x - hx, y - hy) <= radius + reach);
        }
        grabs(place, reach) {
            return this.isDraggedAnywhere || this.isOnHandle(place, reach);
        }
        dragging() {
            const { canvas } = this;
            let drag;
            canvas.addEventListener('pointerdown', event => {
                const down = this.placeOf(event);
                if (event.button !== 0 || !this.grabs(down, event.pointerType === 'mouse' ? 4 : 14)) return;
                drag = { pointer: event.pointerId, values: this.values, down };
                canvas.setPointerCapture(event.pointerId);
                event.preventDefault();
                this.element.classList.add('grabbed');
            });
            canvas.addEventListener('pointermove', event => {
                const at = this.placeOf(event);
                if (drag && drag.pointer !== event.pointerId) return;  // another finger
                if (drag) this.request({ values: drag.values, drag: { down: drag.down, at } });
                else canvas.style.cursor = this.grabs(at, 4) ? 'grab' : '';
            });
            for (const end of ['pointerup', 'pointercancel'])
                canvas.addEventListener(end, event => {
                    if (drag?.pointer !== event.pointerId) return;
                    drag = undefined;
                    this.element.classList.remove('grabbed');
                });
            // A touch on a handle drags it in every direction; any other may scroll the page.
            canvas.addEventListener('touchstart', event => {
                if (this.isOnHandle(this.placeOf(event.touches[0]), 14)) event.preventDefault();
            }, { passive: false });
        }
    }

    // ---- The figures of a chapter, and the worker that they share ----

    const modules = new Map();
    // The chapter's file calls this with the worker's source and the compiled code.
    window.liveModule = (chapter, source, code) => {
        const module = modules.get(chapter);
        module.loaded = performance.now();
        const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
        module.worker = new Worker(url);
        module.worker.onmessage = ({ data }) => {
            if (data.ready) begin(module);
            else if (!module.figures) console.info(`live figures of chapter ${chapter}: ${data.failed}`);
            else module.figures.get(data.figure).receive(data);
        };
        module.worker.postMessage({ code });
    };

    function begin(module) {
        module.figures = new Map(module.elements.map(element =>
            [+element.dataset.number, new Figure(element, module)]));
        // A picture that nobody sees need not get better.
        const inView = new Set();
        const tell = figure => module.worker.postMessage({
            figure, [inView.has(figure) && !document.hidden ? 'awake' : 'asleep']: true,
        });
        const watched = new IntersectionObserver(changes => {
            for (const { target, isIntersecting } of changes) {
                const figure = +target.dataset.number;
                inView[isIntersecting ? 'add' : 'delete'](figure);
                tell(figure);
            }
        }, { rootMargin: '300px' });
        for (const element of module.elements) watched.observe(element);
        document.addEventListener('visibilitychange', () => module.figures.forEach((_, figure) => tell(figure)));
    }

    function load(chapter) {
        if (modules.get(chapter).asked) return;
        modules.get(chapter).asked = true;
        const script = document.createElement('script');
        script.src = `assets/live-${chapter}.js`;
        document.head.append(script);
    }

    document.addEventListener('DOMContentLoaded', () => {
        readColors();
        const near = new IntersectionObserver(changes => {
            for (const { target, isIntersecting } of changes)
                if (isIntersecting) load(target.dataset.live.slice(0, 2));
        }, { rootMargin: '1200px' });
        for (const element of document.querySelectorAll('figure.live')) {
            const chapter = element.dataset.live.slice(0, 2);
            if (!modules.has(chapter)) modules.set(chapter, { elements: [] });
            modules.get(chapter).elements.push(element);
            near.observe(element);
        }
        const redraw = () => {
            readColors();
            for (const { figures } of modules.values()) figures?.forEach(figure => figure.show());
        };
        new MutationObserver(redraw).observe(document.documentElement, { attributeFilter: ['data-theme'] });
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
    });
})();
