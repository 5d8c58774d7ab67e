// What the reader's GPU can do: every walk measured in rounds, each of which has all of them, so that what slows the machine for a
// while slows all. The first round warms up and is dropped.
//
//   await play.measureGpu(gpu, scene, {triangle, signal, onProgress, rounds, size, walks})   the card, by gpu_card.schema.json
//       onProgress(done, of); throws Stopped, PlayError, ContextLost
//   play.cameraText(scene)            the camera as --camera takes it
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const mostSeconds = 0.3; // of one trace: a slower walk is measured with a smaller picture
  const smallest = 32; // pixels each way

  const rounded = (value) => Number(Math.fround(value).toPrecision(7));

  function cameraText({ view, middle_distance: distance }) {
    const { eye, lower_left: corner, right, up } = view;
    const forward = corner.map((value, axis) => value + (right[axis] + up[axis]) / 2);
    const target = eye.map((value, axis) => value + distance * forward[axis]);
    const fov = 2 * Math.atan(Math.hypot(...up) / 2 / Math.hypot(...forward)) * 180 / Math.PI;
    return [...eye, ...target, fov].map(rounded).join();
  }

  // A GPU that counts the time of its draws by itself, where the browser lets it.
  function openTimer(gpu) {
    const { gl } = gpu;
    const extension = gl.getExtension("EXT_disjoint_timer_query_webgl2");
    if (!extension || !gl.getQuery(extension.TIME_ELAPSED_EXT, extension.QUERY_COUNTER_BITS_EXT)) return null;
    let queries = [];
    const timed = Object.assign(Object.create(gpu), {
      draw(...what) {
        const query = gl.createQuery();
        gl.beginQuery(extension.TIME_ELAPSED_EXT, query);
        try {
          gpu.draw(...what);
        } finally {
          gl.endQuery(extension.TIME_ELAPSED_EXT);
        }
        queries.push(query);
      },
    });
    // Seconds since the last call; null where something came between, and the sum is worth nothing.
    async function seconds() {
      const asked = queries;
      queries = [];
      await gpu.finished();
      const isReady = (query) => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE);
      for (let tries = 0; tries < 200 && !asked.every(isReady); ++tries) await new Promise((resolve) => setTimeout(resolve, 2));
      const isGood = asked.every(isReady) && !gl.getParameter(extension.GPU_DISJOINT_EXT);
      const sum = isGood ? asked.reduce((all, query) => all + gl.getQueryParameter(query, gl.QUERY_RESULT), 0) * 1e-9 : null;
      asked.forEach((query) => gl.deleteQuery(query));
      return sum > 0 ? sum : null;
    }
    return { gpu: timed, seconds };
  }

  const inOrder = (values) => [...values].sort((a, b) => a - b);
  const medianOf = (values) => inOrder(values)[Math.floor(values.length / 2)];

  async function measureGpu(gpu, scene, { triangle = "watertight", signal = null, onProgress = () => {}, rounds = 5, size = 256, walks: names = play.walkNames() } = {}) {
    const walks = names.map((walk) => ({ walk, size: smallest, byTimer: [], byClock: [] }));
    const timer = openTimer(gpu);
    const raysOf = new Map();
    const rays = (pixels) => {
      if (!raysOf.has(pixels)) raysOf.set(pixels, play.cameraRays(gpu, scene, pixels));
      return raysOf.get(pixels);
    };
    let done = 0;
    const of = walks.length * (rounds + 3);
    async function traced(entry, observer = "none") {
      if (signal?.aborted) throw new play.Stopped("Stopped.");
      const result = await play.trace(timer && observer === "none" ? timer.gpu : gpu, scene, rays(entry.size), { walk: entry.walk, triangle, observer, signal, trial: false });
      onProgress(done += 1, of);
      return result;
    }
    try {
      for (const entry of walks) {
        play.release(gpu, await traced(entry)); // compiles
        const first = await traced(entry);
        play.release(gpu, first);
        await timer?.seconds();
        const most = Math.sqrt(smallest * smallest * mostSeconds / (first.milliseconds / 1000));
        while (2 * entry.size <= Math.min(size, most)) entry.size *= 2;
        if (entry.walk.startsWith("packet_")) { // nobody observes what its rays do
          done += 1;
          continue;
        }
        const counted = await traced(entry, "count");
        entry.seen = meansOf(play.readObservations(gpu, counted));
        play.release(gpu, counted);
      }
      for (let round = 0; round < rounds; ++round) {
        for (const entry of walks) {
          const result = await traced(entry);
          play.release(gpu, result);
          entry.byClock.push(result.milliseconds / 1000);
          const seconds = await timer?.seconds();
          if (seconds) entry.byTimer.push(seconds);
        }
      }
    } finally {
      for (const { origins, directions } of raysOf.values()) gpu.free(origins, directions);
    }
    // All walks by one of the two: a table of both would compare nothing.
    const byTimer = Boolean(timer) && walks.every((entry) => entry.byTimer.length === rounds);
    return cardOf(gpu, scene, { walks, byTimer, triangle, rounds });
  }

  function meansOf(seen) {
    let [visits, tests] = [0, 0];
    for (let i = 0; i < seen.length; i += 4) {
      visits += seen[i];
      tests += seen[i + 1];
    }
    return { visits_per_ray: 4 * visits / seen.length, tests_per_ray: 4 * tests / seen.length };
  }

  function cardOf(gpu, scene, { walks, byTimer, triangle, rounds }) {
    const { rows, rounds: asLessons } = play.probe(gpu);
    return {
      head: {
        schema: "gpu_card.schema.json", schema_version: 1, commit: "unknown", modified: false,
        date: new Date().toISOString().replace(/\.\d+Z/, "Z"), cpu: "unknown", cores: navigator.hardwareConcurrency || 1,
        renderer: gpu.name, opengl: gpu.gl.getParameter(gpu.gl.VERSION), builders: {},
        scenes: [{ scene: scene.scene, hash: scene.scene_hash, triangles: scene.triangles, camera: cameraText(scene) }],
      },
      browser: navigator.userAgent, scene: scene.scene, triangle, kind: "primary", rounds, timer: byTimer ? "gpu" : "clock",
      rounding: { as_the_lessons: asLessons, questions: rows.map(({ question, wrong, of, matters }) => ({ question, wrong, of, matters })) },
      walks: walks.map((entry) => {
        const rays = entry.size * entry.size;
        const rates = (byTimer ? entry.byTimer : entry.byClock).map((seconds) => rays / seconds / 1e6);
        return {
          contender: entry.walk, rays, million_rays_per_second: medianOf(rates), lowest: Math.min(...rates), highest: Math.max(...rates),
          ...entry.seen,
        };
      }),
    };
  }

  Object.assign(play, { measureGpu, cameraText });
})();
