// Figures of a ray's walk: <figure class="walk" data-walk="walks/grid.json">. The still picture stays
// where the browser has no WebGL, or the book was made without vtk.js.
"use strict";

const walkScript = document.currentScript.src;

function hasWebGl() {
  const canvas = document.createElement("canvas");
  return Boolean(canvas.getContext("webgl2"));
}

function loadViewer() {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = new URL("vtk.js", walkScript).href;
    script.onload = resolve;
    script.onerror = () => reject(new Error("the book was made without vtk.js"));
    document.head.append(script);
  });
}

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

function cssColor(color) {
  return `rgb(${color.map((part) => Math.round(255 * part)).join(",")})`;
}

function makeLegend() {
  const entries = [["now", "this step"], ["leftOut", "this step, left out"],
    ["before", "steps before"], ["ray", "the ray"], ["tested", "triangles tested"], ["hit", "hit"]];
  return make("div", { className: "walk-legend" }, ...entries.map(([name, text]) => {
    const mark = make("i", {});
    mark.style.background = cssColor(walkColors[name]);
    return make("span", {}, mark, text);
  }));
}

// Buttons, a slider and the keys N, P, Left, Right, Home and End move from step to step.
function makeControls(canvas, walk, goTo) {
  const last = walk.steps.length - 1;
  const slider = make("input", { type: "range", min: 0, max: last, value: 0, ariaLabel: "step" });
  const sentence = make("p", { className: "walk-sentence", ariaLive: "polite" });
  let step = 0;
  function move(to) {
    step = Math.max(0, Math.min(last, to));
    slider.value = step;
    sentence.textContent = walk.steps[step].sentence;
    goTo(step);
  }
  const button = (text, change) => make("button", { type: "button", textContent: text,
    onclick: () => move(change()) });
  slider.oninput = () => move(Number(slider.value));
  const keys = { n: () => step + 1, ArrowRight: () => step + 1, p: () => step - 1,
    ArrowLeft: () => step - 1, Home: () => 0, End: () => last };
  const bar = make("div", { className: "walk-buttons" }, button("Previous", keys.p),
    button("Next", keys.n), slider);
  [canvas, bar].forEach((element) => element.addEventListener("keydown", (event) => {
    if (keys[event.key]) {
      event.preventDefault();
      event.stopPropagation();
      move(keys[event.key]());
    }
  }));
  // The wheel scrolls the page over a figure that nobody has clicked on.
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) {
      event.stopPropagation();
    }
  }, { capture: true });
  const note = make("p", { className: "walk-note", textContent:
    "Drag to turn, with Shift to move. After a click the wheel zooms, and N and P, or the arrow "
    + "keys, step." });
  return { parts: [bar, sentence, makeLegend(), note], move };
}

async function bringToLife(figure) {
  const walk = await (await fetch(figure.dataset.walk)).json();
  const canvas = make("div", { className: "walk-canvas", tabIndex: 0, role: "img",
    ariaLabel: figure.querySelector("img").alt });
  figure.querySelector("img").replaceWith(canvas);
  const scene = makeWalkScene(canvas, walk);
  figure.scene = scene;
  const controls = makeControls(canvas, walk, scene.show);
  canvas.after(...controls.parts);
  controls.move(0);
  figure.dataset.ready = "yes";
}

async function bringAllToLife() {
  const figures = [...document.querySelectorAll("figure.walk")];
  if (figures.length === 0) {
    return;
  }
  const stand = (reason) => figures.forEach((figure) => figure.querySelector("figcaption").append(
    make("p", { className: "walk-note", textContent: `The figure stands still: ${reason}.` })));
  if (figures[0].dataset.viewer === "none") {
    stand("the book was made without a network, and so without vtk.js");
  } else if (!hasWebGl()) {
    stand("this browser has no WebGL 2");
  } else {
    await loadViewer();
    await Promise.all(figures.map(bringToLife));
  }
}

bringAllToLife();
