// What the figures of a chapter show first: node book/live/measure.mjs CHAPTER WASM prints, for each, its height as a
// part of its width on a phone and on a large screen, what it says, and its samples. The page reserves room for that.
import { readFileSync } from 'node:fs';
import { described, numbers } from '../live.mjs';

const [, , chapter, file] = process.argv;
const imports = new Proxy({}, { get: () => new Proxy({}, { get: () => () => 0 }) });
const wasm = (await WebAssembly.instantiate(readFileSync(file), imports)).instance.exports;
wasm._initialize?.();

// The words that a figure says are in the entry of kind 7: their number, then the numbers in them.
function said(figure) {
    const memory = wasm.memory.buffer;
    const list = new Float64Array(memory, wasm.live_list(figure), wasm.live_list_size(figure));
    const words = Buffer.from(memory, wasm.live_words(figure), wasm.live_words_size(figure)).toString().split('\0');
    for (let at = 0; at < list.length; at += 2 + list[at + 1])
        if (list[at] === 7) return numbers.filled(words[list[at + 4]], list.subarray(at + 5, at + 2 + list[at + 1]));
    return '';
}

const shown = {};
Object.entries(described.get(chapter)).forEach(([name, { controls }], figure) => {
    const heightAt = width => {
        new Float64Array(wasm.memory.buffer, wasm.live_values(), controls.length).set(controls.map(one => +one.value));
        wasm.live_draw(figure, width, 1);
        return +(wasm.live_height(figure) / width).toFixed(4);
    };
    shown[name] = { narrow: heightAt(327), wide: heightAt(821), said: said(figure), samples: wasm.live_samples(figure) };
});
console.log(JSON.stringify(shown));
