// Light, hard shadows and mirrors as a wavefront of passes: what common/render/whitted_renderer.cpp does. And what of it a scene calls
// for, as chapter 09 has it.
//
//   play.shadingPlan(scene, all)      {effects: [{name, reason, isOn, passes: [name]}], passes: [name]}; reason: "" where nothing calls for it
//       all: run the passes of every effect, called for or not
//   play.changedScene(scene, {lamps, mirrors})   the scene without its lamps, or with matte mirrors; itself where both are true
//   await play.shade(gpu, scene, rays, result, {walk, triangle, edits, plan, signal})   result: the camera's trace
//       {linear, waves, stopped}      four numbers a pixel, bottom row first; how often rays went on; stopped as in tracer.js
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const mostBounces = 8;
  const texelsOfMaterial = 3; // light/materials.glsl
  const rowsOfTrial = 2;
  const effectNames = ["diffuse", "shadows", "mirrors"];
  const passesOf = {
    diffuse: ["add_light"], shadows: ["cast_shadow_rays"], mirrors: ["select_unmirrored", "reflect"],
  };
  const always = ["start_weights", "add_surroundings", "select_misses"];
  const changed = new WeakMap();

  const counted = (count, what) => `${count.toLocaleString("en")} ${what}${count === 1 ? "" : "s"}`;

  // What the materials that have it are, in words; "" where no triangle has such a material.
  function reasonOf({ arrays }, has) {
    const { data } = arrays.materials;
    const which = new Set(Array.from({ length: arrays.materials.texels / texelsOfMaterial }, (_, i) => i)
      .filter((i) => has(data.subarray(4 * texelsOfMaterial * i, 4 * texelsOfMaterial * (i + 1)))));
    const triangles = arrays.triangle_materials.data.reduce((sum, material) => sum + which.has(material), 0);
    const used = new Set(arrays.triangle_materials.data.filter((material) => which.has(material)));
    return triangles ? `${counted(used.size, "material")}, ${counted(triangles, "triangle")}` : "";
  }

  function shadingPlan(scene, all = false) {
    const lights = scene.lights.filter(({ color }) => color.some((part) => part !== 0)).length;
    const lit = reasonOf(scene, (material) => material[0] !== 0 || material[1] !== 0 || material[2] !== 0);
    const diffuse = lights && lit ? `${lit}; ${counted(lights, "light")}` : "";
    const reasons = {
      diffuse,
      shadows: diffuse && scene.triangles > 1 ? `${counted(lights, "light")}, ${counted(scene.triangles, "triangle")} that may stand before ${lights === 1 ? "it" : "them"}` : "",
      mirrors: reasonOf(scene, (material) => material[7] > 0 && Math.max(material[4], material[5], material[6]) > 0),
    };
    const effects = effectNames.map((name) => ({ name, reason: reasons[name], isOn: all || reasons[name] !== "", passes: passesOf[name] }));
    return { effects, passes: [...always, ...effects.flatMap(({ isOn, passes }) => (isOn ? passes : []))] };
  }

  function changedScene(scene, { lamps, mirrors }) {
    if (lamps && mirrors) return scene;
    if (!changed.has(scene)) changed.set(scene, new Map());
    const kept = changed.get(scene);
    const key = `${lamps} ${mirrors}`;
    if (!kept.has(key)) {
      const { materials } = scene.arrays;
      const data = materials.data.slice();
      for (let i = 7; !mirrors && i < data.length; i += 4 * texelsOfMaterial) data[i] = 0;
      kept.set(key, { ...scene, lights: lamps ? scene.lights : [], arrays: { ...scene.arrays, materials: { ...materials, data } } });
    }
    return kept.get(key);
  }

  async function shade(gpu, scene, rays, result, { walk, triangle, edits = {}, plan = shadingPlan(scene), signal = null }) {
    const { width, height } = rays;
    const isOn = Object.fromEntries(plan.effects.map((effect) => [effect.name, effect.isOn]));
    const owned = [];
    const texture = () => {
      owned.push(gpu.texture("rgba32f", width, height));
      return owned.at(-1);
    };
    const surfaces = Object.fromEntries(["triangle_corners", "triangle_normals", "triangle_materials", "materials"].map((name) => [name, scene.arrays[name]]));
    const tried = new Set();

    // A pass of these values. A reader's loop without an end is found in a few rows before it fills the picture.
    function ready(folder, name, values) {
      if (signal?.aborted) throw new play.Stopped("Stopped.");
      const made = gpu.program(`pass/${folder}/${name}.frag`, { real: "real/float.glsl" }, edits);
      const hasLoop = made.files.some((file) => edits[file] !== undefined && /\b(for|while)\b/.test(edits[file]));
      if (hasLoop && !tried.has(name)) {
        tried.add(name);
        const middle = Math.floor(height / 2);
        const place = gpu.lineThatRanOut(made, values, width, height, [middle, middle + rowsOfTrial]);
        if (place) throw Object.assign(new play.Stopped("Stopped."), { place, name });
      }
      return made;
    }
    const run = (name, values, targets, options) => gpu.draw(ready("light", name, values), values, targets, options);
    const retire = (name, values) => gpu.retire(live, ready("select", name, values), values);

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
    async function addLights(paths, values) {
      const shadow = { origins: texture(), directions: texture(), width, height };
      const nothing = gpu.texture("rgba32ui", width, height, { layers: 1 });
      made.push({ hits: nothing, observations: null });
      gpu.clear(nothing, [0, 0, 0, 0xffffffff]); // no triangle
      for (const light of scene.lights) {
        const lamp = { ...values, light_position: light.position, light_color: light.color };
        gpu.clear(shadow.origins, [0, 0, 0, 0]);
        gpu.clear(shadow.directions, [0, 0, 0, -1]); // so that pixels without a path have no ray
        if (isOn.shadows) run("cast_shadow_rays", lamp, [shadow.origins, shadow.directions], { live });
        const shadowHits = isOn.shadows ? await trace(shadow, play.farthest) : nothing;
        run("add_light", { ...lamp, shadow_hits: shadowHits }, [color], { live, blend: "add" });
        await gpu.finished();
      }
    }

    try {
      let paths = { origins: rays.origins, directions: rays.directions, weights: texture(), width, height };
      let next = { origins: texture(), directions: texture(), weights: texture(), width, height };
      let { hits } = result;
      gpu.clear(color, [0, 0, 0, 0]);
      run("start_weights", {}, [paths.weights]);
      for (let bounce = 0; ; ++bounce) {
        const values = { ...surfaces, ray_origins: paths.origins, ray_directions: paths.directions, hits, weights: paths.weights, background: scene.background };
        run("add_surroundings", values, [color], { live, blend: "add" });
        retire("select_misses", values);
        if (isOn.diffuse) await addLights(paths, values);
        if (!isOn.mirrors || bounce === mostBounces) break;
        retire("select_unmirrored", values);
        if (!await gpu.any(ready("select", "select_all", {}), {}, live)) break;
        run("reflect", values, [next.origins, next.directions, next.weights], { live });
        const last = paths;
        paths = next;
        next = bounce === 0 ? { origins: texture(), directions: texture(), weights: last.weights, width, height } : last;
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

  Object.assign(play, { shadingPlan, changedScene, shade });
})();
