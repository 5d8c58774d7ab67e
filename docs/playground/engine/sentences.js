// What a step of a walk did, in the words of the visualizer (visualizer/replay/sentence.cpp): "step 7: cell (3,0,5), t 1.25 to 1.31,
// leaves through +x, 2 triangles tested, no hit".
//
//   play.significant(value, digits)   as C's `%.4g` writes a number
//   play.sentenceOfStep(scene, walk, recorded, i)      recorded: of play.recordSteps; i: from 0
//   play.nameOfPlace(scene, walk, step)   "node 12", "cell (3,0,5)", "triangle 4"
//   play.endingOf(recorded)           what the walk came to
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const leafAxis = 3; // structure/kd_tree/kd_nodes.glsl

  function significant(value, digits) {
    if (Number.isNaN(value)) return "nan";
    if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
    if (value === 0) return Object.is(value, -0) ? "-0" : "0";
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e").map((part, i) => (i ? Number(part) : part));
    const trimmed = (number) => (number.includes(".") ? number.replace(/\.?0+$/, "") : number);
    if (exponent >= -4 && exponent < digits) return trimmed(value.toFixed(digits - 1 - exponent));
    return `${trimmed(mantissa)}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  }
  const short = (value) => (value >= 3.4e38 ? "infinity" : significant(value, 4));
  const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

  // The ray's part in a box, and the face by which it leaves: 2 * axis is the lower one.
  function spanOf([lower, upper], { origin, direction, t_min: least, t_max: most }) {
    const span = { entry: least, exit: most, face: -1, isOutside: false };
    for (let axis = 0; axis < 3; ++axis) {
      if (direction[axis] === 0) {
        span.isOutside ||= origin[axis] < lower[axis] || origin[axis] > upper[axis];
        continue;
      }
      const planes = [lower, upper].map((corner) => (corner[axis] - origin[axis]) / direction[axis]);
      span.entry = Math.max(span.entry, Math.min(...planes));
      if (Math.max(...planes) < span.exit) {
        span.exit = Math.max(...planes);
        span.face = 2 * axis + (direction[axis] > 0 ? 1 : 0);
      }
    }
    span.isOutside ||= span.entry > span.exit;
    return span;
  }

  const families = {
    bvh: ({ arrays }, place) => ({ number: arrays.bvh_first_octant.data[place], isLeaf: arrays.bvh_nodes.data[8 * place + 7] >= 0 }),
    kd: ({ arrays }, place) => ({ number: place, isLeaf: (arrays.kd_nodes.data[4 * place] & 3) === leafAxis }),
  };

  function nameOf(scene, walk, { place, box }) {
    const family = play.familyOf(scene, walk);
    if (!box) return { name: family.name === "every_triangle" ? `triangle ${place}` : `place ${place} that the structure does not have` };
    if (family.name === "grid") {
      const [x, y] = family.counts.grid_cells;
      return { name: `cell (${place % x},${Math.floor(place / x) % y},${Math.floor(place / x / y)})`, isLeaf: true };
    }
    const found = families[family.name]?.(family, place);
    return found ? { name: `${found.isLeaf ? "leaf" : "node"} ${found.number}`, isLeaf: found.isLeaf } : { name: `node ${place}` };
  }

  function hitText({ tested, nearest }, before, exit) {
    if (nearest && nearest.triangle !== before?.triangle && tested.includes(nearest.triangle)) {
      return `hit triangle ${nearest.triangle} at t ${short(nearest.t)}${nearest.t > exit ? ", beyond the box: not final" : ""}`;
    }
    return "no nearer hit";
  }

  function bodyOf(scene, walk, recorded, i, isLeaf) {
    const { steps, ray } = recorded;
    const step = steps[i];
    const before = steps[i - 1]?.nearest ?? null;
    if (!step.box) return hitText(step, before, Infinity);
    const { entry, exit, face, isOutside } = spanOf(step.box, ray);
    const { name } = play.familyOf(scene, walk);
    const interval = `t ${short(entry)} to ${short(exit)}`;
    const leaves = name === "grid" || name === "kd" ? face >= 0 ? `, leaves through ${"-+"[face % 2]}${"xyz"[face >> 1]}` : "" : "";
    if (step.tested.length) return `${interval}${leaves}, ${counted(step.tested.length, "triangle")} tested, ${hitText(step, before, exit)}`;
    if (isOutside && name !== "grid" && name !== "kd") return "box missed, left out";
    if (before && entry > before.t) return `box begins at t ${short(entry)}, behind the hit at t ${short(before.t)}, left out`;
    return isLeaf ? `${interval}${leaves}, no triangle tested` : `${interval}, box met`;
  }

  function sentenceOfStep(scene, walk, recorded, i) {
    const { steps } = recorded;
    const { name, isLeaf } = nameOf(scene, walk, steps[i]);
    const sentence = `step ${i + 1}: ${name}, ${bodyOf(scene, walk, recorded, i, isLeaf)}`;
    if (i + 1 === steps.length) return `${sentence}; the end, ${endingOf(recorded)}`;
    return steps[i + 1].box ? `${sentence}, on to ${nameOf(scene, walk, steps[i + 1]).name}` : sentence;
  }

  function endingOf({ steps, ended, stopped, hit }) {
    const found = hit ? `triangle ${hit.triangle} at t ${short(hit.t)}` : "no hit";
    if (stopped) return `a loop without an end was stopped in round ${stopped}`;
    if (!steps.length) return "the ray passes by, and nothing is visited";
    return ended ? `the walk ends with ${found}` : `the walk was not recorded to its end: ${found}`;
  }

  const nameOfPlace = (scene, walk, step) => nameOf(scene, walk, step).name;

  Object.assign(play, { significant, nameOfPlace, sentenceOfStep, endingOf });
})();
