// Drawings that move: ![...](pictures/NAME.svg){ data-moving="pictures/NAME.js" }. The picture stands still until its
// moments are loaded; then a slider, its arrow keys, or a finger or mouse upon the drawing go through them.
"use strict";

window.drawingMoments = {};

function setInMotion(picture, { svg, words, still }) {
  const figure = document.createElement("figure");
  figure.className = "moving";
  figure.innerHTML = svg;
  const drawing = figure.firstElementChild;
  const moments = [...drawing.querySelectorAll(".moment")];
  const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: moments.length - 1 });
  slider.setAttribute("aria-label", "what moves in the drawing");
  const sentence = document.createElement("output");

  function show(number) {
    moments.forEach((moment, i) => moment.classList.toggle("shown", i === number));
    slider.value = number;
    slider.setAttribute("aria-valuetext", words[number]);
    sentence.textContent = words[number];
  }

  function drag(event) {
    if (event.buttons === 0) return;
    const { left, width } = drawing.getBoundingClientRect();
    const part = (event.clientX - left) / width;
    show(Math.max(0, Math.min(moments.length - 1, Math.round(part * (moments.length - 1)))));
  }

  slider.oninput = () => show(Number(slider.value));
  drawing.addEventListener("pointerdown", drag);
  drawing.addEventListener("pointermove", drag);
  const bar = document.createElement("div");
  bar.append(slider, sentence);
  figure.append(bar);
  show(still);
  picture.replaceWith(figure);
}

function load(picture) {
  const script = document.createElement("script");
  script.src = picture.dataset.moving;
  script.onload = () => setInMotion(picture, window.drawingMoments[picture.dataset.moving]);
  document.head.append(script);
}

const whenNear = new IntersectionObserver((entries) => {
  for (const entry of entries.filter((one) => one.isIntersecting)) {
    whenNear.unobserve(entry.target);
    load(entry.target);
  }
}, { rootMargin: "800px" });
document.querySelectorAll("img[data-moving]").forEach((picture) => whenNear.observe(picture));
