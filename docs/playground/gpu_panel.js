// "Your GPU": what every walk makes of the reader's machine, and how many hard cases it gets wrong, as a table and as a file to keep.
"use strict";

document.addEventListener("begun", () => {
  const { play } = Raysteps;
  const { page } = play;
  const find = (id) => document.getElementById(id);
  const say = (sentence) => { find("card-said").textContent = sentence; };
  let stopping = null;
  let card = null;

  async function measure() {
    if (page.gpu?.state !== "ready") {
      say("There is no graphics context: reload the page, and measure again.");
      return;
    }
    page.run.stop();
    const own = stopping = new AbortController();
    const { scene, triangle } = page.run.choices;
    find("card-measure").disabled = true;
    find("card-stop").disabled = false;
    try {
      const opened = await play.openScene(scene);
      card = await play.measureGpu(page.gpu, opened, {
        triangle, signal: own.signal, onProgress: (done, of) => say(`Measuring the walks of ${scene}: ${Math.round(100 * done / of)} %.`),
      });
      const cases = await hardCases(triangle, own.signal);
      if (typeof cases !== "string") card.conformance = cases;
      show(typeof cases === "string" ? cases : inWords(cases));
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      say(error instanceof play.Stopped ? "Stopped. Nothing was measured to its end." : error.message);
    } finally {
      find("card-measure").disabled = false;
      find("card-stop").disabled = true;
      stopping = null;
    }
  }

  // What is wrong in each family of docs/conformance; or a sentence, where the suite is not there.
  async function hardCases(triangle, signal) {
    try {
      const families = await play.runSuite(page.gpu, { triangle, signal, onProgress: (done, of) => say(`Tracing the hard cases: ${done} families of ${of}.`) });
      const sum = (name) => families.reduce((all, row) => all + row[name], 0);
      return { tried: sum("tried"), wrong: sum("wrong"), families: families.map(({ family, tried, wrong }) => ({ family, tried, wrong })) };
    } catch (error) {
      if (!(error instanceof play.PlayError) || error instanceof play.Stopped) throw error;
      return error.message;
    }
  }

  function inWords({ tried, wrong, families }) {
    const where = families.filter((row) => row.wrong).map((row) => `${row.family} ${row.wrong}`).join(", ");
    return `Of ${tried.toLocaleString("en")} hard cases ${wrong.toLocaleString("en")} are wrong${where ? `: ${where}` : ""}.`;
  }

  function cells(kind, texts) {
    const row = document.createElement("tr");
    row.append(...texts.map((text) => Object.assign(document.createElement(kind), { textContent: text })));
    return row;
  }

  function show(cases) {
    const how = card.timer === "gpu" ? "by the GPU's own timer" : "by the clock, since this browser gives no timer of the GPU: slow starts of launches count too";
    const broken = card.rounding.questions.filter(({ wrong, matters }) => wrong && matters);
    const rounds = broken.length ? `It does not round as the lessons do. ${broken.map(({ question }) => question).join(" ")} Not always.` : "This GPU rounds as the lessons do.";
    say(`${card.rounds} rounds in ${card.scene}, ${how}. ${rounds} ${cases}`);
    const digits = (value) => (value < 10 ? value.toFixed(2) : value.toFixed(1));
    const walks = [...card.walks].sort((a, b) => b.million_rays_per_second - a.million_rays_per_second);
    find("card-rows").replaceChildren(...walks.map((walk) => cells("td", [
      walk.contender, `${digits(walk.million_rays_per_second)} (${digits(walk.lowest)}–${digits(walk.highest)})`,
      walk.visits_per_ray?.toFixed(1) ?? "", walk.tests_per_ray?.toFixed(1) ?? "", walk.rays.toLocaleString("en"),
    ])));
    find("card-table").hidden = false;
    find("card-save").disabled = false;
  }

  find("card-measure").addEventListener("click", measure);
  find("card-stop").addEventListener("click", () => stopping?.abort());
  find("card-save").addEventListener("click", () => play.save(`gpu_card_${card.scene.replace(/\W/g, "_")}.json`, `${JSON.stringify(card, null, 1)}\n`));
  // What the reader runs in between would be measured too.
  for (const id of ["run", "scene", "walk", "triangle", "view", "size"]) find(id).addEventListener("click", () => stopping?.abort());
  document.addEventListener("ran", ({ detail }) => {
    if (detail.kind !== "stopped") stopping?.abort();
  });
});
