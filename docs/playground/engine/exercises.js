// The exercises of the course: their texts as a workbook has them, and checks against the answers of the C++ program.
// What scripts/course does natively (marks.py, own.py, check.py, compare.py, report.py), in the same words.
//
//   play.exercises                    [{number, title, file, chapter, path, isHunt}] of all in shaders (data/exercises.js calls addExercises)
//   await play.openExercise("6.2")    one of them, with {task, formulas, hints, source, picture, checkpoints, files}
//       picture: choices of a session whose picture goes through the exercise; isHunt: whether a mistake is looked for
//       path: where its file lies when it is compiled: that of a whole walk takes the place of the project's walk
//   play.projectText(file)            the project's file, "shaders/..." or one of the exercises' own, whose solutions are left out
//   play.blank(file, seed)            that file as a workbook begins: stubs in the place of solutions, and what the seed hides
//   play.stubOf(exercise, code, seed) the stub; of a hunt, by the seed that these lines name
//   play.regions(text, name)          {number: {code: [line], stub, first}}; throws PlayError where the marks are broken
//   play.withCode(text, name, {number: [line]})   the file with these lines between the marks of an exercise
//   play.isStub(exercise, text)       whether the exercise's lines are those of the stub, but for spaces
//   play.ownEdits(exercise, text)     {path: text} for a session: the person's file, with the project's lines for all other exercises
//   await play.check(gpu, exercise, text, {signal})   {state, message, right: [name], checkpoint, wrong, lines: [number]}
//       state: "passed", "failed", "not started", "does not compile" or "stopped"; lines: of the text, where the fault lies
//   play.reportOf(exercise, result)   the result in a few lines
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const exercises = [];
  const packed = new Map();
  const opened = new Map();
  const stopped = 0xfffffffd; // four times: a ray that left no mark
  const widest = 1024; // rays in a row
  const usualObserver = "observer_in_order.glsl";
  const firstObserved = 8; // of twelve numbers: scripts/course/compare.py
  const observed = [["visits", "int"], ["tests", "int"], ["order", "int"]];
  const usualNames = { origin: [0, 1, 2], direction: [3, 4, 5], t_min: [6], t_max: [7] };
  const texels = [["origin x", "origin y", "origin z", "t_min"], ["direction x", "direction y", "direction z", "t_max"]];
  const marks = {
    begin: /^(\s*)\/\/# exercise (\d+\.\d+): (.+)$/, stub: /^\s*\/\/# stub: (.*)$/, end: /^\s*\/\/# end\s*$/,
  };

  const texts = {};
  const plants = {}; // by a hunt's number: the mistakes, of which a seed chooses one
  const [hereSeed, hereWitness] = [/^\s*\/\/ seed (\d+)\s*$/, /^\s*\/\/ witness:\s*(pixel\s+)?([-+.\w,\s]*?)(?:,?\s*\bstep\s+(\d+))?\s*$/];
  const pictureOfWitness = [64, 48];

  function addExercises(list, files, hidden) {
    Object.assign(texts, files);
    Object.assign(plants, JSON.parse(atob(hidden)));
    list.forEach(([number, title, file, chapter, path]) => exercises.push({ number, title, file, chapter, path, isHunt: plants[number] !== undefined }));
  }
  const addChapter = (name, base64) => packed.set(name, base64);
  const projectText = (file) => texts[file] ?? play.files[file.replace(/^shaders\//, "")];

  // Lines, and regions of lines, in order.
  function parse(text, name) {
    const parts = [];
    let region = null;
    text.split("\n").forEach((line, index) => {
      const begin = marks.begin.exec(line);
      const stub = marks.stub.exec(line);
      if (begin && region) throw new play.PlayError(`${name}:${index + 1}: an exercise begins before ${region.number} has ended. Put the line \`//# end\` of ${region.number} back.`);
      if (begin) {
        region = { number: begin[2], indent: begin[1], begin: line, first: index + 2, code: [], stub: [] };
      } else if (marks.end.test(line)) {
        if (!region) throw new play.PlayError(`${name}:${index + 1}: \`//# end\` without an exercise. Put the line \`//# exercise ...\` back, or press Reset.`);
        parts.push({ ...region, end: line, last: index + 1 });
        region = null;
      } else if (stub && region) {
        region.stub.push(region.indent + stub[1]);
      } else if (region) {
        region.code.push(line);
      } else {
        parts.push({ line, at: index + 1 });
      }
    });
    if (region) throw new play.PlayError(`${name}: exercise ${region.number} does not end. Put the line \`//# end\` back, or press Reset.`);
    return parts;
  }

  function regions(text, name) {
    const found = {};
    for (const part of parse(text, name)) {
      if (part.line !== undefined) continue;
      if (found[part.number]) throw new play.PlayError(`${name}: exercise ${part.number} is there twice. Remove one.`);
      found[part.number] = part;
    }
    return found;
  }

  function withCode(text, name, codes) {
    return parse(text, name).flatMap((part) => (part.line !== undefined ? [part.line]
      : [part.begin, ...(codes[part.number] ?? part.code), part.end])).join("\n");
  }

  // The lines with the mistake of that seed, under those for seed and witness.
  function planted(number, { code, indent }, seed) {
    const [find, replace] = plants[number][seed % plants[number].length];
    return [`${indent}// seed ${seed}`, `${indent}// witness:`, ...code.join("\n").split(find).join(replace).split("\n")];
  }

  const found = (pattern, code) => code.map((line) => pattern.exec(line)).find((match) => match) ?? null;
  const seedIn = (code) => (found(hereSeed, code) ? Number(found(hereSeed, code)[1]) : null);

  function stubOf({ number, file }, code, seed) {
    const region = regions(projectText(file), file)[number];
    return plants[number] ? planted(number, region, seedIn(code) ?? seed) : region.stub;
  }

  function blank(file, seed) {
    const text = projectText(file);
    const numbers = Object.keys(regions(text, file));
    return withCode(text, file, Object.fromEntries(numbers.map((number) => [number, stubOf({ number, file }, [], seed)])));
  }

  const bare = (lines) => lines.map((line) => line.split(/\s+/).filter(Boolean).join(" ")).filter(Boolean).join("\n");

  function isStub(exercise, text) {
    const { code } = regions(text, exercise.file)[exercise.number];
    return bare(code) === bare(stubOf(exercise, code, 0));
  }

  // The person's file for the compiler, with the project's lines for all other exercises; origins: where each line comes from.
  function compose(exercise, own) {
    const reference = projectText(exercise.file);
    const solutions = regions(reference, exercise.file);
    const theirs = regions(own, exercise.file);
    for (const number of Object.keys(solutions)) {
      if (!theirs[number]) throw new play.PlayError(`${exercise.file}: the marks of exercise ${number} are gone. Put its lines back, or press Reset.`);
    }
    refuseForeignIncludes(exercise, own, reference);
    const lines = [];
    const origins = [];
    for (const part of parse(own, exercise.file)) {
      if (part.line !== undefined) {
        lines.push(part.line);
        origins.push({ own: true, line: part.at });
        continue;
      }
      const isOwn = part.number === exercise.number || !solutions[part.number];
      const source = isOwn ? part : solutions[part.number];
      lines.push(part.begin, ...source.code, part.end);
      for (let i = 0; i <= source.code.length; ++i) origins.push({ own: isOwn, line: source.first - 1 + i });
      origins.push({ own: isOwn, line: source.last });
    }
    return { text: lines.join("\n"), origins };
  }

  function refuseForeignIncludes(exercise, own, reference) {
    const targets = (text) => [...text.matchAll(/^\s*#\s*include\s*(.*?)\s*$/gm)].map((found) => found[1]);
    const foreign = targets(own).find((target) => !targets(reference).includes(target));
    if (foreign !== undefined) throw new play.PlayError(`${exercise.file}: \`#include ${foreign}\` is not in the project's file. Remove it.`);
  }

  const ownEdits = (exercise, text) => ({ [exercise.path]: compose(exercise, text).text });

  async function openChapter(name) {
    if (!packed.has(name)) await play.loadScript(`data/exercises_${name}.js`);
    const buffer = await play.unzip(packed.get(name));
    const length = new DataView(buffer).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
    const bytes = ({ start, bytes: count }) => buffer.slice(4 + length + start, 4 + length + start + count);
    const scenes = new Map();
    const open = (place) => {
      if (!scenes.has(place.start)) scenes.set(place.start, play.unpackScene(bytes(place)));
      return scenes.get(place.start);
    };
    for (const exercise of head.exercises) {
      Object.assign(exercise, { ...exercises.find(({ number }) => number === exercise.number), files: head.files, numbers: head.numbers });
      for (const checkpoint of exercise.checkpoints) {
        checkpoint.openScene = () => open(checkpoint.scene);
        checkpoint.rays = new Uint32Array(bytes(checkpoint.rays));
        checkpoint.answers = checkpoint.answers.map((place) => new Uint32Array(bytes(place)));
      }
    }
    return head.exercises;
  }

  async function openExercise(number) {
    const listed = exercises.find((each) => each.number === number);
    if (!listed) throw new play.PlayError(`${number} is no exercise in a shader. Take one of ${exercises.map((each) => each.number).join(", ")}.`);
    if (!opened.has(listed.chapter)) {
      const coming = openChapter(listed.chapter);
      opened.set(listed.chapter, coming);
      coming.catch(() => opened.delete(listed.chapter));
    }
    return (await opened.get(listed.chapter)).find((each) => each.number === number);
  }

  // Of a ray, which lies column behind column.
  const rayOf = ({ rays, count }, index) => (rays.length ? Array.from({ length: 8 }, (_, i) => rays[i * count + index]) : []);

  function rayTexture(gpu, checkpoint, columns) {
    const { rays, count } = checkpoint;
    const width = Math.min(count, widest);
    const height = Math.ceil(count / width);
    const words = new Uint32Array(4 * width * height);
    for (let i = 0; i < width * height; ++i) {
      columns.forEach((column, k) => { words[4 * i + k] = rays[column * count + Math.min(i, count - 1)]; });
    }
    return gpu.texture("rgba32f", width, height, { data: new Float32Array(words.buffer) });
  }

  // For each step the numbers of each ray, as bits: found(step, index, k).
  async function askCheckpoint(gpu, exercise, checkpoint, edits, signal) {
    const scene = checkpoint.openScene();
    const structure = checkpoint.structure ?? "every_triangle";
    const parts = play.walkParts({ walk: structure, triangle: checkpoint.triangle, observer: "none" });
    const files = { ...exercise.files, ...edits };
    const program = gpu.program(parts.packet ? "packet_checkpoint.frag" : "checkpoint.frag",
      { ...parts, observer: checkpoint.observer ?? usualObserver, checkpoint: checkpoint.subject }, files);
    const rays = [rayTexture(gpu, checkpoint, [0, 1, 2, 6]), rayTexture(gpu, checkpoint, [3, 4, 5, 7])];
    const { width, height } = rays[0];
    const targets = Array.from({ length: checkpoint.words / 4 }, () => gpu.texture("rgba32ui", width, height));
    const zeros = Object.fromEntries(Object.entries(checkpoint.zeros ?? {}).map(([name, count]) =>
      [name, { kind: "int4", texels: count, data: new Int32Array(4 * count) }]));
    const values = {
      ...play.structureUniforms(scene, structure), triangle_count: scene.triangles, ray_origins: rays[0], ray_directions: rays[1],
      ...exercise.numbers, ...checkpoint.numbers, ...checkpoint.points, ...checkpoint.counts, ...zeros,
    };
    const steps = [];
    try {
      for (let step = 1; step <= checkpoint.answers.length; ++step) {
        if (signal?.aborted) throw new play.Stopped("Stopped.");
        gpu.draw(program, { ...values, step_number: step }, targets, { clear: targets.map(() => Array(4).fill(stopped)) });
        const read = targets.map((target) => gpu.readIntegers(target));
        steps.push(read);
        for (let index = 0; index < checkpoint.count; ++index) {
          if ([0, 1, 2, 3].every((k) => read[0][4 * index + k] === stopped)) {
            return { stopped: { index, step, place: gpu.lineThatRanOut(program, { ...values, step_number: step }, width, height, [0, height]) } };
          }
        }
        if (step % 8 === 0) await gpu.nextTask();
      }
    } finally {
      gpu.free(...rays, ...targets);
    }
    return { found: (step, index, k) => steps[step - 1][k >> 2][4 * index + (k & 3)] };
  }

  function askRays(gpu, checkpoint, edits) {
    const { width = 64, height = 48 } = checkpoint;
    const interpolated = checkpoint.subject === "interpolated";
    const program = gpu.program(`pass/rays/${interpolated ? "interpolate" : "compute"}_rays.frag`, { real: "real/float.glsl" }, edits);
    const targets = [0, 1].map(() => gpu.texture("rgba32f", width, height));
    gpu.draw(program, { ...play.viewUniforms(checkpoint), picture_size: [width, height] }, targets,
      { clear: [[NaN, 0, 0, 0], [NaN, 0, 0, 0]], shape: interpolated ? "rectangle" : "triangle" });
    const steps = targets.map((target) => new Uint32Array(gpu.readFloats(target).buffer));
    gpu.free(...targets);
    const isUnmarked = (words, index) => Number.isNaN(fromBits(words[4 * index])) && [1, 2, 3].every((k) => words[4 * index + k] === 0);
    for (let index = 0; index < width * height; ++index) {
      if (!steps.every((words) => isUnmarked(words, index))) continue;
      const values = { ...play.viewUniforms(checkpoint), picture_size: [width, height] };
      return { stopped: { index, step: 1, place: interpolated ? null : gpu.lineThatRanOut(program, values, width, height, [0, height]) } };
    }
    return { found: (step, index, k) => steps[step - 1][4 * index + k] };
  }

  const word = new Uint32Array(1);
  const float = new Float32Array(word.buffer);
  const fromBits = (bits) => { word[0] = bits; return float[0]; };
  const isFloat = (kind) => kind === "float" || kind === "exact";
  const valueOf = (bits, kind) => (isFloat(kind) ? fromBits(bits) : kind === "bool" ? bits !== 0 : bits | 0);

  function isRight(expected, got, kind, tolerance) {
    if (!isFloat(kind)) return expected === got;
    if (Number.isNaN(expected) || Number.isNaN(got)) return Number.isNaN(expected) && Number.isNaN(got);
    if (kind === "exact" || !Number.isFinite(expected) || !Number.isFinite(got)) return expected === got;
    return Math.abs(expected - got) <= tolerance * Math.max(1, Math.abs(expected), Math.abs(got));
  }

  // `places` says which of the numbers each value is.
  function judged(checkpoint, names, places, expected, found) {
    return names.map(([name, kind], i) => {
      const [a, b] = [expected(places[i], kind, i), valueOf(found(places[i]), kind)];
      return { name, expected: a, got: b, right: isRight(a, b, kind, checkpoint.tolerance) };
    });
  }
  const allRight = (values) => values.every(({ right }) => right);

  function firstUnknown(checkpoint, answer, apart) {
    const places = checkpoint.values.map((_, i) => i);
    for (const { step, index, expected, because } of checkpoint.known) {
      if (apart.has(index)) continue;
      const values = judged(checkpoint, checkpoint.values, places,
        (_, kind, i) => (isFloat(kind) ? fromBits(expected[i]) : expected[i]), (k) => answer.found(step, index, k));
      if (!allRight(values)) return { index, step, ray: rayOf(checkpoint, index), values, because };
    }
    return null;
  }

  function* wrongAnswers(checkpoint, answer) {
    const seen = checkpoint.kind === "checkpoint" && checkpoint.observed && checkpoint.words > firstObserved ? observed : [];
    const names = [...checkpoint.values, ...seen];
    const places = names.map((_, i) => (i < checkpoint.values.length ? i : firstObserved + i - checkpoint.values.length));
    for (let step = 1; step <= checkpoint.answers.length; ++step) {
      for (let index = 0; index < checkpoint.count; ++index) {
        const values = judged(checkpoint, names, places,
          (k, kind) => valueOf(checkpoint.answers[step - 1][k * checkpoint.count + index], kind), (k) => answer.found(step, index, k));
        if (!allRight(values)) {
          const shown = values.filter(({ right }, i) => i < checkpoint.values.length || !right);
          yield { index, step, ray: rayOf(checkpoint, index), values: shown, because: "" };
        }
      }
    }
  }

  function firstWrong(checkpoint, answer, apart) {
    for (const wrong of wrongAnswers(checkpoint, answer)) {
      if (!apart.has(wrong.index)) return wrong;
    }
    return null;
  }

  const ask = (gpu, exercise, checkpoint, edits, signal) => (checkpoint.kind === "rays" ? askRays(gpu, checkpoint, edits)
    : askCheckpoint(gpu, exercise, checkpoint, edits, signal));

  // The rays to which the project's own lines answer otherwise on this GPU than in C++, since GLSL leaves it free what comes of a NaN
  // and of numbers beyond the greatest: nobody's lines are judged by these.
  async function raysApart(gpu, exercise, checkpoint, signal) {
    if (!checkpoint.apart) {
      const own = await ask(gpu, exercise, checkpoint, {}, signal);
      checkpoint.apart = new Set(own.stopped ? [] : [...wrongAnswers(checkpoint, own)].map(({ index }) => index));
    }
    return checkpoint.apart;
  }

  function compileFault(result, exercise, composed, errors) {
    result.state = "does not compile";
    const named = errors.map(({ file, line, message, words }) => {
      const origin = file === exercise.path ? composed.origins[line - 1] : null;
      if (origin?.own) result.lines.push(origin.line);
      const place = origin ? `${exercise.file}:${origin.line}` : file ? `${file}${line ? `:${line}` : ""}` : "the text";
      return `${place}: ${message}${words ? `. ${words}` : ""}`;
    });
    result.message = ["Fix the line that is named, or the one before it:", ...named].join("\n");
    return result;
  }

  // The first loop of the exercise's own lines: the rounds may run out in a function that it calls.
  function loopAmong(exercise, { text, origins }) {
    const { code, first } = regions(text, exercise.file)[exercise.number];
    const found = code.findIndex((line) => /\b(for|while)\b/.test(line));
    return found < 0 ? 0 : origins[first + found - 1].line;
  }

  function endless(result, exercise, composed, checkpoint, { step, place }) {
    const origin = place?.file === exercise.path ? composed.origins[place.line - 1] : null;
    if (origin?.own) result.lines.push(origin.line);
    const where = origin ? `${exercise.file}:${origin.line}` : place ? `${place.file}:${place.line}` : "";
    result.state = "stopped";
    const own = origin?.own ? 0 : loopAmong(exercise, composed);
    const around = own ? `and at that of your lines, ${exercise.file}:${own}` : "and at those around it";
    if (own) result.lines.push(own);
    result.message = where ? `At the checkpoint \`${checkpoint.name}\`, step ${step}, a loop came to no end: its rounds ran out at ${where}. Look at that loop, ${around}.`
      : `At the checkpoint \`${checkpoint.name}\`, step ${step}, a ray was left without an answer: does a loop never end?`;
    return result;
  }

  // Checkpoint after checkpoint, up to the first that is wrong.
  async function judge(gpu, exercise, text, { signal } = {}) {
    const result = { state: "passed", message: "", right: [], checkpoint: null, wrong: null, lines: [] };
    const composed = compose(exercise, text);
    const edits = { [exercise.path]: composed.text };
    for (const checkpoint of exercise.checkpoints) {
      let answer;
      try {
        answer = await ask(gpu, exercise, checkpoint, edits, signal);
      } catch (error) {
        if (error instanceof play.CompileError) return compileFault(result, exercise, composed, error.errors);
        throw error;
      }
      if (answer.stopped) return endless(result, exercise, composed, checkpoint, answer.stopped);
      let wrong = firstUnknown(checkpoint, answer, new Set()) ?? firstWrong(checkpoint, answer, new Set());
      if (wrong) {
        const apart = await raysApart(gpu, exercise, checkpoint, signal);
        wrong = firstUnknown(checkpoint, answer, apart) ?? firstWrong(checkpoint, answer, apart);
        if (!wrong) {
          result.message += `${result.message ? "\n" : ""}${apart.size} of ${checkpoint.count} rays of \`${checkpoint.name}\` were left out: to them this GPU answers the project's own lines otherwise than C++ does.`;
        }
      }
      if (wrong) return Object.assign(result, { state: "failed", checkpoint, wrong });
      result.right.push(checkpoint.name);
    }
    return result;
  }

  // As Python reads numbers.
  function numberOf(word) {
    const text = word.trim().toLowerCase();
    const special = { nan: NaN, inf: Infinity, infinity: Infinity, "+inf": Infinity, "-inf": -Infinity }[text];
    if (special !== undefined) return special;
    if (text === "" || Number.isNaN(Number(text))) throw new play.PlayError(`the line \`// witness:\` cannot be read: \`${word.trim()}\` is no number. Write six numbers, or eight, with commas between them.`);
    return Number(text);
  }

  function rayOfPixel(gpu, scene, [x, y]) {
    const [width, height] = pictureOfWitness;
    const program = gpu.program("pass/rays/compute_rays.frag", { real: "real/float.glsl" });
    const targets = [0, 1].map(() => gpu.texture("rgba32f", width, height));
    gpu.draw(program, { ...play.viewUniforms(scene), picture_size: [width, height] }, targets);
    const texel = 4 * ((height - 1 - y) * width + x);
    const [[ox, oy, oz, least], [dx, dy, dz, most]] = targets.map((target) => gpu.readFloats(target).subarray(texel, texel + 4));
    gpu.free(...targets);
    return [ox, oy, oz, dx, dy, dz, least, most];
  }

  // The ray of the line `// witness:`, as bits, and the step.
  function witnessIn(gpu, exercise, code) {
    const [, pixel, numbers, step] = found(hereWitness, code) ?? [];
    if (numbers === undefined) throw new play.PlayError("the line `// witness:` is gone. Put it back below `//# exercise`.");
    if (!numbers) throw new play.PlayError("the line `// witness:` is empty. Write a ray or a pixel there where the part goes wrong: the task says how.");
    let ray = numbers.split(",").map(numberOf);
    if (pixel) {
      const isInside = ray.length === 2 && ray.every((place, axis) => Number.isInteger(place) && place >= 0 && place < pictureOfWitness[axis]);
      if (!isInside) throw new play.PlayError("the witness names a pixel that is not in a picture of 64 x 48. Write its column and row, as in `pixel 33,11`.");
      ray = rayOfPixel(gpu, exercise.checkpoints[0].openScene(), ray);
    }
    if (ray.length !== 6 && ray.length !== 8) throw new play.PlayError(`a ray has six numbers, or eight with t_min and t_max, and not ${ray.length}.`);
    if (ray.length === 6) ray.push(0, play.farthest);
    return { rays: new Uint32Array(Float32Array.from(ray).buffer), step: Number(step ?? 1) };
  }

  // What is wrong with the witness, in words; empty where it is right. What the project's own lines answer to it, this GPU says.
  async function complaint(gpu, exercise, code, signal) {
    const seed = seedIn(code);
    if (seed === null) return "the line `// seed ...` is gone. Put it back, or press Reset.";
    const [first] = exercise.checkpoints;
    let witness;
    try {
      witness = witnessIn(gpu, exercise, code);
    } catch (error) {
      if (error instanceof play.PlayError && !(error instanceof play.ContextLost)) return error.message;
      throw error;
    }
    const steps = first.answers.length;
    if (witness.step > steps) return `the witness names step ${witness.step}, and there are ${steps}.`;
    const asked = { ...first, rays: witness.rays, count: 1 };
    const text = projectText(exercise.file);
    const mistaken = withCode(text, exercise.file, { [exercise.number]: planted(exercise.number, regions(text, exercise.file)[exercise.number], seed) });
    const [right, wrong] = [await ask(gpu, exercise, asked, {}, signal), await ask(gpu, exercise, asked, { [exercise.path]: mistaken }, signal)];
    if (wrong.stopped) return "the witness could not be tried: a loop came to no end.";
    asked.answers = first.answers.map((_, i) => Uint32Array.from({ length: first.words }, (__, k) => right.found(i + 1, 0, k)));
    const { value } = wrongAnswers(asked, wrong).next();
    if (!value) return "the witness is none: with this ray your part does what it should even before it is repaired. Try another.";
    return value.step === witness.step ? "" : `the witness is near: that goes wrong first at another step than ${witness.step}.`;
  }

  // The witness, then the part. Where the part is wrong is what the person is to find: a check says no ray.
  async function judgeHunt(gpu, exercise, text, options = {}) {
    const message = await complaint(gpu, exercise, regions(text, exercise.file)[exercise.number].code, options.signal);
    if (message) return fault("failed", message);
    const result = await judge(gpu, exercise, text, options);
    if (!result.wrong) return result;
    return Object.assign(result, { message: `The witness is right; the part is wrong still, at ${result.checkpoint.name}.`, checkpoint: null, wrong: null });
  }

  const fault = (state, message) => ({ state, message, right: [], checkpoint: null, wrong: null, lines: [] });

  async function check(gpu, exercise, text, options) {
    try {
      if (isStub(exercise, text)) return fault("not started", "");
      return await (exercise.isHunt ? judgeHunt : judge)(gpu, exercise, text, options);
    } catch (error) {
      if (error instanceof play.PlayError && !(error instanceof play.Stopped) && !(error instanceof play.ContextLost)) return fault("failed", error.message);
      throw error;
    }
  }

  // Nine digits give a number of single precision back, bit for bit; as Python's `.9g` writes them.
  function digits(value) {
    if (typeof value === "boolean") return value ? "yes" : "no";
    return play.significant(value, 9);
  }
  const textOf = (value, kind) => (isFloat(kind) || typeof value === "boolean" ? digits(value) : String(value));
  const row = (name, text) => `  ${name.padEnd(11)} ${text}`;

  function askedRows({ checkpoint, wrong }) {
    if (checkpoint.kind === "rays") {
      const { width = 64, height = 48 } = checkpoint;
      return [row("ray", `of column ${wrong.index % width}, row ${Math.floor(wrong.index / width)} from below, in a picture of ${width} x ${height} pixels of ${checkpoint.scene_name}`)];
    }
    const rows = checkpoint.answers.length > 1 ? [row("step", String(wrong.step))] : [];
    const names = Object.keys(checkpoint.given).length ? checkpoint.given : usualNames;
    for (const [name, places] of Object.entries(names)) {
      const words = places.map((place) => wrong.ray[place]);
      rows.push(row(name, `${words.map((bits) => digits(fromBits(bits))).join(", ")}   (hex ${words.map((bits) => bits.toString(16).padStart(8, "0")).join(" ")})`));
    }
    return rows;
  }

  function wrongRows(result) {
    const { checkpoint, wrong } = result;
    const kinds = Object.fromEntries([...checkpoint.values, ...observed]);
    const rows = [row("checkpoint", `${checkpoint.name}: the first one that is wrong`), ...askedRows(result)];
    if (checkpoint.where) rows.push(row("where", checkpoint.where));
    wrong.values.forEach(({ name, expected, got, right }, i) => {
      const shown = checkpoint.kind === "rays" ? texels[wrong.step - 1][i] : name;
      rows.push(row(shown, `expected ${textOf(expected, kinds[name])}, got ${textOf(got, kinds[name])}${right ? "" : "  <-- wrong"}`));
    });
    if (wrong.because) rows.push(row("known", wrong.because));
    return rows;
  }

  function reportOf(exercise, result) {
    const lines = [`${exercise.number} ${exercise.title}: ${result.state}`];
    if (result.message) lines.push(...result.message.split("\n").map((line) => `  ${line}`));
    if (result.right.length && result.state !== "passed") lines.push(row("right", result.right.join(", ")));
    if (result.wrong) lines.push(...wrongRows(result));
    if (result.wrong && result.checkpoint.kind === "checkpoint") {
      lines.push(row("replay", `./course check ${exercise.number} --ray=${result.wrong.ray.map((bits) => digits(fromBits(bits))).join(",")}`));
    }
    return lines.join("\n");
  }

  Object.assign(play, {
    exercises, addExercises, addChapter, openExercise, projectText, blank, stubOf, regions, withCode, isStub, ownEdits, judge, check, reportOf,
  });
})();
