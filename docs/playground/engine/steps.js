// The steps of one ray's walk, as the text of its walk makes them. Two draws tell all of them: in one, each pixel walks a round
// further than the pixel before, which gives the hit so far; in the other each pixel keeps another event of the walk.
//
//   play.recordSteps(gpu, scene, {walk, triangle, size, pixel, edits})      a walk in packets is stepped as that of its rays
//       {ray, steps, rounds, ended, stopped, hit}; throws CompileError
//       ray: {origin, direction, t_min, t_max}
//       steps: [{place, round, file, line, tested: [triangle], nearest, box: [lower, upper] or null}]
//         place: a cell or node, or the triangle in a loop without a structure; round: in which the step began, from 1
//         file, line: of the text that told of it; nearest: {t, u, v, triangle, words} of all triangles so far, or null
//       ended: false where there were more steps than are recorded; stopped: 0, or the round in which a loop had no end
//   play.partingOf(mine, right)       the first step that is not the same in both, from 0; -1 where all are
//   play.placeName(scene, walk)       "cell", "node" or "triangle"
//   play.boxOf(scene, walk, place)    [lower, upper], or null
//   play.recordedSteps(recorded, {name, scene, of, walk})   of: the scene of that name; as a file of recorded steps has them (visualizer/walk.schema.json)
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const width = 64; // observe_steps.glsl
  const height = 32;
  const most = width * height;
  const observer = "observe_steps.glsl";

  function hitOf(words) {
    const [t, u, v] = new Float32Array(Uint32Array.from(words).buffer);
    return (words[3] | 0) < 0 ? null : { t, u, v, triangle: words[3] | 0, words: [...words] };
  }

  function readRay(gpu, rays, x, y) {
    const texel = 4 * (y * rays.width + x);
    const [origin, direction] = [rays.origins, rays.directions].map((texture) => [...gpu.readFloats(texture).subarray(texel, texel + 4)]);
    return { origin: origin.slice(0, 3), direction: direction.slice(0, 3), t_min: origin[3], t_max: direction[3] };
  }

  function recordSteps(gpu, scene, { walk, triangle, size, pixel, edits = {} }) {
    const parts = { ...play.walkParts({ walk, triangle }), observer };
    delete parts.packet;
    const made = gpu.program("steps.frag", parts, edits);
    const rays = play.cameraRays(gpu, scene, size, edits);
    const targets = [0, 1, 2].map(() => gpu.texture("rgba32ui", width, height));
    const fromBelow = [pixel[0], size - 1 - pixel[1]];
    function draw(rounds) {
      gpu.draw(made, {
        ...play.structureUniforms(scene, walk), ray_origins: rays.origins, ray_directions: rays.directions, ray_pixel: fromBelow,
        near_enough: -play.farthest, rounds,
      }, targets, { clear: [[0, 0, 0, play.stoppedMark], [0, 0, 0, 1], [0, 0, 0, 0]] });
      return targets.map((target) => gpu.readIntegers(target));
    }
    try {
      const ray = readRay(gpu, rays, ...fromBelow);
      const [hits, places, seen] = draw(-1);
      const wordsAt = (round) => hits.subarray(4 * round, 4 * round + 4);
      const isStopped = (round) => hits[4 * round + 3] === play.stoppedMark;
      let last = 0;
      while (last < most - 1 && places[4 * last + 3] === 0) last += 1;
      const stopped = isStopped(last) ? last : 0;
      const rounds = stopped ? stopped - 1 : last;
      const events = draw(rounds)[2];
      const happened = Math.min(most, seen[4 * rounds] + seen[4 * rounds + 1]);
      const steps = stepsOf(events, happened, (visits, tests, from) => {
        let round = from;
        while (round < rounds && (seen[4 * round] < visits || seen[4 * round + 1] < tests)) round += 1;
        return round;
      }, wordsAt, made.files);
      for (const step of steps) step.box = boxOf(scene, walk, step.place);
      return { ray, steps, rounds, ended: !stopped && places[4 * last + 3] === 1 && happened < most, stopped, hit: hitOf(wordsAt(rounds)) };
    } finally {
      gpu.free(rays.origins, rays.directions, ...targets);
    }
  }

  // A step is a visit and the tests that follow it; where nothing is visited, it is a test.
  function stepsOf(events, happened, roundOf, wordsAt, files) {
    const steps = [];
    let visits = 0;
    let tests = 0;
    let round = 0;
    let nearest = null;
    for (let event = 0; event < happened; ++event) {
      const place = events[4 * event + 2] | 0;
      const isTest = events[4 * event + 3] % 2 === 1;
      if (isTest) tests += 1;
      else visits += 1;
      round = roundOf(visits, tests, round);
      if (!isTest || visits === 0) {
        const { file, line } = play.lineOf(Math.floor(events[4 * event + 3] / 2), files);
        steps.push({ place, round: Math.max(1, round), file, line, tested: [], nearest, box: null });
      }
      const step = steps.at(-1);
      if (isTest) {
        nearest = hitOf(wordsAt(round));
        step.tested.push(place);
        step.nearest = nearest;
      }
    }
    return steps;
  }

  const same = (a, b) => String(a) === String(b);

  function partingOf(mine, right) {
    const count = Math.max(mine.steps.length, right.steps.length);
    for (let i = 0; i < count; ++i) {
      const [a, b] = [mine.steps[i], right.steps[i]];
      if (!a || !b || a.place !== b.place || !same(a.tested, b.tested) || !same(a.nearest?.words, b.nearest?.words)) return i;
    }
    return mine.ended === right.ended && mine.stopped === right.stopped && same(mine.hit?.words, right.hit?.words) ? -1 : count;
  }

  function placeName(scene, walk) {
    const { name } = play.familyOf(scene, walk);
    return { grid: "cell", every_triangle: "triangle" }[name] ?? "node";
  }

  const floatsOf = ({ data }) => new Float32Array(data.buffer, data.byteOffset, data.length);

  function hull(points) {
    return points.length ? [0, 1].map((side) => [0, 1, 2].map((axis) => Math[side ? "max" : "min"](...points.map((point) => point[axis])))) : null;
  }

  const boxes = {
    bvh({ arrays }, place) {
      const texels = floatsOf(arrays.bvh_nodes).subarray(8 * place, 8 * place + 8);
      return texels.length < 8 ? null : hull([[...texels.subarray(0, 3)], [...texels.subarray(4, 7)]]);
    },
    // Of a node the box around its children's, of a leaf that around its triangles.
    bvh4({ arrays }, place) {
      const points = [];
      if (place >= 0) {
        const texels = floatsOf(arrays.bvh4_nodes).subarray(4 * (place & ~7), 4 * (place & ~7) + 24);
        for (let child = 0; child < 4 && texels.length === 24; ++child) {
          const [lower, upper] = [0, 4].map((side) => [0, 1, 2].map((axis) => texels[8 * axis + side + child]));
          if (lower.every((plane, axis) => plane <= upper[axis] && Math.abs(plane) < 1e30)) points.push(lower, upper);
        }
      } else if (place < -1) {
        const corners = arrays.bvh_triangles;
        for (let triangle = -2 - place; 3 * triangle < corners.texels; ++triangle) {
          for (let corner = 0; corner < 3; ++corner) points.push([...floatsOf(corners).subarray(12 * triangle + 4 * corner).subarray(0, 3)]);
          if (corners.data[12 * triangle + 7]) break;
        }
      }
      return hull(points);
    },
    half_bvh({ arrays, points }, place) {
      const texel = arrays.half_nodes.data.subarray(4 * place, 4 * place + 4);
      if (texel.length < 4) return null;
      const word = new Int32Array(1);
      const share = (bits) => { word[0] = bits ? (bits << 13) + (112 << 23) : 0; return new Float32Array(word.buffer)[0]; };
      const halves = [texel[0], texel[0] >> 16, texel[1], texel[1] >> 16, texel[2], texel[2] >> 16].map((bits) => share(bits & 0xffff));
      return [0, 3].map((first) => [0, 1, 2].map((axis) => points.half_lower[axis] + points.half_size[axis] * halves[first + axis]));
    },
    grid({ points, counts }, place) {
      const [x, y, z] = counts.grid_cells;
      const cell = [place % x, Math.floor(place / x) % y, Math.floor(place / x / y)];
      if (place >= x * y * z) return null;
      return [0, 1].map((side) => cell.map((i, axis) => points.grid_lower[axis] + points.grid_cell_size[axis] * (i + side)));
    },
    kd({ arrays }, place) {
      const texels = arrays.kd_boxes.data.subarray(8 * place, 8 * place + 8);
      return texels.length < 8 ? null : [[...texels.subarray(0, 3)], [...texels.subarray(4, 7)]];
    },
  };

  function boxOf(scene, walk, place) {
    const family = play.familyOf(scene, walk);
    const find = boxes[family.name];
    return !find || (place < 0 && family.name !== "bvh4") ? null : find(family, place);
  }

  const written = (number) => (Number.isNaN(number) ? "nan" : Number.isFinite(number) ? number : number > 0 ? "infinity" : "-infinity");
  const writtenHit = (hit) => hit && { t: written(hit.t), u: written(hit.u), v: written(hit.v), triangle: hit.triangle };

  function recordedSteps(recorded, { name, scene, of, walk }) {
    const { ray, steps, ended, hit, stopped } = recorded;
    return {
      schema: "walk.schema.json", schema_version: 1, name, scene, structure: walk.replace(/^packet_/, ""),
      ray: { origin: ray.origin.map(written), direction: ray.direction.map(written), t_min: written(ray.t_min), t_max: written(ray.t_max) },
      question: "nearest",
      steps: steps.map(({ place, round, box, tested, nearest, file, line }, i) =>
        ({ place, round, box, tested, nearest: writtenHit(nearest), sentence: `${play.sentenceOfStep(of, walk, recorded, i)}. ${file}:${line}` })),
      ended, hit: writtenHit(hit),
      ending: stopped ? `A loop without an end was stopped in round ${stopped}.` : ended ? "The walk ended by itself." : "More steps were not recorded.",
    };
  }

  Object.assign(play, { recordSteps, partingOf, placeName, boxOf, recordedSteps });
})();
