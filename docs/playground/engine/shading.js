// Light as a wavefront of passes: what common/render/whitted_renderer.cpp and common/render/effects do, with the passes of a plan.
//
//   await play.shade(gpu, scene, rays, result, {walk, triangle, edits, plan, signal})   result: the camera's trace; plan: engine/plan.js
//       {linear, waves, stopped}      four numbers a pixel, bottom row first; how often rays went on; stopped as in tracer.js
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const mostBounces = 8;
  const rowsOfTrial = 2;

  async function shade(gpu, scene, rays, result, { walk, triangle, plan, edits = {}, signal = null }) {
    const { width, height } = rays;
    const owned = [];
    const texture = () => {
      owned.push(gpu.texture("rgba32f", width, height));
      return owned.at(-1);
    };
    const surfaces = { ...scene.arrays, background: scene.background };
    const tried = new Set();

    // A pass of these values. A reader's loop without an end is found in a few rows before it fills the picture.
    function ready({ name, file, parts }, values) {
      if (signal?.aborted) throw new play.Stopped("Stopped.");
      const made = gpu.program(file, parts, edits);
      const hasLoop = made.files.some((each) => edits[each] !== undefined && /\b(for|while)\b/.test(edits[each]));
      if (hasLoop && !tried.has(name)) {
        tried.add(name);
        const middle = Math.floor(height / 2);
        const place = gpu.lineThatRanOut(made, values, width, height, [middle, middle + rowsOfTrial]);
        if (place) throw Object.assign(new play.Stopped("Stopped."), { place, name });
      }
      return made;
    }
    const run = (pass, values, targets, options) => gpu.draw(ready(pass, values), values, targets, options);
    const named = (name) => plan.passes.find((pass) => pass.name === name);
    const retire = (name, values) => gpu.retire(live, ready(named(name), values), values);
    const anyLeft = () => gpu.any(ready(named("select_all"), {}), {}, live);

    const color = texture();
    const live = gpu.mask(width, height);
    const made = [];
    let waves = 0;
    async function trace(from, nearEnough) {
      const found = await play.trace(gpu, scene, from, { walk, triangle, edits, live, nearEnough, signal, trial: false });
      made.push(found);
      waves += 1;
      return found.hits;
    }

    // Of all lights, each after its shadow rays.
    async function addLights(values) {
      const shadow = { origins: texture(), directions: texture(), width, height };
      for (const light of scene.lights) {
        const lamp = { ...values, light_position: light.position, light_color: light.color };
        if (plan.cast) {
          gpu.clear(shadow.origins, [0, 0, 0, 0]);
          gpu.clear(shadow.directions, [0, 0, 0, -1]); // so that pixels without a path have no ray
          run(plan.cast, lamp, [shadow.origins, shadow.directions], { live });
          const asked = { ray_origins: shadow.origins, ray_directions: shadow.directions };
          if (plan.facing && !await gpu.any(ready(plan.facing, asked), asked, live)) continue;
          lamp.shadow_hits = await trace(shadow, play.farthest);
        }
        for (const pass of plan.lamps) run(pass, lamp, [color], { live, blend: "add" });
        await gpu.finished();
      }
    }

    try {
      let paths = { origins: rays.origins, directions: rays.directions, weights: texture(), width, height };
      let next = { origins: texture(), directions: texture(), weights: texture(), width, height };
      let { hits } = result;
      gpu.clear(color, [0, 0, 0, 0]);
      run(named("start_weights"), {}, [paths.weights]);
      for (let bounce = 0; ; ++bounce) {
        const values = { ...surfaces, ray_origins: paths.origins, ray_directions: paths.directions, hits, weights: paths.weights };
        run(named("add_surroundings"), values, [color], { live, blend: "add" });
        retire("select_misses", values);
        if (plan.lamps.length) await addLights(values);
        if (!plan.reflect || bounce === mostBounces) break;
        retire("select_unmirrored", values);
        if (!await anyLeft()) break;
        run(plan.reflect, values, [next.origins, next.directions, next.weights], { live });
        const last = paths;
        paths = next;
        next = bounce === 0 ? { origins: texture(), directions: texture(), weights: last.weights, width, height } : last;
        if (plan.faintest !== null) {
          retire("select_faint", { weights: paths.weights, faintest: plan.faintest });
          if (!await anyLeft()) break;
        }
        hits = await trace(paths, -play.farthest);
      }
      return { linear: gpu.readFloats(color), waves, stopped: null };
    } catch (error) {
      if (!error.place) throw error;
      const { file, line } = error.place;
      const sentence = `A loop without an end was stopped in the pass ${error.name}: its rounds ran out at ${file}:${line}. Look at that loop, and at those around it.`;
      return { linear: gpu.readFloats(color), waves, stopped: { pixels: 0, x: 0, y: Math.floor(height / 2), file, line, sentence } };
    } finally {
      gpu.free(...owned);
      made.forEach((one) => play.release(gpu, one));
      gpu.gl.deleteRenderbuffer(live.id);
    }
  }

  Object.assign(play, { shade });
})();
