// The page of the playground: choices, a text, and three pictures. What it runs is in engine/.
"use strict";

(() => {
  const { play } = Raysteps;
  // In localStorage: the choices and all edited texts. What a reader does to those of a link is kept beside the reader's own.
  // A page in a lesson has a place of its own.
  const isFramed = window.parent !== window;
  const kept = `raysteps.playground${isFramed ? location.hash : location.hash.length > 1 ? ".link" : ""}`;
  const restOfKeys = 400; // milliseconds without a key before a text is compiled
  const find = (id) => document.getElementById(id);
  const initial = { scene: "mirrors", walk: "bvh_ordered", triangle: "watertight", view: "normals", size: 256 };
  const onPage = {
    scene: () => play.sceneNames(), walk: () => play.walkNames(),
    triangle: () => play.listParts("triangle").filter(({ file }) => !play.needsDouble(play.files[file])).map(({ name }) => name),
    view: () => play.viewNames(), size: () => [128, 256, 512],
  };
  let gpu = null;
  let run = null;
  let editor = null;
  let file = null;
  let waiting = 0;
  let turn = 0;
  let looked = null; // at which pixel
  const sections = [...document.querySelectorAll("main > details")].map(({ id }) => id);

  function recall() {
    try {
      const state = JSON.parse(localStorage.getItem(kept)) ?? {};
      return (state.link ?? "") === location.hash.replace(/^#$/, "") ? state : null;
    } catch {
      return null;
    }
  }
  function keep() {
    try {
      const link = location.hash.length > 1 ? location.hash : undefined;
      localStorage.setItem(kept, JSON.stringify({ link, choices: run.choices, edits: run.edits, file }));
    } catch {
      // A browser that keeps nothing still runs everything.
    }
  }

  function say(sentence) {
    find("said").textContent = sentence;
  }

  function fill(select, names, chosen) {
    select.replaceChildren(...names.map((name) => new Option(name, name, false, String(name) === String(chosen))));
  }

  function listFiles() {
    const files = run.files();
    const wanted = files.includes(file) ? file : files[0];
    const select = find("file");
    select.replaceChildren(...files.map((path) => new Option(run.edits[path] === undefined ? path : `${path} (edited)`, path, false, path === wanted)));
    if (wanted !== file || editor.text() === "") open(wanted);
    find("reset").disabled = run.edits[file] === undefined;
  }

  function open(path) {
    file = path;
    find("file").value = path;
    editor.setText(run.edits[path] ?? play.files[path]);
    find("reset").disabled = run.edits[path] === undefined;
  }

  function showErrors(errors) {
    const list = find("errors");
    list.replaceChildren(...errors.map((error) => {
      const item = document.createElement("li");
      const place = document.createElement("button");
      place.type = "button";
      place.textContent = error.file ? `${error.file}${error.line ? `:${error.line}` : ""}` : "the text";
      place.addEventListener("click", () => {
        if (!error.file) return;
        open(error.file);
        editor.mark(errors.filter((other) => other.file === error.file).map(({ line }) => line));
        if (error.line) editor.goTo(error.line);
      });
      item.append(place, ` ${error.message}`);
      if (error.words) {
        const words = document.createElement("strong");
        words.textContent = ` ${error.words}`;
        item.append(words);
      }
      return item;
    }));
    editor.mark(errors.filter((error) => error.file === file).map(({ line }) => line));
  }

  function showLegend(legend) {
    find("legend").hidden = !legend;
    if (!legend) return;
    find("legend-title").textContent = legend.title;
    find("legend-upper").textContent = `${legend.upper} and more`;
  }

  function showPictures({ mine, right, difference, milliseconds, rays, stopped }) {
    const { scene, walk, view } = run.choices;
    play.show(find("mine"), mine.pixels);
    play.show(find("right"), (right ?? mine).pixels);
    find("figure-difference").hidden = find("figure-right").hidden = !right;
    if (difference) play.show(find("difference"), difference.pixels);
    showLegend(mine.legend);
    const speed = `${rays.toLocaleString("en")} rays in ${(milliseconds / 1000).toFixed(2)} s.`;
    let verdict = "This is the project's own text.";
    if (difference) {
      verdict = difference.differing === 0 ? "Your text gives the same bits as the project's, in every pixel."
        : `${difference.differing.toLocaleString("en")} of ${rays.toLocaleString("en")} pixels differ from the project's, first at (${difference.first.x}, ${difference.first.y}).`;
    }
    const sentence = stopped ? stopped.sentence : `${verdict} ${speed}`;
    say(sentence);
    find("mine").ariaLabel = `${scene} by ${walk}, ${view}. ${sentence}`;
    if (stopped?.file) showErrors([{ file: stopped.file, line: stopped.line, message: stopped.sentence, words: "" }]);
  }

  // What the address asks for; a bad link is told, and asks for nothing.
  async function asked() {
    try {
      const known = Object.fromEntries(Object.entries(onPage).map(([name, names]) => [name, names()]));
      known.open = sections;
      const linked = await play.readLink(location.hash, known);
      if (linked && !isFramed) find("link-said").textContent = "This page is as its link says. Your own texts are kept beside it: they are on the page without the link.";
      return { ...linked, ...recall() };
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      find("link-said").textContent = error.message;
      return recall() ?? {};
    }
  }

  async function go() {
    clearTimeout(waiting);
    if (!gpu || gpu.state === "gone") return;
    keep();
    listFiles();
    find("stop").disabled = false;
    document.body.dataset.state = "running";
    const own = turn += 1;
    const outcome = await run.go();
    if (own !== turn) return; // another run has begun, and will tell
    if (outcome.kind === "lost" && gpu.state !== "lost") return;
    find("stop").disabled = true;
    document.body.dataset.state = outcome.kind;
    if (outcome.kind === "picture") {
      showErrors([]);
      showPictures(outcome);
    } else if (outcome.kind === "errors") {
      showErrors(outcome.errors);
      const [{ file: where, line, message, words }] = outcome.errors;
      say(`${where ?? "The text"}${line ? `:${line}` : ""}: ${words || message} The picture is the last good one.`);
    } else if (outcome.kind === "stopped") {
      say("Stopped. Ctrl-Enter runs the text again.");
    } else {
      say(outcome.sentence);
    }
    document.dispatchEvent(new CustomEvent("ran", { detail: outcome }));
  }

  function later() {
    clearTimeout(waiting);
    waiting = setTimeout(go, restOfKeys);
  }

  function stopRun() {
    clearTimeout(waiting);
    find("stop").disabled = true;
    run.stop();
  }

  // By a click, or by arrow keys.
  function point(event) {
    const canvas = event.currentTarget;
    const inside = (place, size) => Math.max(0, Math.min(size - 1, Math.floor(place)));
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], Enter: [0, 0] };
    if (event.type === "click") {
      const box = canvas.getBoundingClientRect();
      looked = [(event.clientX - box.left) / box.width * canvas.width, (event.clientY - box.top) / box.height * canvas.height];
    } else if (steps[event.key]) {
      event.preventDefault();
      looked = (looked ?? [canvas.width / 2, canvas.height / 2]).map((place, i) => place + steps[event.key][i]);
    } else {
      return;
    }
    look(inside(looked[0], canvas.width), inside(looked[1], canvas.height));
  }

  function look(x, y) {
    looked = [x, y];
    showPixel(x, y);
    document.dispatchEvent(new Event("looked"));
  }

  function showPixel(x, y) {
    const found = gpu.state === "ready" ? run.pixel(x, y) : null;
    if (!found) return;
    const digits = (value) => Number(value.toPrecision(9)); // which give back the same float
    const line = (name, hit) => {
      const what = hit.triangle === -1 ? "no hit" : hit.triangle < 0 ? "stopped"
        : `triangle ${hit.triangle}, t ${digits(hit.t)}, u ${digits(hit.u)}, v ${digits(hit.v)} (bits ${hit.words.slice(0, 3).map((word) => word.toString(16).padStart(8, "0")).join(" ")})`;
      return `${name}: ${what}${hit.visits === null ? "" : `; ${hit.visits} visits, ${hit.tests} tests`}`;
    };
    find("pixel").textContent = `Pixel (${x}, ${y}). ${line("Yours", found.mine)}${found.right ? `. ${line("Right", found.right)}` : ""}.`;
  }

  function showProbe() {
    const { rows, sentence } = play.probe(gpu);
    find("gpu-name").textContent = gpu.name;
    find("gpu-sentence").textContent = sentence;
    find("gpu-rows").replaceChildren(...rows.map(({ question, wrong, of }) => {
      const row = document.createElement("tr");
      for (const text of [question, wrong === 0 ? "yes" : `not for ${wrong} of ${of}`]) {
        row.append(Object.assign(document.createElement("td"), { textContent: text }));
      }
      return row;
    }));
  }

  async function begin() {
    try {
      await play.openShaders();
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      document.body.dataset.state = "without";
      find("still").hidden = !(find("mine").hidden = true);
      say(error.message);
      return;
    }
    const before = await asked();
    try {
      gpu = play.openGpu();
      showProbe();
      play.requireWholeNumbers(gpu);
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      gpu = null;
      document.body.dataset.state = "without";
      find("still").hidden = !(find("mine").hidden = true);
      find("mine").nextElementSibling.nextElementSibling.textContent = "a picture that was made elsewhere";
      say(error.message);
    }
    run = play.openSession(gpu, initial);
    for (const [name, names] of Object.entries(onPage)) {
      const known = before.choices?.[name];
      if (names().includes(known)) run.choices[name] = known;
      fill(find(name), names(), run.choices[name]);
      find(name).addEventListener("change", ({ target }) => {
        run.choices[name] = name === "size" ? Number(target.value) : target.value;
        if (gpu) go();
        else listFiles();
      });
    }
    for (const [path, text] of Object.entries(before.edits ?? {})) {
      if (play.files[path] !== undefined) run.edit(path, text);
    }
    file = before.file ?? null;
    editor = play.openEditor(find("editor"), {
      label: "The text of the file",
      onChange(text) {
        run.edit(file, text);
        keep();
        find("reset").disabled = run.edits[file] === undefined;
        later();
      },
      onRun: go,
    });
    listFiles();
    find("file").addEventListener("change", ({ target }) => { open(target.value); keep(); });
    find("run").addEventListener("click", go);
    find("stop").addEventListener("click", stopRun);
    find("reset").addEventListener("click", () => {
      run.edit(file, play.files[file]);
      editor.setText(play.files[file]);
      go();
    });
    find("legend-bar").style.background = `linear-gradient(to right, ${play.legendColors.join(", ")})`;
    for (const canvas of [find("mine"), find("right"), find("difference")]) {
      canvas.tabIndex = 0;
      for (const kind of ["click", "keydown"]) canvas.addEventListener(kind, point);
    }
    // For the other sections of the page, which hear "ran" and "looked" of the document, and whoever looks in from outside.
    looked = before.pixel ?? null;
    play.page = { gpu, run, go, editor, begun: before, open, look, looked: () => looked, file: () => file };
    for (const section of before.open ?? []) {
      find(section).open = true;
      find(section).classList.add("asked"); // what a lesson is about stands first in it
    }
    document.dispatchEvent(new Event("begun"));
    if (!gpu) return;
    gpu.onLost = () => {
      document.body.dataset.state = "lost";
      say("The browser has taken the graphics context away. Your text is kept; the page waits to get it back.");
    };
    gpu.onRestored = () => {
      document.body.dataset.state = "restored";
      find("stop").disabled = true;
      say("The graphics context is back. Nothing has been run: look at your text, then press Run.");
    };
    gpu.onGone = () => {
      document.body.dataset.state = "gone";
      find("stop").disabled = true;
      say("The browser has taken the graphics context away twice, so nothing runs any more. Your text is kept: reload the page in a few minutes.");
    };
    await go();
    if (looked && Math.max(...looked) < run.choices.size) look(...looked);
  }

  // In a lesson the page is as high as what it shows.
  if (isFramed) {
    document.body.classList.add("framed");
    new ResizeObserver(() => window.parent.postMessage({ playgroundHeight: document.documentElement.offsetHeight }, "*")).observe(document.documentElement);
  }
  begin();
})();
