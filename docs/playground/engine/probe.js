// How this GPU rounds: measured, not promised.
//
//   play.probe(gpu)   {rows: [{question, wrong, of, matters}], rounds: true or false, sentence}
//       question: in words; wrong: how many of so many answers are not those of IEEE 754; matters: for hits
//       rounds: whether all that matters is right
//   play.requireWholeNumbers(gpu)     throws PlayError where a struct, as a hit is one, keeps 16 of 32 bits: then nothing would be right
//   play.randomBits(seed)             an endless sequence, the same in each browser
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const size = 64;

  // The generator of Park and Miller, 1988: the same numbers in each browser.
  function* randomBits(seed) {
    for (let state = seed; ;) yield state = state * 48271 % 0x7fffffff;
  }

  function numbers() {
    const texels = new Float32Array(4 * size * size);
    const random = randomBits(19);
    const unit = () => random.next().value / 0x7fffffff;
    for (let i = 0; i < size * size; ++i) {
      for (let j = 0; j < 3; ++j) texels[4 * i + j] = (unit() < 0.5 ? -1 : 1) * (1 + unit()) * 2 ** Math.floor(16 * unit() - 8);
      texels[4 * i + 3] = (i + 1) * 2 ** -149;
    }
    return texels;
  }

  const structs = "Does a struct keep 32 bits?";

  function requireWholeNumbers(gpu) {
    if (probe(gpu).rows.find(({ question }) => question === structs).wrong === 0) return;
    throw new play.PlayError("This GPU keeps only 16 bits of a number in a struct, and hits and places of walks are kept in them: nothing here would be right. The recorded pictures and walks work all the same.");
  }

  function probe(gpu) {
    const given = numbers();
    const source = gpu.texture("rgba32f", size, size, { data: given });
    const targets = [gpu.texture("rgba32ui", size, size), gpu.texture("rgba32ui", size, size)];
    gpu.draw(gpu.program("probe.frag"), { numbers: source }, targets);
    const [basics, others] = targets.map((target) => gpu.readIntegers(target));
    gpu.free(source, ...targets);
    const float = new Float32Array(1);
    const word = new Uint32Array(float.buffer);
    const bitsOf = (value) => { float[0] = value; return word[0]; };
    const same = (bits, value) => bits === bitsOf(value) || (value === 0 && (bits & 0x7fffffff) === 0);

    const questions = [
      ["Is a product rounded once?", (i, a, b) => same(basics[i], a * b), true],
      ["Is a quotient rounded right?", (i, a, b) => same(basics[i + 1], a / b), true],
      ["Is a root rounded right?", (i, a) => same(basics[i + 2], Math.sqrt(Math.abs(a))), false],
      ["Is a product rounded before something is added to it?", (i, a, b, c) => same(basics[i + 3], Math.fround(a * b) + c), true],
      ["Is what a product lost found again (Dekker's sum)?", (i, a, b) => same(others[i], a * b - Math.fround(a * b)), true],
      ["Are numbers under 1.2e-38 kept?", (i, a, b, c, tiny) => same(others[i + 1], tiny), false],
      [structs, (i) => others[i + 2] === 1, true],
      ["Is a NaN known for one?", (i) => others[i + 3] === 1, true],
    ];
    const rows = questions.map(([question, isRight, matters]) => {
      let wrong = 0;
      for (let i = 0; i < given.length; i += 4) wrong += isRight(i, given[i], given[i + 1], given[i + 2], given[i + 3]) ? 0 : 1;
      return { question, wrong, of: size * size, matters };
    });
    const rounds = rows.every(({ wrong, matters }) => !matters || wrong === 0);
    const sentence = rounds ? "This GPU rounds as the lessons do: hits have the bits of the C++ program."
      : `This GPU's last digits differ from the lessons': ${rows.filter(({ wrong, matters }) => matters && wrong).map(({ question }) => question.toLowerCase()).join(" ")} Not always. Answers are held against the project's own lines on this GPU.`;
    return { rows, rounds, sentence };
  }

  Object.assign(play, { randomBits, probe, requireWholeNumbers });
})();
