// One exercise in a page: its task and hints, the reader's lines, a picture, and the check. Lessons have it as well.
//
//   await play.showExercise(parent, "6.2", {heading})   heading: the element of its title, "h2"
"use strict";

(() => {
  const { play } = Raysteps;
  const restOfKeys = 600; // milliseconds without a key before a text is compiled
  const pictureSize = 160;
  let shared = null;

  // One context for all exercises of a page: browsers give few.
  function sharedGpu() {
    if (!shared) {
      const opened = play.openGpu();
      play.requireWholeNumbers(opened);
      shared = opened;
      shared.listeners = [];
      const tell = (sentence) => () => shared.listeners.forEach((say) => say(sentence));
      shared.onLost = tell("The browser has taken the graphics context away. Your text is kept; the page waits to get it back.");
      shared.onRestored = tell("The graphics context is back. Nothing has been run: look at your text, then press Check.");
      shared.onGone = tell("The browser has taken the graphics context away twice, so nothing runs any more. Your text is kept: reload the page in a few minutes.");
    }
    return shared;
  }

  function element(name, attributes = {}, ...inside) {
    const made = Object.assign(document.createElement(name), attributes);
    made.append(...inside);
    return made;
  }

  // `x` in a task is code.
  const paragraph = (text) => element("p", {}, ...text.split("`").map((piece, i) => (i % 2 ? element("code", {}, piece) : piece)));

  function hintsOf(exercise) {
    return exercise.hints.reduceRight((inner, hint, i) => element("details", { className: "level" },
      element("summary", {}, `Hint ${i + 1}`), paragraph(hint), ...(inner ? [inner] : [])), null);
  }

  const isUserError = (error) => error instanceof play.PlayError;

  async function showExercise(parent, number, { heading = "h2" } = {}) {
    const exercise = await play.openExercise(number);
    const { file } = exercise;
    const { workbook } = play;
    let whole = !file.startsWith("shaders/"); // the contract of a whole walk stands at the top of its file
    let gpu = null;
    let run = null;
    let waiting = 0;
    let checking = null;

    const button = (text, title, act) => element("button", { type: "button", title, onclick: act }, text);
    const title = element(heading, {}, `${number} ${exercise.title}`);
    const state = element("span", { className: "state" });
    const editorPlace = element("div");
    const said = element("pre", { className: "said" });
    said.setAttribute("role", "status");
    said.ariaLive = "polite";
    const figures = element("div", { className: "figures", hidden: true });
    const canvases = Object.fromEntries(["yours", "right", "difference"].map((name) => {
      const canvas = element("canvas", { width: pictureSize, height: pictureSize, ariaLabel: `${name}: no picture yet` });
      canvas.setAttribute("role", "img");
      figures.append(element("figure", {}, canvas, element("figcaption", {}, name === "difference" ? "difference, in orange" : name)));
      return [name, canvas];
    }));
    const view = element("select", { onchange: () => { run.choices.view = view.value; draw(); } },
      ...play.viewNames().map((name) => new Option(name, name, false, name === exercise.picture.view)));
    const choice = element("label", { className: "view", hidden: true }, "Picture of ", view);
    const seen = element("p", { className: "seen" });
    seen.setAttribute("role", "status");
    const opener = element("input", { type: "file", accept: ".glsl,.frag,.vert", hidden: true });
    const back = button("Take back", "what Reset or Open has replaced", () => { workbook.takeBack(file, refresh); refresh(); later(); });
    const wholeButton = button("Whole file", "or the lines of the exercise alone", () => { whole = !whole; refresh(); });
    const bar = element("div", { className: "bar" },
      button("Check", "Ctrl-Enter", check), wholeButton,
      button("Reset", "the stub of this exercise", reset), back,
      button("Save", "the file of a workbook, as ./course reads it", save),
      button("Open", "a file of a workbook", () => opener.click()), opener);
    const box = element("section", { className: "exercise" }, element("header", {}, title, state), ...exercise.task.split(/\n\n+/).map(paragraph),
      ...exercise.formulas.map((formula) => element("p", { className: "formula" }, formula)), hintsOf(exercise),
      element("p", { className: "source" }, `${file}. Source: ${exercise.source}`), bar, editorPlace, said, choice, figures, seen);
    box.ariaLabel = `Exercise ${number}`;
    parent.append(box);
    const editor = play.openEditor(editorPlace, { label: `Your lines of exercise ${number}`, onChange: changed, onRun: check });

    const ownRegion = () => play.regions(workbook.text(file), file)[number];

    // The lines of the exercise, or the whole file where its marks are broken.
    function shownText() {
      if (whole) return workbook.text(file);
      try {
        const region = ownRegion();
        if (region) return region.code.join("\n");
      } catch (error) {
        if (!isUserError(error)) throw error;
      }
      whole = true;
      return workbook.text(file);
    }

    function refresh() {
      editor.setText(shownText());
      editorPlace.classList.toggle("whole", whole);
      wholeButton.textContent = whole ? "Only its lines" : "Whole file";
      showState();
    }

    function showState() {
      state.textContent = workbook.state(exercise);
      state.dataset.state = state.textContent.replace(/ /g, "_");
      back.disabled = !workbook.hasBefore(file);
    }

    function changed(text) {
      try {
        workbook.write(file, whole ? text : withLines(text.split("\n")), refresh);
        showState();
        later();
      } catch (error) {
        if (!isUserError(error)) throw error;
        say(`${error.message} Until then nothing is kept.`);
      }
    }

    // Among the lines of an exercise, none may be a mark.
    function withLines(lines) {
      const text = play.withCode(workbook.text(file), file, { [number]: lines });
      play.regions(text, file);
      return text;
    }

    function mark(lines) {
      const first = whole ? 1 : ownRegion().first;
      editor.mark(lines.map((line) => line - first + 1));
    }

    function reset() {
      let text = play.blank(file, workbook.seed());
      try {
        const region = ownRegion();
        if (region) text = play.withCode(workbook.text(file), file, { [number]: play.stubOf(exercise, region.code, workbook.seed()) });
      } catch (error) {
        if (!isUserError(error)) throw error; // its marks are broken: the whole file starts anew
      }
      workbook.replace(file, text, refresh);
      refresh();
      say("The stub is back. Take back undoes it.");
      later();
    }

    function save() {
      const address = URL.createObjectURL(new Blob([workbook.text(file)], { type: "text/plain" }));
      element("a", { href: address, download: file.replace(/^.*\//, "") }).click();
      setTimeout(() => URL.revokeObjectURL(address), 10000);
      say(`Saved. Put it into your workbook as ${file}, and ./course check ${number} reads it.`);
    }

    opener.addEventListener("change", async () => {
      const [given] = opener.files;
      if (!given) return;
      const text = await given.text();
      opener.value = "";
      try {
        const wanted = Object.keys(play.regions(play.projectText(file), file));
        const found = Object.keys(play.regions(text, given.name));
        const missing = wanted.filter((each) => !found.includes(each)).sort();
        if (missing.length) {
          say(`${given.name}: it has no exercise ${missing.join(", ")}, so it is no ${file} of a workbook. Open the file of that name.`);
          return;
        }
        workbook.replace(file, text, refresh);
        refresh();
        say(`${given.name} is open. Take back brings your former text again.`);
        later();
      } catch (error) {
        if (!isUserError(error)) throw error;
        say(error.message);
      }
    });

    function say(text) {
      said.textContent = text;
    }

    function ready() {
      try {
        if (!gpu) {
          gpu = sharedGpu();
          gpu.listeners.push(say);
        }
      } catch (error) {
        if (!isUserError(error)) throw error;
        say(error.message);
        return false;
      }
      return gpu.state === "ready";
    }

    async function check() {
      clearTimeout(waiting);
      if (!ready()) return;
      run?.stop();
      checking?.abort();
      const own = checking = new AbortController();
      box.dataset.state = "running";
      say(`${number}: being checked.`);
      try {
        const result = await play.check(gpu, exercise, workbook.text(file), { signal: own.signal });
        if (own !== checking) return;
        workbook.remember(exercise, result.state);
        showState();
        say(play.reportOf(exercise, result) + (result.state === "not started" ? "\n  Write your lines first: these are the stub's." : ""));
        mark(result.lines);
        box.dataset.state = result.state.replace(/ /g, "_");
        await draw();
      } catch (error) {
        if (error instanceof play.Stopped) return;
        box.dataset.state = "broken";
        if (!isUserError(error)) console.error(error);
        say(isUserError(error) ? error.message : `The page itself has a fault (${error.message}). Your text is kept: reload the page, and report the fault.`);
      }
    }

    function later() {
      clearTimeout(waiting);
      waiting = setTimeout(draw, restOfKeys);
    }

    // The picture of the reader's text beside that of the project's.
    async function draw() {
      clearTimeout(waiting);
      if (!ready()) return;
      run ??= play.openSession(gpu, { ...exercise.picture, size: pictureSize });
      if (!run.files().includes(exercise.path)) {
        seen.textContent = "No picture of the page goes through this function: the check says whether it is right.";
        return;
      }
      try {
        for (const [path, text] of Object.entries(play.ownEdits(exercise, workbook.text(file)))) run.edit(path, text);
      } catch (error) {
        if (!isUserError(error)) throw error;
        say(error.message);
        return;
      }
      const outcome = await run.go();
      if (outcome.kind === "errors") {
        const { message, words, line } = outcome.errors[0];
        seen.textContent = `The text does not compile (${words || message}). The picture is the last good one; Check names the line.`;
        figures.classList.add("old");
        if (line) box.dataset.line = line;
        return;
      }
      if (outcome.kind !== "picture") {
        if (outcome.sentence) seen.textContent = outcome.sentence;
        return;
      }
      figures.hidden = choice.hidden = false;
      figures.classList.remove("old");
      const { mine, right, difference, rays, stopped } = outcome;
      play.show(canvases.yours, mine.pixels);
      play.show(canvases.right, (right ?? mine).pixels);
      canvases.difference.parentElement.hidden = !difference || exercise.isHunt;
      canvases.right.parentElement.hidden = exercise.isHunt;
      if (exercise.isHunt) {
        seen.textContent = "Where this picture is wrong is what you hunt: so no right one stands beside it.";
        canvases.yours.ariaLabel = `${exercise.picture.scene} by your text`;
        return;
      }
      if (difference) play.show(canvases.difference, difference.pixels);
      const differing = difference?.differing ?? 0;
      seen.textContent = stopped ? stopped.sentence : differing === 0 ? "The picture has the bits of the project's in every pixel."
        : `${differing.toLocaleString("en")} of ${rays.toLocaleString("en")} pixels differ from the project's, first at (${difference.first.x}, ${difference.first.y}).`;
      if (mine.legend) seen.textContent += ` The lightest colour: ${mine.legend.upper} and more ${mine.legend.title}.`;
      canvases.yours.ariaLabel = `${exercise.picture.scene} by your text. ${seen.textContent}`;
      canvases.right.ariaLabel = `${exercise.picture.scene} by the project's text`;
      canvases.difference.ariaLabel = `Where they differ: ${seen.textContent}`;
    }

    function release() {
      clearTimeout(waiting);
      unwatch();
      checking?.abort();
      run?.release();
      box.remove();
    }

    const unwatch = workbook.watch(refresh);
    refresh();
    draw();
    return { box, editor, check, draw, release };
  }

  Object.assign(play, { showExercise });
})();
