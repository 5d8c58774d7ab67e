// Rays that no triangle test may lose: they start inside a closed body and are aimed at its edges and corners.
//
//   play.closedBodies(scene)          [{triangles: [number], middle}]: convex bodies whose every edge has two triangles
//   play.aimedRays(scene, count)      {numbers, bodies, owners: Map of a triangle to its body, bodyOf: [index]}; null where nothing is closed
//       numbers: eight a ray, as play.listedRays takes them
//   await play.countLeaks(gpu, scene, aimed, {walk, triangle, edits, signal})
//       {leaks, of, first: numbers of the first ray or null, pixels: ImageData, a pixel a ray}
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const [heldColor, leakColor] = [[90, 96, 104], [230, 120, 0]];
  const aimed = new WeakMap();

  const cornerOf = ({ data }, triangle, corner) => [0, 1, 2].map((axis) => data[12 * triangle + 4 * corner + axis]);
  const minus = (a, b) => a.map((value, axis) => value - b[axis]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const mean = (points) => [0, 1, 2].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);

  function neighboursOf(corners, count) {
    const edges = new Map();
    for (let triangle = 0; triangle < count; ++triangle) {
      const ends = [0, 1, 2].map((corner) => cornerOf(corners, triangle, corner).join(" "));
      for (let i = 0; i < 3; ++i) {
        const key = [ends[i], ends[(i + 1) % 3]].sort().join(", ");
        edges.set(key, [...(edges.get(key) ?? []), triangle]);
      }
    }
    const neighbours = Array.from({ length: count }, () => []);
    for (const both of edges.values()) {
      if (both.length === 2) both.forEach((one, i) => neighbours[one].push(both[1 - i]));
    }
    return neighbours;
  }

  // On the same side of all planes, and not in one of them.
  function isInside(corners, triangles, point) {
    const sides = triangles.map((triangle) => {
      const [a, b, c] = [0, 1, 2].map((corner) => cornerOf(corners, triangle, corner));
      return Math.sign(dot(cross(minus(b, a), minus(c, a)), minus(point, a)));
    });
    return sides[0] !== 0 && sides.every((side) => side === sides[0]);
  }

  function closedBodies(scene) {
    const corners = scene.arrays.triangle_corners;
    const neighbours = neighboursOf(corners, scene.triangles);
    const seen = new Set();
    const bodies = [];
    for (let start = 0; start < scene.triangles; ++start) {
      if (seen.has(start)) continue;
      const triangles = [start];
      seen.add(start);
      for (let i = 0; i < triangles.length; ++i) {
        for (const next of neighbours[triangles[i]]) {
          if (!seen.has(next)) { seen.add(next); triangles.push(next); }
        }
      }
      const middle = mean(triangles.flatMap((triangle) => [0, 1, 2].map((corner) => cornerOf(corners, triangle, corner))));
      const isClosed = triangles.every((triangle) => neighbours[triangle].length === 3);
      if (isClosed && isInside(corners, triangles, middle)) bodies.push({ triangles, middle });
    }
    return bodies;
  }

  function aimedRays(scene, count) {
    if (!aimed.has(scene)) aimed.set(scene, make(scene, count));
    return aimed.get(scene);
  }

  function make(scene, count) {
    const bodies = closedBodies(scene);
    if (!bodies.length) return null;
    const corners = scene.arrays.triangle_corners;
    const random = play.randomBits(1);
    const share = () => random.next().value / 0x7fffffff;
    const numbers = new Float32Array(8 * count);
    const bodyOf = [];
    for (let ray = 0; ray < count; ++ray) {
      const body = ray % bodies.length;
      const { triangles, middle } = bodies[body];
      const triangle = triangles[Math.floor(share() * triangles.length)];
      const first = Math.floor(share() * 3);
      const [a, b] = [cornerOf(corners, triangle, first), cornerOf(corners, triangle, (first + 1) % 3)];
      const along = ray % 4 === 3 ? 0 : share();
      const target = a.map((value, axis) => Math.fround(value + Math.fround(along * (b[axis] - value))));
      // Between the middle and a corner of the body: that is inside, as it is convex.
      const other = cornerOf(corners, triangles[Math.floor(share() * triangles.length)], 0);
      const away = 0.5 * share();
      const origin = middle.map((value, axis) => Math.fround(value + away * (other[axis] - value)));
      numbers.set([...origin, ...minus(target, origin), 0, play.farthest], 8 * ray);
      bodyOf.push(body);
    }
    const owners = new Map(bodies.flatMap(({ triangles }, body) => triangles.map((triangle) => [triangle, body])));
    return { numbers, bodies, owners, bodyOf };
  }

  async function countLeaks(gpu, scene, { numbers, owners, bodyOf }, { walk, triangle, edits = {}, signal = null }) {
    const rays = play.listedRays(gpu, numbers);
    const { width, height } = rays;
    let result = null;
    try {
      result = await play.trace(gpu, scene, rays, { walk, triangle, edits, signal });
      const words = play.readHits(gpu, result);
      const pixels = new ImageData(width, height);
      let leaks = 0;
      let first = null;
      bodyOf.forEach((body, ray) => {
        const isLeak = owners.get(words[4 * ray + 3] | 0) !== body;
        leaks += isLeak ? 1 : 0;
        if (isLeak) first ??= [...numbers.subarray(8 * ray, 8 * ray + 8)];
        pixels.data.set([...(isLeak ? leakColor : heldColor), 255], 4 * ray);
      });
      return { leaks, of: bodyOf.length, first, pixels, stopped: result.stopped };
    } finally {
      gpu.free(rays.origins, rays.directions);
      play.release(gpu, result);
    }
  }

  Object.assign(play, { closedBodies, aimedRays, countLeaks });
})();
