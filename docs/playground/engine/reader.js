// Reads shaders in a browser: the same slots, catalogue and line numbers as common/gpu/shaders.cpp.
//
//   play.addShaders(name, base64)     keeps them packed: the files of shaders/, and the prelude (data/shaders.js calls it)
//   await play.openShaders()          unpacks them; before that there are none
//   play.files                        all of them, by path from the shader folder
//   play.listParts("triangle")        [{name, file}], sorted by name
//   play.findPart("triangle", "watertight"), play.findPass("resume")      the file; throws where there is none
//   play.listPrograms()               [{pass, parts: {slot: file}}]: each pass with each choice of parts
//   play.readShader(pass, parts, {edits, ending})      {text, files}; edits: {path: the reader's own text}
//   play.filesOf(pass, parts, edits)  the paths of all files that go into that program, in order
//   play.nameFiles(messages, files)   [{file, line, message}]: where a compiler's messages belong; of a line the first, since
//       the others follow from it
//   play.explain(message)             the same in words, where a reader may want them
//   play.needsDouble(text)            WebGL has no numbers of double precision
//   play.refuse(text)                 why a text is not compiled at all, as a sentence; null where it may be
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const linesPerFile = 100000; // line 12 of files[3] is 300012, as in C++
  const deepestInclude = 16; // deeper is a circle
  const mostCharacters = 64 * 1024; // of an edited file
  const mostExpanded = 4 * 1024 * 1024; // characters that macros may make of it
  const versionLine = "#version 410 core";
  const endings = { leaveNoMark: "leave_no_mark.glsl", leaveLine: "leave_line.glsl", leaveNoCorner: "leave_no_corner.glsl" };
  const prelude = "prelude.glsl";
  const files = {};
  let packed = null;

  const roles = {
    structure: ["structure", "go_on"], packet: ["structure", "walk_packet"], triangle: ["triangle", "intersect_triangle"],
    offset: ["offset", "leaving_point"], slab: ["slab", "meets_slabs"],
  };

  // An error that a person can act on.
  class PlayError extends Error {}

  const addShaders = (name, base64) => { packed = base64; };

  async function openShaders() {
    Object.assign(files, JSON.parse(new TextDecoder().decode(await play.unzip(packed))));
  }

  const linesOf = (text) => text.replace(/\n$/, "").split("\n");
  const stem = (file) => file.replace(/^.*\//, "").replace(/\.\w+$/, "");
  const paths = (ending) => Object.keys(files).filter((path) => path.includes("/") && path.endsWith(ending)).sort();

  function fills(file, slot) {
    const role = roles[slot];
    if (!role) return file.startsWith(`${slot}/`);
    return file.startsWith(`${role[0]}/`) && new RegExp(`^\\w+ ${role[1]}\\(`, "m").test(files[file]);
  }

  function listParts(slot) {
    const parts = paths(".glsl").filter((file) => fills(file, slot)).map((file) => ({ name: stem(file), file }));
    return parts.sort((a, b) => (a.name < b.name ? -1 : 1));
  }

  function findPart(slot, name) {
    const parts = listParts(slot);
    const found = parts.find((part) => part.name === name);
    if (!found) throw new PlayError(`There is no part ${name} for <${slot}>. Take one of ${parts.map((part) => part.name).join(", ")}.`);
    return found.file;
  }

  function findPass(name) {
    const found = paths(".frag").find((file) => stem(file) === name);
    if (!found) throw new PlayError(`There is no pass ${name}.frag.`);
    return found;
  }

  function slotsOf(pass) {
    return [...files[pass].matchAll(/^\s*#\s*include\s*<([^>]+)>/gm)].map((found) => found[1]);
  }

  // As in C++: a part for cut-outs is asked nothing but a hit, so one of each other part will do.
  function hasNeedlessCutout(parts) {
    const isOther = (slot, part) => (parts[slot] ?? part) !== part;
    return isOther("cutout", "cutout/none.glsl") &&
      (isOther("triangle", "triangle/watertight.glsl") || isOther("observer", "observer/none.glsl") || isOther("real", "real/float.glsl"));
  }

  function listPrograms() {
    return paths(".frag").flatMap((pass) => {
      let choices = [{ pass, parts: {} }];
      for (const slot of slotsOf(pass)) {
        choices = choices.flatMap((choice) => listParts(slot).map((part) =>
          ({ pass, parts: { ...choice.parts, [slot]: part.file } })));
      }
      return choices.filter(({ parts }) => !hasNeedlessCutout(parts));
    });
  }

  function readShader(pass, parts = {}, { edits = {}, ending = null } = {}) {
    const shader = { text: "", files: [] };
    const head = files[prelude] + files[pass.endsWith(".frag") ? ending ?? endings.leaveNoMark : endings.leaveNoCorner];

    function partFor(slot, place) {
      if (!parts[slot]) throw new PlayError(`${place}: nothing fills the slot <${slot}>. Name a part for it.`);
      return parts[slot];
    }
    function read(file, place, depth) {
      const text = edits[file] ?? files[file];
      if (depth > deepestInclude) throw new PlayError(`${place}: \`${file}\` is included in a circle. Remove one of the includes.`);
      if (text === undefined) throw new PlayError(`${place}: there is no shader file \`${file}\`. Check its name.`);
      const number = shader.files.length;
      shader.files.push(file);
      const sayLine = (line) => { shader.text += `#line ${number * linesPerFile + line}\n`; };
      if (depth > 0) sayLine(1);
      linesOf(text).forEach((line, index) => {
        const found = /^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)/.exec(line);
        if (found) {
          const here = `${file}:${index + 1}`;
          read(found[1] ?? partFor(found[2], here), here, depth + 1);
          sayLine(index + 2);
        } else if (depth === 0 && line.trim() === versionLine) {
          shader.text += head;
          sayLine(index + 2);
        } else {
          shader.text += `${line}\n`;
        }
      });
    }
    read(pass, pass, 0);
    return shader;
  }

  const filesOf = (pass, parts, edits = {}) => readShader(pass, parts, { edits }).files;

  // ANGLE, the translator of Chromium, Firefox and Safari, writes `ERROR: 0:300012: ...`.
  function nameFiles(messages, shaderFiles) {
    return messages.replace(/\0/g, "").split("\n").filter((line) => line.trim()).map((line) => {
      const found = /^(?:ERROR|WARNING):\s*\d+:(\d{1,9}):\s*(.*)$/.exec(line);
      const place = found ? lineOf(Number(found[1]), shaderFiles) : { file: null, line: 0 };
      return { ...place, message: (found ? found[2] : line).replace(/ \(symbol id \d+\)/g, "") };
    }).filter(({ file, line }, i, all) => !file || all.findIndex((other) => other.file === file && other.line === line) === i);
  }

  function lineOf(global, shaderFiles) {
    return { file: shaderFiles[Math.floor(global / linesPerFile)] ?? null, line: global % linesPerFile };
  }

  const isNumber = "(?:const )?(?:highp |mediump |lowp )?";
  const conversions = "WebGL has no implicit conversion: ";
  const words = [
    [new RegExp(`cannot convert from '${isNumber}u?int' to '${isNumber}(?:float|vec\\d)'`),
      `${conversions}write a whole number among floats as 2.0f.`],
    [new RegExp(`cannot convert from '${isNumber}(?:float|vec\\d)' to '${isNumber}u?int'`),
      `${conversions}say int(...) where a float becomes a whole number.`],
    [new RegExp(`(?:float|vec\\d)' and a right operand of type '${isNumber}u?int|u?int' and a right operand of type '${isNumber}(?:float|vec\\d)`),
      `${conversions}write 2.0f in place of 2 beside a float.`],
    [new RegExp(`u?int' and a right operand of type '${isNumber}u?int`), `${conversions}write 2u beside an unsigned number, and 2 beside a signed one.`],
    [/undeclared identifier/, "This name is not known here. Look for a slip in its spelling, for its declaration further down, or whether your lines have dropped it."],
    [/no matching overloaded function found/, "There is no function of that name for these arguments. If one of them is a whole number, write 2.0f for 2."],
    [/syntax error/, "The text is no GLSL here. Often a semicolon or a bracket is missing in the line above."],
    [/function return is not matching type/, "The function gives something of another type than stands before its name."],
    [/redefinition/, "This name is taken already."],
    [/not all control paths return a value|function does not return a value/, "The function has a way to its end without a return."],
    [/Too many arguments for macro|Unexpected token after macro/i, "The page guards loops: in the head of a `for`, declare one variable only."],
    [/'double'|Illegal use of reserved word/, "WebGL does not have this word of GLSL."],
  ];

  function explain(message) {
    const found = words.find(([pattern]) => pattern.test(message));
    return found ? found[1] : "";
  }

  const needsDouble = (text) => /\bd(?:ouble|vec[234])\b/.test(text.replace(/\/\/.*$/gm, ""));

  // How long a text becomes at most when its own macros are carried out. A macro of a macro multiplies, and so does an
  // argument that is written twice, at each depth of brackets.
  function expandedLength(text) {
    const macros = new Map();
    const joined = text.replace(/\\\n/g, " ");
    for (const found of joined.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\w+)(?:\(([^)]*)\))?[ \t]*(.*)$/gm)) {
      const [, name, parameters = "", body] = found;
      const uses = parameters.split(",").map((parameter) => parameter.trim()).filter(Boolean)
        .map((parameter) => body.match(new RegExp(`\\b${parameter}\\b`, "g"))?.length ?? 0);
      macros.set(name, { body, copies: Math.max(1, ...uses), length: null });
    }
    const lengthOf = (piece) => (piece.match(/\w+|\W/g) ?? []).reduce((sum, token) =>
      Math.min(sum + (macros.has(token) ? lengthOfMacro(macros.get(token)) : token.length), 2 * mostExpanded), 0);
    function lengthOfMacro(macro) {
      if (macro.length === null) {
        macro.length = 1; // a macro is not carried out again inside itself
        macro.length = Math.max(1, lengthOf(macro.body));
      }
      return macro.length;
    }
    const copies = Math.max(1, ...[...macros.values()].map((macro) => macro.copies));
    let depth = 0;
    let deepest = 0;
    for (const letter of copies > 1 ? joined : "") {
      depth = Math.max(0, depth + (letter === "(") - (letter === ")"));
      deepest = Math.max(deepest, depth);
    }
    return lengthOf(joined) * copies ** deepest;
  }

  function refuse(text) {
    if (text.length > mostCharacters) {
      return `This text has ${text.length.toLocaleString("en")} characters, and the page compiles ${mostCharacters.toLocaleString("en")} at most. Shorten it.`;
    }
    if (expandedLength(text) > mostExpanded) {
      return "The macros of this text (#define) make more than 4 million characters of it. Write fewer macros of macros.";
    }
    return null;
  }

  Object.assign(play, {
    PlayError, files, addShaders, openShaders, listParts, findPart, findPass, listPrograms, readShader, filesOf, nameFiles, lineOf, explain,
    needsDouble, refuse, endings, mostCharacters,
  });
})();
