// The reader's workbook: a copy of each file that has exercises, with stubs in the place of solutions, kept by the browser.
//
//   play.workbook.text(file)          as it is now; file: "shaders/structure/bvh/bvh_skip.glsl"
//   play.workbook.seed()              a number of four digits, which chooses the mistakes that are hunted
//   play.workbook.write(file, text, who)     `who` wrote it, and is not told
//   play.workbook.replace(file, text, who)   the same, and what stood there can be taken back
//   play.workbook.takeBack(file, who)        does so; true where there was something
//   play.workbook.state(exercise), play.workbook.remember(exercise, state)   as last checked, as long as the lines stay the same
//   play.workbook.watch(who)          who() is called after what others have written, in this page or another one, until
//                                     the function that this gives is called
"use strict";

(() => {
  const { play } = Raysteps;
  const kept = "raysteps.workbook";
  const watching = [];
  let book = recall();

  function recall() {
    const empty = { texts: {}, before: {}, states: {} };
    try {
      return { ...empty, ...JSON.parse(localStorage.getItem(kept)) };
    } catch {
      return empty;
    }
  }
  function store() {
    try {
      localStorage.setItem(kept, JSON.stringify(book));
    } catch {
      // A browser that keeps nothing still checks everything; Save writes a file.
    }
  }
  function keep(who) {
    store();
    for (const other of watching) if (other !== who) other();
  }
  addEventListener("storage", ({ key }) => {
    if (key !== kept) return;
    book = recall();
    for (const other of watching) other();
  });

  const text = (file) => book.texts[file] ?? play.blank(file, seed());

  // Chooses what is hunted, in this workbook.
  function seed() {
    if (book.seed === undefined) {
      book.seed = 1000 + Math.floor(9000 * Math.random());
      store();
    }
    return book.seed;
  }

  function write(file, changed, who) {
    if (text(file) === changed) return;
    book.texts[file] = changed;
    keep(who);
  }

  function replace(file, changed, who) {
    if (text(file) === changed) return;
    book.before[file] = text(file);
    write(file, changed, who);
  }

  function takeBack(file, who) {
    if (book.before[file] === undefined) return false;
    replace(file, book.before[file], who);
    return true;
  }

  const hasBefore = (file) => book.before[file] !== undefined;

  function codeOf({ number, file }) {
    try {
      return play.regions(text(file), file)[number]?.code.join("\n") ?? null;
    } catch (error) {
      if (error instanceof play.PlayError) return null;
      throw error;
    }
  }

  function remember(exercise, state) {
    book.states[exercise.number] = { state, code: codeOf(exercise) };
    keep(null);
  }

  function state(exercise) {
    const code = codeOf(exercise);
    if (code === null) return "missing";
    const known = book.states[exercise.number];
    if (known && known.code === code) return known.state;
    return play.isStub(exercise, text(exercise.file)) ? "not started" : "not checked";
  }

  function watch(who) {
    watching.push(who);
    return () => watching.splice(watching.indexOf(who), 1);
  }

  play.workbook = { text, seed, write, replace, takeBack, hasBefore, state, remember, watch };
})();
