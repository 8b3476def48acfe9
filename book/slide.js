'use strict';

// The line between two pictures moves with the slider's thumb, and with the pointer on them.
function slide(figure) {
    const slider = figure.querySelector('input'), pair = figure.querySelector('.pair');
    const [left, right] = figure.querySelectorAll('.word');
    const show = () => {
        figure.style.setProperty('--at', `${slider.value}%`);
        left?.style.setProperty('--seen', +(slider.value > 15));
        right?.style.setProperty('--seen', +(slider.value < 85));
    };
    slider.addEventListener('input', show);
    const drag = event => {
        const box = pair.getBoundingClientRect();
        slider.value = 100 * (event.clientX - box.left) / box.width;
        show();
    };
    pair.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        if (event.pointerType === 'mouse') event.preventDefault();  // else it would drag the image
        pair.setPointerCapture(event.pointerId);
        if (event.pointerType !== 'touch') drag(event);
    });
    pair.addEventListener('pointermove', event => {
        if (pair.hasPointerCapture(event.pointerId)) drag(event);
    });
    pair.addEventListener('dragstart', event => event.preventDefault());
}
