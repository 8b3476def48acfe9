// Runs the figures of a chapter in a thread of their own, so that the page never stalls.
'use strict';

let wasm;
const asleep = new Set();    // figures that nobody can see
const refining = new Set();  // those of the others whose picture gets better
const drawn = new Map();     // for each figure, the request that it shows

// What figures may ask of a system. They need none of it. Nothing can be printed: files do not exist.
const badFile = 8;  // as WASI numbers its errors
const imports = new Proxy({}, { get: () => new Proxy({}, {
    get: (_, name) => /exit|abort|throw/.test(name) ? () => { throw new Error(`the figure ended: ${name}`); }
        : () => name.startsWith('fd_') ? badFile : 0,
}) });

// Before a figure's code runs: it may never return.
const begins = figure => postMessage({ draws: figure });

function answer(figure, more) {
    const memory = wasm.memory.buffer, { id, part, parts } = drawn.get(figure);
    const of = { figure, id, part, parts, done: wasm.live_done(figure), samples: wasm.live_samples(figure), ...more };
    const entries = new Float64Array(memory, wasm.live_list(figure), wasm.live_list_size(figure));
    const copy = at => new Uint8ClampedArray(memory, entries[at + 11], 4 * entries[at + 8] * entries[at + 9]).slice();
    const places = [];  // of pictures among the entries
    for (let at = 0; at < entries.length; at += 2 + entries[at + 1]) if (entries[at] === 6) places.push(at);
    const refined = places.findIndex(at => entries[at + 11] === wasm.live_refined(figure));
    if (part > 0) {  // only the picture is needed
        const pixels = refined < 0 ? new Uint8ClampedArray() : copy(places[refined]);
        return postMessage({ ...of, pixels, columns: entries[places[refined] + 8] }, [pixels.buffer]);
    }
    const pictures = places.map(copy), list = entries.slice();
    places.forEach((at, number) => { list[at + 11] = number; });  // instead of its address
    const words = new TextDecoder().decode(
        new Uint8Array(memory, wasm.live_words(figure), wasm.live_words_size(figure))).split('\0');
    postMessage({ ...of, list, words, pictures, refined, height: wasm.live_height(figure) },
                [list.buffer, ...pictures.map(picture => picture.buffer)]);
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
            begins(figure);
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

function draw(request) {
    const { figure, values, drag, ranges, width, ratio, part, parts } = request;
    begins(figure);
    drawn.set(figure, request);
    const own = () => new Float64Array(wasm.memory.buffer, wasm.live_values(), values.length);
    own().set(values);
    if (drag) wasm.live_drag(figure, ...drag.down, ...drag.at, width);
    own().set(ranges.map(([least, most], i) => Math.min(most, Math.max(least, own()[i]))));
    const used = [...own()];
    wasm.live_draw(figure, width, ratio);
    wasm.live_take(figure, part, parts);
    start(figure);
    if (refining.has(figure)) refineFor(figure, 20);
    answer(figure, { answers: true, values: drag ? used : undefined });
}

async function load(code) {
    const packed = new Blob([Uint8Array.from(atob(code), letter => letter.charCodeAt(0))]);
    const unpacked = new Response(packed.stream().pipeThrough(new DecompressionStream('gzip')));
    wasm = (await WebAssembly.instantiate(await unpacked.arrayBuffer(), imports)).instance.exports;
    wasm._initialize?.();
    postMessage({ ready: true });
}

let loaded;
onmessage = async ({ data }) => {
    try {
        if (data.code) loaded = load(data.code);
        await loaded;
        if (data.asleep) {
            asleep.add(data.figure);
            refining.delete(data.figure);
        } else if (data.awake) {
            asleep.delete(data.figure);
            if (drawn.has(data.figure)) start(data.figure);
        } else if (!data.code) {
            draw(data);
        }
    } catch (error) {
        fail(data.figure, error);
    }
};
