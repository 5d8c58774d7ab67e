// "Copy link": what the reader sees, as an address.
"use strict";

document.addEventListener("begun", () => {
  const { play } = Raysteps;
  const { page } = play;
  const find = (id) => document.getElementById(id);
  const say = (sentence) => { find("link-said").textContent = sentence; };

  async function copy() {
    let link;
    try {
      const { choices, edits } = page.run;
      const files = page.run.files(); // of these choices: what is edited elsewhere would only make the link longer
      const used = Object.fromEntries(Object.entries(edits).filter(([path]) => files.includes(path)));
      link = location.href.replace(/#.*/, "") + await play.writeLink({
        choices, file: page.file(), pixel: page.looked()?.every((place) => place < choices.size) ? page.looked() : null, step: page.step?.(), edits: used,
        open: [...document.querySelectorAll("main > details[open]")].map(({ id }) => id).filter((id) => id !== "steps" || page.step?.() === undefined),
      });
    } catch (error) {
      if (!(error instanceof play.PlayError)) throw error;
      find("link").hidden = true;
      say(error.message);
      return;
    }
    find("link").hidden = false;
    find("link").value = link;
    find("link").select();
    const where = location.protocol === "file:" ? " It begins with this page's place on your disk: others put what follows # behind the address of theirs." : "";
    const size = `${link.length.toLocaleString("en")} characters.`;
    try {
      await navigator.clipboard.writeText(link);
      say(`The link is in your clipboard, ${size}${where}`);
    } catch {
      say(`Copy the link from the field, ${size}${where}`);
    }
  }

  find("copy-link").addEventListener("click", copy);
  addEventListener("hashchange", () => location.reload());
});
