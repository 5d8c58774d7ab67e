// The page of the exercises: one at a time, named in the address as #exercise=6.2.
"use strict";

(() => {
  const { play } = Raysteps;
  const select = document.getElementById("exercise");
  const place = document.getElementById("place");
  let shown = null;

  function list() {
    const wanted = numberInAddress();
    select.replaceChildren(...play.exercises.map((exercise) =>
      new Option(`${exercise.number} ${exercise.title}: ${play.workbook.state(exercise)}`, exercise.number, false, exercise.number === wanted)));
    const passed = play.exercises.filter((exercise) => play.workbook.state(exercise) === "passed").length;
    document.getElementById("progress").textContent = `${passed} of ${play.exercises.length} passed.`;
  }

  const numberInAddress = () => /exercise=([\d.]+)/.exec(location.hash)?.[1] ?? play.exercises[0].number;

  async function show() {
    const number = numberInAddress();
    document.body.dataset.exercise = "";
    shown?.release();
    shown = null;
    place.replaceChildren();
    list();
    try {
      shown = await play.showExercise(place, number);
      play.page = shown; // for whoever looks in from outside
      document.body.dataset.exercise = number;
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      place.textContent = error.message;
    }
  }

  async function begin() {
    await play.loadAll();
    select.addEventListener("change", () => { location.hash = `exercise=${select.value}`; });
    addEventListener("hashchange", show);
    play.workbook.watch(list);
    show();
  }

  begin().catch((error) => { place.textContent = error.message; });
})();
