// The conformance suite (docs/conformance) on the reader's GPU: its hard cases by the loop over every triangle, judged as
// scripts/conformance/judge.py does it.
//
//   play.offerSuite("data/conformance.js")   the suite as scripts/playground/data.py packs it, which is loaded when it is asked for
//   play.addSuite(name, base64)       keeps it (that script calls it)
//   await play.openSuite()            [{name, triangles, rays, corners, numbers, answers}]
//       corners: nine numbers a triangle; numbers: eight a ray; answers: [{flags, allowed: Map of a triangle to [t_least, t_most]}]
//   await play.runSuite(gpu, {triangle, edits, families, signal, onProgress})
//       [{family, tried, wrong, first}]   first: {ray, kind} of the first wrong answer, or null
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const [missAllowed, anythingAllowed] = [1, 2];
  const room = 2 ** -18; // for the point of u and v, as a part of the reach
  let address = null;
  let packed = null;
  let opened = null;

  function offerSuite(script) {
    address = script;
  }

  function addSuite(name, base64) {
    packed = base64;
  }

  function answersOf(view, count) {
    const answers = [];
    for (let place = view.byteOffset, i = 0; i < count; ++i) {
      const words = new DataView(view.buffer, place);
      const allowed = new Map();
      for (let k = 0; k < words.getUint16(2, true); ++k) {
        allowed.set(words.getInt32(4 + 12 * k, true), [words.getFloat32(8 + 12 * k, true), words.getFloat32(12 + 12 * k, true)]);
      }
      answers.push({ flags: words.getUint16(0, true), allowed });
      place += 4 + 12 * words.getUint16(2, true);
    }
    return answers;
  }

  function unpack(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    let place = 4 + length;
    const take = (Kind, bytes) => {
      const view = new Kind(buffer, place, bytes / Kind.BYTES_PER_ELEMENT);
      place += bytes;
      return view;
    };
    return JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))).map((family) => ({
      ...family, corners: take(Float32Array, 36 * family.triangles), numbers: take(Float32Array, 32 * family.rays),
      answers: answersOf(take(Uint8Array, family.answers), family.rays),
    }));
  }

  async function openSuite() {
    if (!packed && !address) throw new play.PlayError("The hard cases are in the book's playground only: ./run.sh book makes it.");
    opened ??= (packed ? Promise.resolve() : play.loadScript(address)).then(() => play.unzip(packed)).then(unpack).catch((error) => {
      opened = null;
      throw error;
    });
    return opened;
  }

  // The loop alone: a scene of the page has structures too, which a program has built.
  function sceneOf({ name, triangles, corners }) {
    const data = new Float32Array(12 * Math.max(1, triangles));
    for (let corner = 0; corner < 3 * triangles; ++corner) data.set(corners.subarray(3 * corner, 3 * corner + 3), 4 * corner);
    const loop = { name: "every_triangle", arrays: {}, points: {}, counts: {}, numbers: { triangle_count: triangles }, longest_walk: triangles };
    return { scene: name, triangles, arrays: { triangle_corners: { kind: "float4", texels: data.length / 4, data } }, families: { every_triangle: loop } };
  }

  // Whether u and v name the point of the triangle that lies at t.
  function isPointOf(ray, triangle, [t, u, v]) {
    const seen = [0, 1, 2].map((corner) => [0, 1, 2].map((axis) => triangle[3 * corner + axis] - ray[axis]));
    const reach = Math.max(...seen.flat().map(Math.abs));
    return [0, 1, 2].every((axis) => Math.abs((1 - u - v) * seen[0][axis] + u * seen[1][axis] + v * seen[2][axis] - t * ray[3 + axis]) <= room * reach);
  }

  // The kind of a wrong answer; empty where it is right.
  function faultOf([t, u, v], triangle, ray, { corners, triangles }, { flags, allowed }) {
    if (triangle === -1) return flags & missAllowed ? "" : "missed";
    if (!(triangle >= 0 && triangle < triangles)) return "no such triangle";
    if (flags & anythingAllowed) return "";
    if (!allowed.has(triangle)) return "other triangle";
    const [least, most] = allowed.get(triangle);
    if (!(least <= t && t <= most)) return "wrong t";
    return isPointOf(ray, corners.subarray(9 * triangle, 9 * triangle + 9), [t, u, v]) ? "" : "wrong u, v";
  }

  async function runFamily(gpu, family, { triangle, edits = {}, signal = null }) {
    const scene = sceneOf(family);
    const rays = play.listedRays(gpu, family.numbers);
    let result = null;
    try {
      result = await play.trace(gpu, scene, rays, { walk: "every_triangle", triangle, edits, signal, trial: false });
      const words = play.readHits(gpu, result);
      const parts = new Float32Array(words.buffer, words.byteOffset, words.length);
      let [wrong, first] = [0, null];
      family.answers.forEach((answer, ray) => {
        const kind = faultOf(parts.subarray(4 * ray, 4 * ray + 3), words[4 * ray + 3] | 0, family.numbers.subarray(8 * ray, 8 * ray + 8), family, answer);
        if (!kind) return;
        wrong += 1;
        first ??= { ray, kind };
      });
      return { family: family.name, tried: family.rays, wrong, first };
    } finally {
      gpu.free(rays.origins, rays.directions, gpu.buffer(scene.arrays.triangle_corners));
      play.release(gpu, result);
    }
  }

  async function runSuite(gpu, { triangle = "watertight", edits, families: names = null, signal = null, onProgress = () => {} } = {}) {
    const families = (await openSuite()).filter(({ name }) => !names || names.includes(name));
    const rows = [];
    for (const family of families) {
      rows.push(await runFamily(gpu, family, { triangle, edits, signal }));
      onProgress(rows.length, families.length);
    }
    return rows;
  }

  Object.assign(play, { offerSuite, addSuite, openSuite, runSuite });
})();
