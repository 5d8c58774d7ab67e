// "Step your walk": the reader's text beside the project's own for one pixel, to the step where they part.
"use strict";

document.addEventListener("begun", () => {
  const { play } = Raysteps;
  const { page } = play;
  const find = (id) => document.getElementById(id);
  const panel = find("steps");
  const canvas = find("steps-figure");
  const list = find("steps-list");
  const mostOfTriangles = 2000; // of a scene that are drawn
  const mostOfBoxes = 60; // of the steps before
  let shown = null; // {scene, mine, right, parting, count, noun, pixel}
  let step = 0; // from 0; `count` is the end, behind the last step
  let wanted = page.begun.step; // by a link
  let turn = 0;
  const view = { yaw: 0, pitch: 0 };

  page.step = () => (panel.open && shown ? step + 1 : undefined);

  function say(sentence) {
    find("steps-said").textContent = sentence;
  }

  function forget(sentence) {
    shown = null;
    list.replaceChildren();
    find("steps-body").hidden = true;
    say(sentence);
  }

  async function record() {
    const own = turn += 1;
    const { gpu, run } = page;
    if (!panel.open) return;
    if (gpu?.state !== "ready") {
      forget("Nothing is stepped without a graphics context: the page says above what is missing.");
      return;
    }
    const { scene: name, walk, triangle, size } = run.choices;
    const looked = page.looked();
    if (!looked || Math.max(...looked) >= size) {
      forget("Choose a pixel in a picture: its ray is walked here, step by step.");
      return;
    }
    try {
      const scene = await play.openScene(name);
      if (own !== turn) return;
      const asked = { walk, triangle, size, pixel: looked };
      const mine = play.recordSteps(gpu, scene, { ...asked, edits: run.edits });
      const right = play.recordSteps(gpu, scene, asked);
      const isSame = shown && String(shown.pixel) === String(looked) && shown.scene === scene && shown.walk === walk;
      shown = {
        scene, name, walk, mine, right, pixel: looked, noun: play.placeName(scene, walk), parting: play.partingOf(mine, right),
        count: Math.max(mine.steps.length, right.steps.length),
      };
      if (!isSame) turnToRay();
      fillList();
      find("steps-body").hidden = false;
      const start = wanted !== undefined ? wanted - 1 : isSame ? step : Math.max(0, shown.parting);
      wanted = undefined;
      move(start);
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      forget(error instanceof play.CompileError ? "Your text is not compiled: mend it, and its steps are here." : error.message);
    }
  }

  // Beside the ray, from a little above.
  function turnToRay() {
    const [x, , z] = shown.right.ray.direction;
    view.yaw = Math.atan2(-x, -z) + 1.1;
    view.pitch = 0.35;
  }

  const digits = (value) => Number(value.toPrecision(6));
  const inWords = (hit) => (hit ? `triangle ${hit.triangle} at t ${digits(hit.t)}` : "none");
  function summary(one) {
    if (!one) return "no step";
    const tests = one.tested.length && shown.noun !== "triangle" ? `, tests ${one.tested.join(" ")}` : "";
    return `${play.nameOfPlace(shown.scene, shown.walk, one)}${tests}`;
  }

  function fillList() {
    const { mine, right, parting, count } = shown;
    list.replaceChildren(...Array.from({ length: count }, (_, i) => {
      const item = document.createElement("li");
      item.className = parting >= 0 && i >= parting ? "parted" : "";
      for (const one of [mine.steps[i], right.steps[i]]) item.append(Object.assign(document.createElement("span"), { textContent: summary(one) }));
      item.addEventListener("click", () => move(i));
      return item;
    }));
    find("steps-part").disabled = parting < 0;
    find("steps-save").disabled = false;
  }

  const endOf = ({ steps, ended, stopped, hit }) => (stopped ? `a loop without an end is stopped in round ${stopped}`
    : ended ? `after ${steps.length} steps the hit is ${inWords(hit)}` : `there are more than ${steps.length} steps`);

  function sentenceOf(i) {
    const { mine, right, parting, count, pixel } = shown;
    const together = parting < 0 ? "The two walks are the same in every step." : parting === i ? "Here the two walks part." : `They part at step ${parting + 1}.`;
    if (i >= count) return `The end of the walks at pixel (${pixel}). Yours: ${endOf(mine)}. The right one: ${endOf(right)}. ${together}`;
    const tell = (walk) => (walk.steps[i] ? play.sentenceOfStep(shown.scene, shown.walk, walk, i).replace(/^step \d+: /, "") : "it has ended");
    const own = mine.steps[i];
    const both = parting < 0 || i < parting;
    return `Step ${i + 1} of ${count}${own ? `, round ${own.round}` : ""}. ${both ? "Both" : "Yours"}: ${tell(mine)}. ${both ? "" : `The right one: ${tell(right)}. `}${together}`;
  }

  function move(to) {
    if (!shown) return;
    step = Math.max(0, Math.min(shown.count, to));
    [...list.children].forEach((item, i) => item.classList.toggle("now", i === step));
    const item = list.children[step];
    if (item) list.scrollTop = item.offsetTop - list.offsetTop - list.clientHeight / 2;
    say(sentenceOf(step));
    const own = shown.mine.steps[step];
    const line = find("steps-line");
    line.hidden = !own?.file;
    if (own?.file) {
      const text = page.run.edits[own.file] ?? play.files[own.file];
      line.textContent = `${own.file}:${own.line}  ${(text.split("\n")[own.line - 1] ?? "").trim()}`;
      line.onclick = () => {
        page.open(own.file);
        page.editor.goTo(own.line);
      };
    }
    draw();
  }

  function draw() {
    if (!shown || !canvas.clientWidth) return;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const pen = canvas.getContext("2d", { willReadFrequently: true }); // drawn by the processor: the GPU has other work
    pen.scale(ratio, ratio);
    const style = getComputedStyle(document.body);
    const colors = Object.fromEntries(["--ink", "--line", "--muted", "--accent", "--right"].map((name) => [name, style.getPropertyValue(name).trim()]));
    const color = (name) => colors[name];
    const corners = shown.scene.arrays.triangle_corners;
    const place = projection(extentOf(corners), width, height);
    const trace = (points, closed) => {
      points.forEach((point, i) => pen[i ? "lineTo" : "moveTo"](...place(point)));
      if (closed) pen.closePath();
    };
    const path = (points, closed) => {
      pen.beginPath();
      trace(points, closed);
    };
    const stroke = (name, thick, dash = []) => {
      pen.strokeStyle = color(name);
      pen.lineWidth = thick;
      pen.setLineDash(dash);
      pen.stroke();
    };
    const triangleOf = (i) => [0, 1, 2].map((corner) => [...corners.data.subarray(12 * i + 4 * corner, 12 * i + 4 * corner + 3)]);
    const drawBox = (box, name, thick, dash) => {
      if (!box) return;
      const corner = (i) => [0, 1, 2].map((axis) => box[i >> axis & 1][axis]);
      pen.beginPath();
      for (const [a, b] of boxEdges) trace([corner(a), corner(b)]);
      stroke(name, thick, dash);
    };
    pen.globalAlpha = 0.25;
    pen.beginPath();
    const every = Math.ceil(shown.scene.triangles / mostOfTriangles);
    for (let i = 0; i < shown.scene.triangles; i += every) trace(triangleOf(i), true);
    stroke("--line", 0.5);
    const { mine, right, parting } = shown;
    for (const before of mine.steps.slice(Math.max(0, step - mostOfBoxes), step)) drawBox(before.box, "--muted", 0.8);
    pen.globalAlpha = 1;
    const { origin, direction } = right.ray;
    const far = 4 * shown.scene.reach / Math.hypot(...direction);
    path([origin, origin.map((value, axis) => value + far * direction[axis])]);
    stroke("--ink", 1.2);
    const [own, other] = [mine.steps[step], right.steps[step]];
    if (parting >= 0 && step >= parting && other) drawBox(other.box, "--right", 2, [6, 4]);
    if (own) drawBox(own.box, "--accent", 2);
    for (const triangle of own?.tested ?? []) {
      if (triangle < 0 || triangle >= shown.scene.triangles) continue;
      path(triangleOf(triangle), true);
      pen.fillStyle = color("--accent");
      pen.globalAlpha = 0.5;
      pen.fill();
      pen.globalAlpha = 1;
      stroke("--accent", 1.5);
    }
    const dot = (hit, ray, name) => {
      if (!hit || !Number.isFinite(hit.t)) return;
      pen.beginPath();
      pen.arc(...place(ray.origin.map((value, axis) => value + hit.t * ray.direction[axis])), 4, 0, 2 * Math.PI);
      pen.fillStyle = color(name);
      pen.fill();
    };
    dot((other ?? right).nearest ?? (step >= right.steps.length ? right.hit : null), right.ray, "--right");
    dot((own ?? mine).nearest ?? (step >= mine.steps.length ? mine.hit : null), mine.ray, "--accent");
    canvas.ariaLabel = find("steps-said").textContent;
  }

  const boxEdges = [0, 1, 2].flatMap((axis) => [0, 1, 2, 3, 4, 5, 6, 7].filter((i) => !(i >> axis & 1)).map((i) => [i, i | 1 << axis]));

  function extentOf({ data }) {
    const extent = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let i = 0; i < data.length; ++i) {
      if (i % 4 === 3) continue;
      extent[0][i % 4] = Math.min(extent[0][i % 4], data[i]);
      extent[1][i % 4] = Math.max(extent[1][i % 4], data[i]);
    }
    return extent;
  }

  // Seen from far away, turned about the middle of the scene.
  function projection([lower, upper], width, height) {
    const middle = lower.map((value, axis) => (value + upper[axis]) / 2);
    const scale = 0.95 * Math.min(width, height) / Math.hypot(...lower.map((value, axis) => upper[axis] - value));
    const [sine, cosine] = [Math.sin(view.yaw), Math.cos(view.yaw)];
    const [rise, level] = [Math.sin(view.pitch), Math.cos(view.pitch)];
    return (point) => {
      const [x, y, z] = point.map((value, axis) => value - middle[axis]);
      const near = sine * x + cosine * z;
      return [width / 2 + scale * (cosine * x - sine * z), height / 2 - scale * (level * y - rise * near)];
    };
  }

  function turnBy(right, down) {
    view.yaw -= right / 120;
    view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + down / 120));
    draw();
  }

  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons === 1) turnBy(event.movementX, event.movementY);
  });
  const keys = { ArrowLeft: () => step - 1, ArrowRight: () => step + 1, Home: () => 0, End: () => shown.count };
  find("steps-body").addEventListener("keydown", (event) => {
    if (!shown || !keys[event.key] || event.target.id === "link") return;
    event.preventDefault();
    move(keys[event.key]());
  });
  find("steps-back").addEventListener("click", () => move(step - 1));
  find("steps-on").addEventListener("click", () => move(step + 1));
  find("steps-part").addEventListener("click", () => move(shown.parting));
  find("steps-save").addEventListener("click", () => {
    const { name, walk, mine, pixel } = shown;
    const recorded = play.recordedSteps(mine, { name: `${walk} at pixel (${pixel}) of ${name}`, scene: name, of: shown.scene, walk });
    play.save(`steps_${walk}_${name.replace(/\W/g, "_")}.json`, `${JSON.stringify(recorded, null, 1)}\n`);
  });
  panel.addEventListener("toggle", record);
  document.addEventListener("looked", record);
  document.addEventListener("ran", ({ detail }) => {
    if (detail.kind === "picture") record();
    else if (panel.open && detail.kind === "errors") forget("Your text is not compiled: mend it, and its steps are here.");
  });
  addEventListener("resize", draw);
  if (wanted !== undefined) panel.open = true;
});
