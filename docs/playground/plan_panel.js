// "The plan": which effects the scene calls for, and what a pass that nothing calls for would change.
"use strict";

document.addEventListener("begun", () => {
  const { play } = Raysteps;
  const { page } = play;
  const find = (id) => document.getElementById(id);
  const panel = find("plan");
  let before = null; // {key, linear, all}: the last picture of the same scene and text

  function row(kind, texts) {
    const made = document.createElement("tr");
    made.append(...texts.map((text) => Object.assign(document.createElement(kind), { textContent: text })));
    return made;
  }

  function show(outcome) {
    const { scene, mine } = outcome;
    const { all } = page.run.lit;
    const plan = play.planOf("effects", scene, all);
    find("plan-rows").replaceChildren(...plan.effects.map(({ name, reason, isOn, passes }) => {
      const made = row("td", [name, reason || (isOn ? "nothing: it runs because you ask" : "nothing"), isOn ? passes.join(", ") : "none"]);
      made.className = isOn ? "" : "off";
      return made;
    }));
    if (page.run.choices.view !== "effects") {
      find("plan-said").textContent = "Choose the view effects, and the plan is carried out.";
      return;
    }
    const key = JSON.stringify([page.run.choices, page.run.edits, page.run.lit.lamps, page.run.lit.mirrors, page.run.lit.gloss]);
    let sentence = `${plan.passes.length} passes, run in ${mine.waves + 1} waves of rays: ${plan.passes.map(({ name }) => name).join(", ")}.`;
    if (before?.key === key && before.all !== all) {
      const [a, b] = [before.linear, mine.linear].map(({ buffer }) => new Uint32Array(buffer));
      let differing = 0;
      for (let i = 0; i < a.length; i += 4) differing += a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2] ? 1 : 0;
      sentence += ` With all passes and with those that are called for, ${differing.toLocaleString("en")} of ${outcome.rays.toLocaleString("en")} pixels differ.`;
    }
    before = { key, linear: mine.linear, all };
    find("plan-said").textContent = sentence;
  }

  for (const name of ["lamps", "mirrors", "gloss", "all"]) {
    find(`plan-${name}`).addEventListener("change", ({ target }) => {
      page.run.lit[name] = target.checked;
      page.go();
    });
  }
  let last = null;
  document.addEventListener("ran", ({ detail }) => {
    if (detail.kind !== "picture") return;
    last = detail;
    if (panel.open) show(detail);
  });
  panel.addEventListener("toggle", () => {
    if (panel.open && last) show(last);
  });
});
