// Which passes make the light of a picture: all those of chapter 03, or those that a scene calls for, as chapter 09 plans them
// (common/render/effects/called_for.cpp and plan.cpp; of its effects the page has four).
//
//   play.planOf(view, scene, all)     of the views "shaded" and "effects"; null of others. A plan is
//       {effects: [{name, reason, isOn, passes: [name]}], passes: [pass], cast, facing, lamps: [pass], reflect, faintest}
//       effects: none in chapter 03; reason: "" where nothing calls for it; all: run every effect, called for or not
//       pass: {name, file, parts}; cast, facing, reflect: null where nothing of it runs; faintest: of a path that goes on, or null
//   play.passesOf(view)               of all effects, without a scene
//   play.changedScene(scene, {lamps, mirrors, gloss})   the scene without lamps, mirrors or highlights; itself where all are true
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const texelsOfMaterial = 3; // light/materials.glsl
  const faintest = 1 / 512;
  const real = { real: "real/float.glsl" };
  const effectNames = ["diffuse", "highlights", "shadows", "mirrors"];
  const passNamesOf = { diffuse: ["light_surface"], highlights: ["add_highlight"], shadows: ["cast_lamp_rays"], mirrors: ["reflect"] };
  const changed = new WeakMap();

  const pass = (name, parts = {}) => ({ name, file: play.findPass(name), parts: { ...real, ...parts } });
  const counted = (count, what) => `${count.toLocaleString("en")} ${what}${count === 1 ? "" : "s"}`;
  const largest = (data, first) => Math.max(data[first], data[first + 1], data[first + 2]);

  // What the materials that have it are, in words; "" where no triangle has such a material.
  function reasonOf({ arrays }, has) {
    const { data, texels } = arrays.materials;
    const which = new Set(Array.from({ length: texels / texelsOfMaterial }, (_, i) => i).filter((i) => has(data, 4 * texelsOfMaterial * i, i)));
    const owned = arrays.triangle_materials.data.filter((material) => which.has(material));
    return owned.length ? `${counted(new Set(owned).size, "material")}, ${counted(owned.length, "triangle")}` : "";
  }

  function calledFor(scene) {
    const lights = scene.lights.filter(({ color }) => color.some((part) => part !== 0)).length;
    const lit = (has) => {
      const reason = lights ? reasonOf(scene, has) : "";
      return reason && `${reason}; ${counted(lights, "light")}`;
    };
    const gloss = scene.arrays.gloss_texels.data;
    const diffuse = lit((data, first) => largest(data, first) > 0);
    const highlights = lit((_, __, material) => gloss[4 * material + 3] > 0);
    const shadows = (diffuse || highlights) && scene.triangles > 1
      ? `${counted(lights, "light")}, ${counted(scene.triangles, "triangle")} that may stand before ${lights === 1 ? "it" : "them"}` : "";
    return { diffuse, highlights, shadows, mirrors: reasonOf(scene, (data, first) => data[first + 7] > 0 && largest(data, first + 4) > faintest) };
  }

  // Chapter 03 runs all that it has.
  function whitted() {
    const [cast, add, reflect] = ["cast_shadow_rays", "add_light", "reflect"].map((name) => pass(name));
    const passes = [...["start_weights", "add_surroundings", "select_misses", "select_all"].map((name) => pass(name)), cast, add, pass("select_unmirrored"), reflect];
    return { effects: [], passes, cast, facing: null, lamps: [add], reflect, faintest: null };
  }

  function planned(reasons, all) {
    const effects = effectNames.map((name) => ({ name, reason: reasons[name], isOn: all || reasons[name] !== "", passes: passNamesOf[name] }));
    const isOn = Object.fromEntries(effects.map((effect) => [effect.name, effect.isOn]));
    const lamp = { lamp: "lamp/point.glsl", normal: "normal/interpolated.glsl" };
    const light = { ...lamp, visibility: isOn.shadows ? "visibility/traced.glsl" : "visibility/open.glsl" };
    const cast = isOn.shadows ? pass("cast_lamp_rays", lamp) : null;
    const facing = cast && pass("select_rays");
    const lamps = [
      ...(isOn.diffuse ? [pass("light_surface", { ...light, paint: "paint/plain.glsl" })] : []), ...(isOn.highlights ? [pass("add_highlight", light)] : []),
    ];
    const reflect = isOn.mirrors ? pass("reflect") : null;
    const passes = ["compute_rays", "start_weights", "add_surroundings", "select_misses"].map((name) => pass(name));
    if (lamps.length || reflect) passes.push(pass("select_all"));
    if (cast) passes.push(cast, facing);
    passes.push(...lamps);
    if (reflect) passes.push(pass("select_unmirrored"), reflect, pass("select_faint"));
    return { effects, passes, cast, facing, lamps, reflect, faintest };
  }

  const plans = { shaded: whitted, effects: (scene, all) => planned(calledFor(scene), all) };
  const planOf = (view, scene, all = false) => plans[view]?.(scene, all) ?? null;
  const passesOf = (view) => (view === "effects" ? planned({}, true) : plans[view]?.() ?? { passes: [] }).passes;

  function withTexels(array, change) {
    const data = array.data.slice();
    change(data);
    return { ...array, data };
  }

  function changedScene(scene, { lamps, mirrors, gloss }) {
    if (lamps && mirrors && gloss) return scene;
    if (!changed.has(scene)) changed.set(scene, new Map());
    const kept = changed.get(scene);
    const key = `${lamps} ${mirrors} ${gloss}`;
    if (!kept.has(key)) {
      const arrays = { ...scene.arrays };
      if (!mirrors) arrays.materials = withTexels(arrays.materials, (data) => { for (let i = 7; i < data.length; i += 4 * texelsOfMaterial) data[i] = 0; });
      if (!gloss) arrays.gloss_texels = withTexels(arrays.gloss_texels, (data) => { for (let i = 3; i < data.length; i += 4) data[i] = 0; });
      kept.set(key, { ...scene, lights: lamps ? scene.lights : [], arrays });
    }
    return kept.get(key);
  }

  Object.assign(play, { planOf, passesOf, changedScene });
})();
