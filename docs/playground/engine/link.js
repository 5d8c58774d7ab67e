// A link says all that a reader sees: scene, walk, triangle test, view, pixel, step and edited texts. It lies in the hash, so no
// server hears of it. `check` comes first and covers the rest: a link that was cut off does not pass for another one. One that
// is written by hand, without texts, needs no check: #scene=cornell_box&walk=grid
//
//   await play.writeLink(state)       the hash, from # on; throws PlayError where it would be too long
//   await play.readLink(hash, known)  the state; null where there is no link; throws PlayError, with one sentence
//       known: {scene: [name, ...], ...}, what the page has of each choice
//       state: {choices: {scene, walk, triangle, view, size}, file, pixel: [x, y], step, open: [section], edits: {path: text}}
//       what a link does not name is undefined, and edits are {}
//   play.longestLink                  characters
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const longestLink = 30000; // characters: browsers take more, chats and mail programs often do not
  const mostOfTexts = 1024 * 1024; // bytes that the texts of a link may unpack to
  const choiceNames = ["scene", "walk", "triangle", "view", "size"];
  const names = [...choiceNames, "file", "pixel", "step", "open", "text"]; // in the order of a link

  // Fowler, Noll and Vo's hash, 1991, of 32 bits.
  function checkOf(fields) {
    const bytes = new TextEncoder().encode(names.filter((name) => fields.has(name)).map((name) => `${name}=${fields.get(name)}`).join("&"));
    let hash = 2166136261;
    for (const byte of bytes) hash = Math.imul(hash ^ byte, 16777619);
    return (hash >>> 0).toString(16).padStart(8, "0");
  }

  async function pack(text) {
    if (!globalThis.CompressionStream) throw new play.PlayError("This browser cannot pack your text into a link (it has no CompressionStream). A newer one can.");
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    let letters = "";
    for (const byte of bytes) letters += String.fromCharCode(byte);
    return btoa(letters).replace(/\+/g, "-").replace(/\//g, "_").replace(/=/g, "");
  }

  // No more of it than a page has use for, whatever the few bytes of a link unpack to.
  async function unpack(base64) {
    if (!globalThis.DecompressionStream) refuse("this browser has no DecompressionStream, which unpacks its texts");
    try {
      const bytes = Uint8Array.from(atob(base64.replace(/-/g, "+").replace(/_/g, "/")), (letter) => letter.charCodeAt(0));
      const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
      const pieces = [];
      let length = 0;
      for (let piece = await reader.read(); !piece.done; piece = await reader.read()) {
        length += piece.value.length;
        if (length > mostOfTexts) {
          reader.cancel().catch(() => {});
          return null;
        }
        pieces.push(piece.value);
      }
      return JSON.parse(await new Blob(pieces).text());
    } catch {
      return undefined;
    }
  }

  function refuse(why) {
    throw new play.PlayError(`The link could not be read: ${why}. This is the page as it is without one.`);
  }
  const quoted = (text) => `“${text.length > 40 ? `${text.slice(0, 40)}…` : text}”`;

  async function writeLink({ choices, file, pixel, step, open = [], edits = {} }) {
    const fields = new Map(choiceNames.map((name) => [name, String(choices[name])]));
    if (file) fields.set("file", file);
    if (pixel) fields.set("pixel", pixel.join(","));
    if (step !== undefined && step !== null) fields.set("step", String(step));
    if (open.length) fields.set("open", open.join(","));
    if (Object.keys(edits).length) fields.set("text", await pack(JSON.stringify(edits)));
    const readable = (value) => encodeURIComponent(value).replace(/%3A/g, ":").replace(/%2F/g, "/").replace(/%2C/g, ",");
    const link = `#check=${checkOf(fields)}&${[...fields].map(([name, value]) => `${name}=${readable(value)}`).join("&")}`;
    if (link.length > longestLink) {
      throw new play.PlayError(`Your texts make a link of ${link.length.toLocaleString("en")} characters, and programs that pass links on take ${longestLink.toLocaleString("en")} at most: undo what you changed in files that do not matter.`);
    }
    return link;
  }

  async function readLink(hash, known) {
    if (hash.length < 2) return null;
    if (hash.length > longestLink) refuse(`it has ${hash.length.toLocaleString("en")} characters, more than the ${longestLink.toLocaleString("en")} that the page makes`);
    const fields = new Map();
    for (const [name, value] of new URLSearchParams(hash.slice(1))) {
      if (name !== "check" && !names.includes(name)) refuse(`it says ${quoted(name)}, which the page does not know`);
      if (fields.has(name)) refuse(`it says ${name} twice`);
      fields.set(name, value);
    }
    const check = fields.get("check");
    if (check !== undefined ? check !== checkOf(fields) : fields.has("text")) {
      refuse("it was cut off or changed on its way");
    }
    const state = { choices: {}, edits: {} };
    for (const name of choiceNames.filter((one) => fields.has(one))) {
      const value = fields.get(name);
      if (!known[name].map(String).includes(value)) refuse(`it asks for the ${name} ${quoted(value)}, and the page has ${known[name].join(", ")}`);
      state.choices[name] = name === "size" ? Number(value) : value;
    }
    const isFile = (path) => Object.hasOwn(play.files, path) && path.includes("/");
    if (fields.has("file")) {
      if (!isFile(fields.get("file"))) refuse(`there is no file ${quoted(fields.get("file"))}`);
      state.file = fields.get("file");
    }
    if (fields.has("pixel")) {
      const found = /^(\d{1,4}),(\d{1,4})$/.exec(fields.get("pixel"));
      if (!found || Math.max(found[1], found[2]) >= (state.choices.size ?? Math.max(...known.size))) refuse(`${quoted(fields.get("pixel"))} is no pixel of the picture`);
      state.pixel = [Number(found[1]), Number(found[2])];
    }
    if (fields.has("step")) {
      if (!/^\d{1,5}$/.test(fields.get("step"))) refuse(`${quoted(fields.get("step"))} is no step`);
      state.step = Number(fields.get("step"));
    }
    if (fields.has("open")) {
      state.open = fields.get("open").split(",");
      const unknown = state.open.find((section) => !(known.open ?? []).includes(section));
      if (unknown !== undefined) refuse(`there is no section ${quoted(unknown)} to open`);
    }
    if (fields.has("text")) {
      const edits = await unpack(fields.get("text"));
      if (edits === null) refuse("its texts are longer than the page compiles");
      if (typeof edits !== "object" || Array.isArray(edits)) refuse("its texts cannot be unpacked");
      for (const [path, text] of Object.entries(edits)) {
        if (!isFile(path)) refuse(`it changes a file ${quoted(path)}, which there is none of`);
        if (typeof text !== "string" || text.length > play.mostCharacters) refuse(`its text of ${quoted(path)} is none that the page compiles`);
        state.edits[path] = text;
      }
    }
    return state;
  }

  Object.assign(play, { writeLink, readLink, longestLink });
})();
