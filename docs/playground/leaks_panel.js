// "Rays that leak": the chosen triangle test, and all others, on rays that nothing may lose.
"use strict";

document.addEventListener("begun", () => {
  const { play } = Raysteps;
  const { page } = play;
  const find = (id) => document.getElementById(id);
  const panel = find("leaks");
  const count = 16384;
  let turn = 0;
  let stopping = null;
  let counts = new Map(); // by triangle test, of the project's own text

  const say = (sentence) => { find("leaks-said").textContent = sentence; };
  const inWords = ({ leaks, of }) => `${leaks.toLocaleString("en")} of ${of.toLocaleString("en")}`;
  const inDigits = (numbers) => numbers.map((number) => play.significant(number, 9)).join(", ");

  async function ready() {
    if (!panel.open) return null;
    if (page.gpu?.state !== "ready") {
      say("No rays are traced without a graphics context: the page says above what is missing.");
      return null;
    }
    const scene = await play.openScene(page.run.choices.scene);
    const aimed = play.aimedRays(scene, count);
    if (aimed) return { scene, aimed };
    say(`${page.run.choices.scene} has no closed body to start in. Choose mirrors or tetrahedron:2.`);
    return null;
  }

  async function trace(edits, triangle, asked, signal) {
    return play.countLeaks(page.gpu, asked.scene, asked.aimed, { walk: page.run.choices.walk, triangle, edits, signal });
  }

  // What may go wrong in another's text is told above.
  async function quietly(act) {
    try {
      await act();
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      if (!(error instanceof play.Stopped)) say(error instanceof play.CompileError ? "Your text is not compiled: mend it, and its rays are here." : error.message);
    }
  }

  const show = () => quietly(async () => {
    const own = turn += 1;
    stopping?.abort();
    const asked = await ready();
    if (!asked || own !== turn) return;
    const { triangle } = page.run.choices;
    const found = await trace(page.run.edits, triangle, asked, null);
    if (own !== turn) return;
    play.show(find("leaks-picture"), found.pixels);
    const where = found.first ? ` The first goes from (${inDigits(found.first.slice(0, 3))}) along (${inDigits(found.first.slice(3, 6))}).` : "";
    const sentence = found.stopped ? found.stopped.sentence
      : `${triangle}: ${inWords(found)} rays got out of ${asked.aimed.bodies.length} closed bodies.${where}`;
    say(sentence);
    find("leaks-picture").ariaLabel = sentence;
  });

  const showAll = () => quietly(async () => {
    const asked = await ready();
    if (!asked) return;
    stopping?.abort();
    const own = stopping = new AbortController();
    counts = new Map();
    find("leaks-table").hidden = false;
    for (const { value } of find("triangle").options) {
      say(`${value} is being asked.`);
      counts.set(value, await trace({}, value, asked, own.signal));
      const rows = [...counts].sort(([, a], [, b]) => b.leaks - a.leaks);
      find("leaks-rows").replaceChildren(...rows.map(([name, found]) => {
        const row = document.createElement("tr");
        row.append(...[name, inWords(found)].map((text) => Object.assign(document.createElement("td"), { textContent: text })));
        return row;
      }));
    }
    say(`${counts.size} triangle tests had the same ${count.toLocaleString("en")} rays through ${page.run.choices.walk} in ${page.run.choices.scene}.`);
  });

  panel.addEventListener("toggle", show);
  find("leaks-all").addEventListener("click", showAll);
  document.addEventListener("ran", ({ detail }) => {
    if (detail.kind === "picture") show();
  });
});
