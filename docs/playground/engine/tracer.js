// Rays through a structure, in launches: what common/render/trace_rays.cpp does, for a page that has to stay responsive.
//
//   play.walkNames()                  all walks, and packet_NAME for those in packets of 2 x 2 rays
//   play.walkParts({walk, triangle, observer})   the parts of the slots
//   play.cameraRays(gpu, scene, size)            {origins, directions, width, height} as textures
//   play.listedRays(gpu, numbers)     the same of a list, eight floats a ray as in docs/ray_files.md; its rest is empty rays
//   await play.trace(gpu, scene, rays, options)  one trace:
//     options: {walk, triangle, observer, edits, rounds, nearEnough, live, signal, onProgress, trial}
//       observer: "count" or "none"; edits: {path: text}; rounds: of each launch, adapted to the machine where absent
//       live: a mask, only whose pixels are asked for; signal: of an AbortController, looked at between launches
//       trial: trace a few rays first, so that a text that never ends costs little (true)
//     result: {hits, observations, width, height, launches, milliseconds, stopped}
//       hits: an array texture for `hit_at`; observations: a texture, or null
//       stopped: null, or {pixels, x, y, file, line, sentence}: where walks or loops were stopped; x and y from the top left
//   play.release(gpu, result)         gives its textures back
//   play.readHits(gpu, result)        4 words a ray: the bits of t, u and v, and the triangle. Bottom row first.
//   play.readObservations(gpu, result)   4 words a ray, as the observer's file says
//
// A launch is meant to take at most 50 ms: first its rows, then its rounds are halved or doubled.
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const farthest = 3.4028234663852886e38;
  const mostRounds = 1024; // of a launch; the loops inside a round count too: prelude.glsl
  const roundsOfPackets = 256; // of a launch of packets, whose rounds have loops over rays and boxes
  const leastRounds = 32;
  const tooLong = 50; // milliseconds of a launch
  const short = 20;
  const roundsOfAWalk = 20000; // beside what a walk is known to take: then it is said to have no end
  const trialSize = 32; // pixels each way
  const unfinished = 0xfffffffe; // core/walk.glsl
  const stopped = 0xfffffffd; // the page's own: a pixel that left no mark
  const marks = { hit: [0, 0, 0, stopped], place: [0, 0, 0, 1], seen: [0, 0, 0, 0], unfinished: [0, 0, 0, unfinished] };

  class Stopped extends play.PlayError {}

  function walkNames() {
    return [...play.listParts("structure"), ...play.listParts("packet")].map(({ name }) => name).sort();
  }

  function walkParts({ walk, triangle = "watertight", observer = "none" }) {
    const single = walk.replace(/^packet_/, "");
    const parts = {
      real: "real/float.glsl", triangle: play.findPart("triangle", triangle), structure: play.findPart("structure", single),
      observer: play.findPart("observer", observer), cutout: "cutout/none.glsl",
    };
    if (single !== walk) parts.packet = play.findPart("packet", walk);
    return parts;
  }

  function rayTextures(gpu, width, height) {
    return { origins: gpu.texture("rgba32f", width, height), directions: gpu.texture("rgba32f", width, height), width, height };
  }

  function cameraRays(gpu, scene, size, edits = {}) {
    const rays = rayTextures(gpu, size, size);
    const made = gpu.program("pass/rays/compute_rays.frag", { real: "real/float.glsl" }, edits);
    gpu.draw(made, { ...play.viewUniforms(scene), picture_size: [size, size] }, [rays.origins, rays.directions],
      { clear: [[0, 0, 0, 1], [0, 0, 1, -1]] });
    return rays;
  }

  function listedRays(gpu, numbers) {
    const count = numbers.length / 8;
    const width = Math.min(128, Math.max(1, count));
    const height = Math.max(1, Math.ceil(count / width));
    const origins = new Float32Array(4 * width * height);
    const directions = new Float32Array(4 * width * height);
    for (let ray = 0; ray < width * height; ++ray) {
      const [x, y, z, dx, dy, dz, least, most] = ray < count ? numbers.subarray(8 * ray, 8 * ray + 8) : [0, 0, 0, 0, 0, 1, 0, -1];
      origins.set([x, y, z, least], 4 * ray);
      directions.set([dx, dy, dz, Math.min(most, farthest)], 4 * ray);
    }
    return {
      origins: gpu.texture("rgba32f", width, height, { data: origins }),
      directions: gpu.texture("rgba32f", width, height, { data: directions }), width, height,
    };
  }

  function structureUniforms(scene, walk) {
    const family = play.familyOf(scene, walk);
    return { ...scene.arrays, ...family.arrays, ...family.points, ...family.counts, ...family.numbers };
  }

  const freeWalk = (gpu, state) => state && gpu.free(state.hits, state.places, state.seen);

  async function trace(gpu, scene, rays, options) {
    const { walk, triangle, observer = "none", edits = {}, live = null, signal = null, onProgress = () => {}, trial = true } = options;
    const parts = walkParts({ walk, triangle, observer });
    const { width, height } = rays;
    const begun = performance.now();
    const uniforms = {
      ...structureUniforms(scene, walk), ray_origins: rays.origins, ray_directions: rays.directions,
      near_enough: options.nearEnough ?? -farthest,
    };
    const longest = roundsOfAWalk + play.familyOf(scene, walk).longest_walk;
    const resume = gpu.program("pass/trace/resume.frag", parts, edits);
    const everywhere = live ?? gpu.mask(width, height);
    const isLeft = gpu.program("pass/select/select_unfinished.frag", {});
    let launches = 0;
    let stoppedPackets = null;
    const pace = { rounds: options.rounds ?? 256, rows: height };

    const makeState = () => ({
      hits: gpu.texture("rgba32ui", width, height, { layers: 1 }), places: gpu.texture("rgba32ui", width, height),
      seen: gpu.texture("rgba32ui", width, height),
    });
    const launchUniforms = (last, first, rounds) => ({
      ...uniforms, first_launch: first, rounds, last_hits: last.hits, last_places: last.places, last_observations: last.seen,
    });

    // All rays of these rows, `rounds` further, by as many draws as the pace asks for.
    async function launch(last, next, first, rows) {
      gpu.clear(next.hits, marks.hit);
      gpu.clear(next.places, marks.place);
      gpu.clear(next.seen, marks.seen);
      for (let row = rows[0]; row < rows[1];) {
        if (signal?.aborted) throw new Stopped("Stopped.");
        const end = Math.min(rows[1], row + pace.rows);
        gpu.draw(resume, launchUniforms(last, first, pace.rounds), [next.hits, next.places, next.seen], { live, rows: [row, end] });
        launches += 1;
        const took = await gpu.finished();
        row = end;
        if (took > tooLong) {
          if (pace.rows > 8) pace.rows = Math.ceil(pace.rows / 2);
          else if (!options.rounds) pace.rounds = Math.max(leastRounds, pace.rounds / 2);
        } else if (took < short) {
          if (pace.rows < height) pace.rows *= 2;
          else if (!options.rounds) pace.rounds = Math.min(mostRounds, 2 * pace.rounds);
        }
      }
    }

    // To the end of all walks, or until they must be said to have none. Two sets of textures take turns.
    async function walkOn(start, rows) {
      const states = [makeState(), makeState()];
      let last = start;
      for (let turn = 0, made = 0; ; ++turn) {
        const next = states[turn % 2];
        const rounds = pace.rounds;
        await launch(last, next, turn === 0, rows);
        made += Math.min(rounds, pace.rounds);
        const left = await gpu.any(isLeft, { places: next.places }, everywhere);
        onProgress(made, left);
        if (!left || made > longest) {
          freeWalk(gpu, states[(turn + 1) % 2]);
          return { ...next, left };
        }
        last = next;
      }
    }

    function stoppedIn(state, rows) {
      const words = gpu.readIntegers(state.hits);
      const places = state.left ? gpu.readIntegers(state.places) : null;
      let pixels = 0;
      let at = -1;
      let endless = 0;
      for (let y = height - 1; y >= 0; --y) {
        if (y < rows[0] || y >= rows[1]) continue;
        for (let x = 0; x < width; ++x) {
          const ray = y * width + x;
          const ranOut = words[4 * ray + 3] === stopped;
          const unended = !ranOut && places && places[4 * ray + 3] === 0;
          if (!ranOut && !unended) continue;
          if (live && ranOut) continue; // nothing was asked of this pixel, or it left no mark: not told apart
          endless += unended ? 1 : 0;
          at = at < 0 ? ray : at;
          pixels += 1;
        }
      }
      return pixels === 0 ? null : { pixels, x: at % width, y: height - 1 - Math.floor(at / width), row: Math.floor(at / width), endless: endless === pixels };
    }

    function inWords(found, start) {
      const { pixels, x, y, row, endless } = found;
      const which = `${pixels.toLocaleString("en")} ${pixels === 1 ? "pixel" : "pixels"}, first at (${x}, ${y})`;
      if (endless) {
        const sentence = `Walks without an end were stopped in ${which}: each made ${longest.toLocaleString("en")} rounds. Look at what go_on sets to end the walk.`;
        return { pixels, x, y, file: parts.structure, line: 0, sentence };
      }
      const place = gpu.lineThatRanOut(resume, launchUniforms(start, true, mostRounds), width, height, [row, row + 1]);
      const where = place?.file ? ` The rounds ran out at ${place.file}:${place.line}: look at that loop, and at those around it.` : "";
      const sentence = `A loop without an end was stopped in ${which}.${where}`;
      return { pixels, x, y, file: place?.file ?? null, line: place?.line ?? 0, sentence };
    }

    const begin = { hits: gpu.texture("rgba32ui", width, height, { layers: 1 }), places: gpu.texture("rgba32ui", 1, 1), seen: gpu.texture("rgba32ui", 1, 1) };
    gpu.clear(begin.hits, marks.unfinished);
    let ended = null;
    try {
      const middle = Math.floor(height / 2);
      const bands = trial && height > trialSize ? [[middle, Math.min(height, middle + Math.ceil(trialSize * trialSize / width))], [0, height]] : [[0, height]];
      for (const rows of bands) {
        freeWalk(gpu, ended);
        ended = await walkOn(start(rows), rows);
        const found = stoppedIn(ended, rows);
        if (found) {
          const told = inWords(found, begin);
          return result(told);
        }
      }
      return result(stoppedPackets);
    } finally {
      freeWalk(gpu, begin);
      if (!live) gpu.gl.deleteRenderbuffer(everywhere.id);
    }

    // In packets first, where the walk has them: what they leave unfinished goes on ray by ray.
    function start(rows) {
      if (!parts.packet || observer !== "none" || live || rows[1] - rows[0] < height) return begin;
      const quads = gpu.texture("rgba32ui", Math.ceil(width / 2), Math.ceil(height / 2), { layers: 4 });
      const packets = gpu.program("pass/trace/trace_packets.frag", parts, edits);
      const values = { ...uniforms, rounds: roundsOfPackets };
      const isEdited = packets.files.some((file) => edits[file] !== undefined);
      stoppedPackets = isEdited && trial ? packetsThatRanOut(packets, values, quads) : null;
      if (stoppedPackets) {
        gpu.free(quads);
        return begin;
      }
      gpu.draw(packets, values, [quads], { clear: [marks.unfinished] });
      launches += 1;
      gpu.free(begin.hits);
      begin.hits = quads;
      return begin;
    }

    // A few packets of an edited text, to see whether its loops end. Those that only run out of stack are no fault.
    function packetsThatRanOut(packets, values, quads) {
      const middle = Math.floor(quads.height / 2);
      const rows = [middle, Math.min(quads.height, middle + Math.ceil(trialSize * trialSize / 4 / quads.width))];
      gpu.draw(packets, values, [quads], { clear: [marks.unfinished], rows });
      const words = gpu.readIntegers(quads);
      const left = [];
      for (let quad = rows[0] * quads.width; quad < rows[1] * quads.width; ++quad) {
        if (words[4 * quad + 3] === unfinished) left.push(quad);
      }
      const place = left.length ? gpu.lineThatRanOut(packets, values, quads.width, quads.height, rows) : null;
      if (!place) return null;
      const x = 2 * (left[0] % quads.width);
      const y = height - 1 - 2 * Math.floor(left[0] / quads.width);
      const sentence = `A loop without an end was stopped in ${left.length} packets of a trial, the first at (${x}, ${y}). The rounds ran out at ${place.file}:${place.line}: look at that loop, and at those around it. The picture was made without packets.`;
      return { pixels: 4 * left.length, x, y, ...place, sentence };
    }

    function result(told) {
      gpu.free(ended.places);
      const seen = observer === "none" ? null : ended.seen;
      if (!seen) gpu.free(ended.seen);
      return { hits: ended.hits, observations: seen, width, height, launches, milliseconds: performance.now() - begun, stopped: told };
    }
  }

  const release = (gpu, result) => result && gpu.free(result.hits, result.observations);
  const readHits = (gpu, result) => gpu.readIntegers(result.hits);
  const readObservations = (gpu, result) => gpu.readIntegers(result.observations);

  Object.assign(play, {
    Stopped, walkNames, walkParts, cameraRays, listedRays, structureUniforms, trace, release, readHits, readObservations, farthest, stoppedMark: stopped,
  });
})();
