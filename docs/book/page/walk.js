// Figures of a ray's walk: <figure class="walk" data-walk="walks/grid.json">. One comes to
// life when it comes near: the viewer is large, and takes seconds on a slow machine. The still picture stays
// where the browser has no WebGL, or the book was made without vtk.js; and on paper.
"use strict";

const walkScript = document.currentScript.src;
const pauseBetweenSteps = 900; // milliseconds, while a walk plays

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

function makeLegend() {
  const entries = [["now", "this step"], ["left-out", "this step, left out"],
    ["before", "steps before"], ["structure", "the structure"], ["ray", "the ray"],
    ["tested", "triangles tested"], ["hit", "hit"]];
  return make("div", { className: "walk-legend" }, ...entries.map(([name, text]) => {
    const mark = make("i", {});
    mark.style.background = `var(--walk-${name})`;
    return make("span", {}, mark, text);
  }));
}

// Buttons, a slider and the keys N, P, Left, Right, Home and End move from step to step. Place 0 is
// the whole structure, before the first step.
function makeControls(canvas, walk, show) {
  const last = walk.steps.length;
  const slider = make("input", { type: "range", min: 0, max: last, value: 0, ariaLabel: "step" });
  const sentence = make("p", { className: "walk-sentence", ariaLive: "polite" });
  const overview = `The whole structure and the ray. Its walk has ${last} steps.`;
  let place = 0;
  let playing = null;

  function move(to) {
    place = Math.max(0, Math.min(last, to));
    slider.value = place;
    sentence.textContent = place === 0 ? overview : walk.steps[place - 1].sentence;
    show(place - 1);
  }
  function pause() {
    clearInterval(playing);
    playing = null;
    play.textContent = "Play";
  }
  function playOn() {
    move(place + 1);
    if (place === last) pause();
  }
  function playOrPause() {
    if (playing) {
      pause();
      return;
    }
    if (place === last) move(0);
    playing = setInterval(playOn, pauseBetweenSteps);
    play.textContent = "Pause";
    playOn();
  }
  function moveByHand(to) {
    pause();
    move(to);
  }

  const play = make("button", { type: "button", textContent: "Play", onclick: playOrPause });
  const button = (text, change) => make("button", { type: "button", textContent: text,
    onclick: () => moveByHand(change()) });
  slider.oninput = () => moveByHand(Number(slider.value));
  const keys = { n: () => place + 1, ArrowRight: () => place + 1, p: () => place - 1,
    ArrowLeft: () => place - 1, Home: () => 0, End: () => last };
  const bar = make("div", { className: "walk-buttons" }, play, button("Previous", keys.p),
    button("Next", keys.n), slider);
  [canvas, bar].forEach((element) => element.addEventListener("keydown", (event) => {
    if (keys[event.key]) {
      event.preventDefault();
      event.stopPropagation();
      moveByHand(keys[event.key]());
    }
  }));
  const note = make("p", { className: "walk-note", textContent:
    "Drag to turn, with Shift to move; with a finger, drag the round handle. After a click the wheel "
    + "zooms, and N and P, or the arrow keys, step." });
  move(0);
  return [bar, sentence, makeLegend(), note];
}

// A finger on the figure scrolls the page, and the wheel does where nobody has clicked on it.
function leaveScrollingToThePage(canvas) {
  const pass = (kinds, isForThePage) => kinds.forEach((kind) => canvas.addEventListener(kind, (event) => {
    if (isForThePage(event)) event.stopPropagation();
  }, { capture: true }));
  pass(["pointerdown", "pointermove", "pointerup"], (event) => event.pointerType === "touch");
  pass(["wheel"], () => document.activeElement !== canvas);
}

// What turns the figure under a finger, and by the arrow keys.
function makeHandle(turn) {
  const handle = make("button", { type: "button", className: "walk-turn", textContent: "\u27f3",
    title: "drag to turn", ariaLabel: "turn the figure: drag, or the arrow keys" });
  let from = null;
  handle.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener("pointermove", (event) => {
    if (!from) return;
    turn(event.clientX - from[0], event.clientY - from[1]);
    from = [event.clientX, event.clientY];
  });
  ["pointerup", "pointercancel"].forEach((kind) => handle.addEventListener(kind, () => { from = null; }));
  const steps = { ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, -20], ArrowDown: [0, 20] };
  handle.addEventListener("keydown", (event) => {
    if (!steps[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    turn(...steps[event.key]);
  });
  return handle;
}

async function bringToLife(figure) {
  const walk = await (await fetch(figure.dataset.walk)).json();
  const picture = figure.querySelector("img");
  const canvas = make("div", { className: "walk-canvas", tabIndex: 0, role: "img",
    ariaLabel: picture.alt });
  leaveScrollingToThePage(canvas);
  picture.classList.add("only-printed");
  const frame = make("div", { className: "walk-frame" }, canvas);
  picture.after(frame);
  const scene = makeWalkScene(canvas, walk);
  figure.scene = scene;
  frame.append(makeHandle(scene.turn));
  frame.after(...makeControls(canvas, walk, scene.show));
  new MutationObserver(scene.recolor).observe(document.body,
    { attributeFilter: ["data-md-color-scheme"] });
  figure.dataset.ready = "yes";
}

function bringAllToLife() {
  const figures = [...document.querySelectorAll("figure.walk")];
  if (figures.length === 0) {
    return;
  }
  const stand = (reason) => figures.forEach((figure) => figure.querySelector("figcaption").append(
    make("p", { className: "walk-note", textContent: `The figure stands still: ${reason}.` })));
  if (figures[0].dataset.viewer === "none") {
    stand("the book was made without a network, and so without vtk.js");
  } else {
    let viewer = null;
    const observer = new IntersectionObserver((seen) => {
      const near = seen.filter((one) => one.isIntersecting).map((one) => one.target);
      if (near.length > 0 && !viewer && !hasWebGl()) {
        observer.disconnect();
        stand("this browser has no WebGL 2");
        return;
      }
      near.forEach((figure) => {
        observer.unobserve(figure);
        viewer ??= loadViewer();
        viewer.then(() => bringToLife(figure));
      });
    }, { rootMargin: "600px" });
    figures.forEach((figure) => observer.observe(figure));
  }
}

bringAllToLife();
