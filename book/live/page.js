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
            probe.style.color = `var(--${name})`;
            colors[i] = getComputedStyle(probe).color;
        });
        probe.remove();
    }
    const colorOf = code => code < 256 ? colors[code] : `#${(code - 256).toString(16).padStart(6, '0')}`;

    const { filled, named } = liveNumbers;

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
            pen.font = `${bold === 1 ? 600 : 400} ${size}px ${bold === 2 ? 'ui-monospace, monospace' : family}`;
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
            this.stage = element.querySelector('.stage');
            this.canvas = element.querySelector('canvas');
            this.said = element.querySelector('.said');
            this.progress = element.querySelector('.progress');
            this.inputs = [...this.form.querySelectorAll('[data-control]')];
            this.handles = [];
            this.requests = 0;
            this.forget();
            this.form.addEventListener('input', () => this.changed());
            this.form.addEventListener('submit', event => event.preventDefault());
            this.form.addEventListener('reset', () => setTimeout(() => this.changed()));
            for (const button of this.form.querySelectorAll('[data-plays]')) this.play(button);
            for (const button of this.form.querySelectorAll('[data-turns]')) this.turn(button);
            this.dragging();
            new ResizeObserver(() => this.request({})).observe(this.stage);
        }

        // ---- Controls ----

        get values() {
            return this.inputs.map(input => +input.value);
        }
        get ranges() {
            return this.inputs.map(input => input.type === 'range' ? [+input.min, +input.max] : [0, 2 ** 53]);
        }
        setValues(values) {
            this.inputs.forEach((input, i) => { input.value = values[i]; });
            this.nameValues();
        }
        nameValues() {
            for (const input of this.inputs) {
                const output = input.parentElement.querySelector('.value');
                if (!output) continue;
                output.textContent = named(+input.value, input.dataset);
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
                    if (this.waits) return;  // the worker is behind
                    input.stepUp();
                    this.changed();
                    if (+input.value >= +input.max) stop();
                }, 1000 / +input.dataset.play);
            });
            this.form.addEventListener('reset', stop);
            this.canvas.addEventListener('pointerdown', stop);
        }

        // Adds a turn to the end of a list of them, or takes the last one off: see live.hpp.
        turn(button) {
            const input = this.inputs.find(one => one.dataset.control === button.dataset.turns);
            button.addEventListener('click', () => {
                if (button.value === '') input.value = Math.max(1, Math.floor(input.value / 2));
                else if (input.value < 2 ** 52) input.value = 2 * input.value + +button.value;
                this.changed();
            });
        }

        // ---- The workers ----

        // The first worker draws the figure. If its picture refines, the others draw parts of the picture.
        forget() {
            this.waiting = [];  // for each worker, the request that it has not answered yet,
            this.next = [];     // and the one to send after that: of those made meanwhile, only the last one counts
            this.parts = [];    // what the others have drawn
        }
        get waits() {
            return Boolean(this.waiting[0]);
        }
        get refines() {
            return this.answer?.samples > 0;
        }
        request(what) {
            const width = this.stage.clientWidth;
            if (width === 0) return;
            this.send({ figure: this.number, id: ++this.requests, values: this.values, ranges: this.ranges, width,
                        ratio: devicePixelRatio, ...what });
        }
        send(request) {
            this.last = request;
            const parts = this.refines ? this.module.crew() : 1;
            for (let part = 0; part < parts; ++part)
                if (this.waiting[part]) this.next[part] = { ...request, part, parts };
                else this.post({ ...request, part, parts });
        }
        post(request) {
            this.waiting[request.part] = request;
            this.module.workers[request.part].postMessage(request);
        }
        receive(answer, worker) {
            if (answer.answers) {
                const request = this.waiting[worker], next = this.next[worker];
                this.waiting[worker] = this.next[worker] = undefined;
                if (worker === 0) {
                    // The values of a drag that is over would undo what has been set since.
                    if (answer.values && !(next && !next.drag)) this.setValues(answer.values);
                    answer.width = request.width;
                }
                if (next) this.post(next);
            }
            if (worker > 0) {
                this.parts[worker] = answer;
            } else {
                const didRefine = this.refines;
                this.answer = { width: this.answer?.width, ...answer };
                this.element.classList.remove('failed');
                if (this.refines && !didRefine && this.module.crew() > 1) this.send(this.last);
            }
            this.shows ??= requestAnimationFrame(() => {
                this.shows = undefined;
                this.show();
            });
        }

        // The module has new workers. `failure` says what this figure did to the old ones, if it was this one.
        begin(failure) {
            const { last, next: [next] } = this;
            this.forget();
            if (!failure) return last && this.send(last);
            const inputs = this.inputs.map((input, i) => {
                const label = input.parentElement.firstChild.textContent.trim();
                const { values } = last;
                return `${label} ${input.tagName === 'SELECT' ? input.options[values[i]].text : named(values[i], input.dataset)}`;
            });
            this.said.textContent = `${failure}: ${inputs.join(', ')}. Change a value, or reset.`;
            this.element.classList.add('failed');
            if (next) this.send(next);
        }

        // ---- Drawing ----

        show() {
            if (!this.answer) return;
            const { list, width, height, samples } = this.answer, { canvas } = this;
            this.width = width;
            const done = this.merge();
            const ratio = devicePixelRatio;
            const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)];
            if (canvas.width !== columns || canvas.height !== rows)
                [canvas.width, canvas.height] = [columns, rows];
            this.stage.style.aspectRatio = `${width} / ${height}`;
            const pen = canvas.getContext('2d');
            pen.setTransform(ratio, 0, 0, ratio, 0, 0);
            pen.clearRect(0, 0, width, height);
            pen.lineCap = pen.lineJoin = 'round';
            this.handles = [];
            for (const { op, color, alpha, numbers } of entries(list)) {
                if (op === handleOp) this.handles.push([...numbers]);
                else if (op === sayOp) {
                    const said = filled(this.answer.words[numbers[0]], numbers.subarray(1));
                    if (this.said.textContent !== said && !this.element.classList.contains('failed'))
                        this.said.textContent = said;
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

        // Puts the bands of rows that the other workers drew in the picture of the first, and returns how many samples
        // per pixel all have drawn.
        merge() {
            const { id, parts, refined, pictures } = this.answer;
            let { done } = this.answer;
            for (let part = 1; part < parts; ++part) {
                const other = this.parts[part], same = other?.id === id;
                done = Math.min(done, same ? other.done : 0);
                if (!same || refined < 0) continue;
                const { columns, pixels } = other;
                const band = 4 * columns * bandRows;
                for (let at = part * band; at < pixels.length; at += parts * band)
                    pictures[refined].set(pixels.subarray(at, at + band), at);
            }
            return done;
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
                const down = this.placeOf(event), isTouch = event.pointerType === 'touch';
                const reach = event.pointerType === 'mouse' ? 4 : 14;
                if (event.button !== 0 || !this.grabs(down, reach)) return;
                // A finger that is not on a handle drags only if it moves sideways: else it scrolls the page, or taps.
                drag = { pointer: event.pointerId, values: this.values, down, begun: !isTouch || this.isOnHandle(down, reach) };
                canvas.setPointerCapture(event.pointerId);
                event.preventDefault();
                this.element.classList.add('grabbed');
            });
            canvas.addEventListener('pointermove', event => {
                const at = this.placeOf(event);
                if (!drag) {
                    canvas.style.cursor = this.grabs(at, 4) ? 'grab' : '';
                } else if (drag.pointer === event.pointerId) {  // not another finger
                    const [across, along] = at.map((place, i) => Math.abs(place - drag.down[i]));
                    drag.moved ||= Math.max(across, along) > 8;
                    drag.begun ||= across > 8 && across > 2 * along;
                    if (!drag.begun) return;
                    drag.asked = true;
                    this.request({ values: drag.values, drag: { down: drag.down, at } });
                }
            });
            for (const end of ['pointerup', 'pointercancel'])
                canvas.addEventListener(end, event => {
                    if (drag?.pointer !== event.pointerId) return;
                    const { begun, moved, asked, values, down } = drag;
                    drag = undefined;
                    this.element.classList.remove('grabbed');
                    if (end === 'pointerup' && !asked && !moved) this.request({ values, drag: { down, at: down } });
                    if (end === 'pointercancel' && begun) {
                        this.setValues(values);
                        this.request({});
                    }
                });
            // A touch on a handle drags it in every direction; any other may scroll the page.
            canvas.addEventListener('touchstart', event => {
                if (this.isOnHandle(this.placeOf(event.touches[0]), 14)) event.preventDefault();
            }, { passive: false });
        }
    }

    // ---- The figures of a chapter, and the workers that they share ----

    const patience = 3;  // seconds that an answer may take
    const bandRows = 8;  // as in refine.hpp

    class Module {
        constructor(chapter) {
            this.chapter = chapter;
            this.elements = [];
            this.workers = [];
            this.inView = new Set();
        }

        load() {
            if (this.asked) return;
            this.asked = true;
            const script = document.createElement('script');
            script.src = `assets/live-${this.chapter}.js`;
            document.head.append(script);
        }

        start(source, code, whose, asItIs) {
            Object.assign(this, { codes: [code, asItIs], passing: whose, loaded: performance.now() });
            this.url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
            this.choose();
            this.hire();
            setInterval(() => this.watch(), 250);
        }

        // The page's switch says whether the learner's code runs where it fails.
        choose() {
            const [code, asItIs] = this.codes, chosen = asItIs && asItIsSwitch()?.checked;
            this.code = chosen ? asItIs : code;
            this.whose = chosen ? 'Your' : this.passing;
        }
        switched() {
            if (!this.codes?.[1]) return;
            this.choose();
            this.replace();
        }

        hire() {
            const worker = new Worker(this.url), number = this.workers.push(worker) - 1;
            worker.onmessage = ({ data }) => this.hear(worker, number, data);
            worker.postMessage({ code: this.code });
            for (const [figure] of this.figures ?? []) this.tell(figure, worker);
        }

        // How many workers share a picture that refines.
        crew() {
            const count = Math.min(4, navigator.hardwareConcurrency || 1);
            while (this.workers.length < count) this.hire();
            return count;
        }

        hear(worker, number, data) {
            worker.silent = 0;
            worker.draws = data.draws;  // the figure that it begins to draw: nothing else is heard until it is done
            if (data.draws !== undefined) return;
            if (data.ready) {
                if (!this.figures) this.begin();
            } else if (!this.figures) {
                console.info(`live figures of chapter ${this.chapter}: ${data.failed}`);
                for (const element of this.elements) element.classList.add('still-only');
            } else if (data.failed) {
                console.info(`live figure ${data.figure} of chapter ${this.chapter}: ${data.failed}`);
                this.replace(data.figure, 'failed');
            } else {
                this.figures.get(data.figure).receive(data, number);
            }
        }

        // Seconds are counted in steps, because a computer may sleep meanwhile.
        watch() {
            for (const worker of this.workers) {
                worker.silent += 0.25;
                if (worker.draws !== undefined && worker.silent > patience)
                    return this.replace(worker.draws, 'did not return');
            }
        }

        // A worker that hangs or trapped is of no use any more, nor is one with other code. The other figures go on with new ones.
        replace(blamed, what) {
            for (const worker of this.workers) {
                worker.onmessage = undefined;
                worker.terminate();
            }
            this.workers = [];
            this.hire();
            for (const [figure, one] of this.figures ?? [])
                one.begin(figure === blamed ? `${this.whose} code ${what}` : undefined);
        }

        // A picture that nobody sees need not get better.
        tell(figure, worker) {
            worker.postMessage({ figure, [this.inView.has(figure) && !document.hidden ? 'awake' : 'asleep']: true });
        }
        tellAll(figure) {
            for (const worker of this.workers) this.tell(figure, worker);
        }

        begin() {
            this.figures = new Map(this.elements.map(element => [+element.dataset.number, new Figure(element, this)]));
            const watched = new IntersectionObserver(changes => {
                for (const { target, isIntersecting } of changes) {
                    const figure = +target.dataset.number;
                    this.inView[isIntersecting ? 'add' : 'delete'](figure);
                    this.tellAll(figure);
                }
            }, { rootMargin: '300px' });
            for (const element of this.elements) watched.observe(element);
            document.addEventListener('visibilitychange', () => this.figures.forEach((_, figure) => this.tellAll(figure)));
        }
    }

    const modules = new Map(), asItIsSwitch = () => document.querySelector('.as-it-is input');
    // The chapter's file calls this with the worker's source, the compiled code, and whose code it is: Your or The; then
    // the same with the learner's code where it fails, too, if the page has a switch for it.
    window.liveModule = (chapter, ...given) => modules.get(chapter).start(...given);

    document.documentElement.classList.add('lively');
    document.addEventListener('DOMContentLoaded', () => {
        readColors();
        const near = new IntersectionObserver(changes => {
            for (const { target, isIntersecting } of changes)
                if (isIntersecting) modules.get(target.dataset.live.slice(0, 2)).load();
        }, { rootMargin: '1200px' });
        for (const element of document.querySelectorAll('figure.live')) {
            const chapter = element.dataset.live.slice(0, 2);
            if (!modules.has(chapter)) modules.set(chapter, new Module(chapter));
            modules.get(chapter).elements.push(element);
            near.observe(element);
        }
        asItIsSwitch()?.addEventListener('change', () => modules.forEach(module => module.switched()));
        const redraw = () => {
            readColors();
            for (const { figures } of modules.values()) figures?.forEach(figure => figure.show());
        };
        new MutationObserver(redraw).observe(document.documentElement, { attributeFilter: ['data-theme'] });
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
    });
})();
