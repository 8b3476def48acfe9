// Runs the figures of a chapter in a thread of their own, so that the page never stalls.
'use strict';

let wasm;
const asleep = new Set();    // figures that nobody can see
const refining = new Set();  // those of the others whose picture gets better

// What figures may ask of a system. They need none of it. Nothing can be printed: files do not exist.
const badFile = 8;  // as WASI numbers its errors
const imports = new Proxy({}, { get: () => new Proxy({}, {
    get: (_, name) => /exit|abort|throw/.test(name) ? () => { throw new Error(`the figure ended: ${name}`); }
        : () => name.startsWith('fd_') ? badFile : 0,
}) });

function answer(figure, more) {
    const memory = wasm.memory.buffer;
    const list = new Float64Array(memory, wasm.live_list(figure), wasm.live_list_size(figure)).slice();
    const words = new TextDecoder().decode(
        new Uint8Array(memory, wasm.live_words(figure), wasm.live_words_size(figure))).split('\0');
    const pictures = [];
    for (let at = 0; at < list.length; at += 2 + list[at + 1])
        if (list[at] === 6) {  // Op::picture: its address becomes its number
            const [columns, rows] = [list[at + 8], list[at + 9]];
            pictures.push(new Uint8ClampedArray(memory, list[at + 11], 4 * columns * rows).slice());
            list[at + 11] = pictures.length - 1;
        }
    postMessage({
        figure, list, words, pictures, height: wasm.live_height(figure), done: wasm.live_done(figure),
        samples: wasm.live_samples(figure), ...more,
    }, [list.buffer, ...pictures.map(picture => picture.buffer)]);
}

// Makes a figure's picture better for so many milliseconds.
function refineFor(figure, time) {
    const end = performance.now() + time;
    let more = true;
    while (more && performance.now() < end) more = wasm.live_more(figure);
    if (!more) refining.delete(figure);
}

function fail(figure, error) {
    refining.delete(figure);
    postMessage({ figure, failed: String(error) });
}

let refines = false;  // refine() is going to be called
function refine() {
    for (const figure of refining)
        try {
            refineFor(figure, 40);
            answer(figure);
        } catch (error) {
            fail(figure, error);
        }
    refines = refining.size > 0;
    if (refines) setTimeout(refine, 0);  // messages have their turn
}

function start(figure) {
    if (asleep.has(figure) || !wasm.live_samples(figure)) return;
    refining.add(figure);
    if (!refines) setTimeout(refine, 0);
    refines = true;
}

function draw({ figure, values, drag, ranges, width, ratio }) {
    const own = () => new Float64Array(wasm.memory.buffer, wasm.live_values(), values.length);
    own().set(values);
    if (drag) wasm.live_drag(figure, ...drag.down, ...drag.at, width);
    own().set(ranges.map(([least, most], i) => Math.min(most, Math.max(least, own()[i]))));
    const used = [...own()];
    wasm.live_draw(figure, width, ratio);
    start(figure);
    if (refining.has(figure)) refineFor(figure, 20);
    answer(figure, { answers: true, values: drag ? used : undefined });
}

onmessage = async ({ data }) => {
    try {
        if (data.code) {
            const packed = new Blob([Uint8Array.from(atob(data.code), letter => letter.charCodeAt(0))]);
            const code = new Response(packed.stream().pipeThrough(new DecompressionStream('gzip')));
            wasm = (await WebAssembly.instantiate(await code.arrayBuffer(), imports)).instance.exports;
            wasm._initialize?.();
            postMessage({ ready: true });
        } else if (data.asleep) {
            asleep.add(data.figure);
            refining.delete(data.figure);
        } else if (data.awake) {
            asleep.delete(data.figure);
            start(data.figure);
        } else {
            draw(data);
        }
    } catch (error) {
        fail(data.figure, error);
    }
};
