// Traces as pictures on 2D canvases, top row first.
//
//   play.viewNames()                  the parts of <view>, the lights shaded and effects (engine/plan.js), and the heat maps visits and tests
//   play.observerOf(view)             which observer a trace needs for the view
//   await play.viewPicture(gpu, scene, rays, result, view, {edits, upper, walk, triangle, plan, signal})
//       {pixels: ImageData, legend, linear, stopped, waves}   legend: null, or {title, upper} of a heat map, whose scale may be given
//       linear: four numbers a pixel, or null
//   play.differencePicture(gpu, mine, right, linear)
//       {pixels, differing, first: {x, y} or null}      results of two traces; what was observed counts too, and so do
//       linear: the colours of both, where there are some
//   play.pixelOf(gpu, result, x, y)   {t, u, v, triangle, words, visits, tests}: words are the bits; x, y from the top left
//   play.show(canvas, pixels)         puts them on, and gives the canvas their size
//   play.legendColors                 of a heat map, from 0 up, as CSS colours
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const heatMaps = { visits: "cells or nodes visited a ray", tests: "triangles tested a ray" };
  // Every 17th of viridis's 256 entries, in sRGB steps: common/image/color.cpp.
  const viridis = [[68, 1, 84], [72, 26, 108], [71, 47, 125], [65, 68, 135], [57, 86, 140], [49, 104, 142], [42, 120, 142],
    [35, 136, 142], [31, 152, 139], [34, 168, 132], [53, 183, 121], [84, 197, 104], [122, 209, 81], [165, 219, 54],
    [210, 226, 27], [253, 231, 37]];
  const stoppedColor = [200, 30, 160];
  const sameColor = [90, 96, 104];
  const differentColor = [230, 120, 0];
  const ofMost = 0.99; // a few rays along a silhouette do many times more, and would leave the rest in the dark

  const viewNames = () => [...play.listParts("view").map(({ name }) => name), "shaded", "effects", ...Object.keys(heatMaps)];
  const observerOf = (view) => (heatMaps[view] ? "count" : "none");

  // IEC 61966-2-1:1999, as a table.
  const srgb = Uint8ClampedArray.from({ length: 4096 }, (_, i) => {
    const linear = i / 4095;
    return Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
  });
  const encoded = (linear) => srgb[Math.round(4095 * Math.min(1, Math.max(0, linear || 0)))];

  function heatColor(part) {
    const place = Math.min(1, Math.max(0, part)) * (viridis.length - 1);
    const entry = Math.min(Math.floor(place), viridis.length - 2);
    return viridis[entry].map((value, i) => value + (place - entry) * (viridis[entry + 1][i] - value));
  }

  // `colorOf(ray)` gives three steps of sRGB; rays count from the lower left.
  function picture(width, height, colorOf) {
    const pixels = new ImageData(width, height);
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        const [red, green, blue] = colorOf((height - 1 - y) * width + x);
        pixels.data.set([red, green, blue, 255], 4 * (y * width + x));
      }
    }
    return pixels;
  }

  // The colours of a part of <view>.
  function shownHits(gpu, scene, rays, result, view, edits) {
    const colors = gpu.texture("rgba32f", result.width, result.height);
    try {
      const made = gpu.program("pass/show/show_hits.frag", { real: "real/float.glsl", view: play.findPart("view", view) }, edits);
      gpu.draw(made, {
        ...scene.arrays, ray_origins: rays.origins, ray_directions: rays.directions, hits: result.hits,
        middle_distance: scene.middle_distance, background: scene.background,
      }, [colors], { clear: [[0, 0, 0, 1]] });
      return { linear: gpu.readFloats(colors), stopped: null };
    } finally {
      gpu.free(colors);
    }
  }

  async function viewPicture(gpu, scene, rays, result, view, { edits = {}, upper = null, ...tracing } = {}) {
    const { width, height } = result;
    const words = play.readHits(gpu, result);
    const isStopped = (ray) => words[4 * ray + 3] === play.stoppedMark;
    if (heatMaps[view]) {
      const seen = play.readObservations(gpu, result);
      const values = Float64Array.from({ length: width * height }, (_, ray) => seen[4 * ray + (view === "visits" ? 0 : 1)]);
      const busy = values.filter((value) => value > 0).sort();
      const most = upper ?? (busy.length ? busy[Math.max(1, Math.ceil(ofMost * busy.length)) - 1] : 1);
      return {
        pixels: picture(width, height, (ray) => (isStopped(ray) ? stoppedColor : heatColor(values[ray] / most))),
        legend: { title: heatMaps[view], upper: most }, linear: null, stopped: null, waves: 0,
      };
    }
    const { linear, stopped, waves = 0 } = tracing.plan ? await play.shade(gpu, scene, rays, result, { edits, ...tracing })
      : shownHits(gpu, scene, rays, result, view, edits);
    const colorOf = (ray) => [0, 1, 2].map((i) => encoded(linear[4 * ray + i]));
    return { pixels: picture(width, height, (ray) => (isStopped(ray) ? stoppedColor : colorOf(ray))), legend: null, linear, stopped, waves };
  }

  function differencePicture(gpu, mine, right, linear = [null, null]) {
    const { width, height } = mine;
    const [a, b] = [mine, right].map((result) => play.readHits(gpu, result));
    const [c, d] = mine.observations && right.observations
      ? [mine, right].map((result) => play.readObservations(gpu, result)) : [null, null];
    const [e, f] = linear[0] && linear[1] ? linear.map(({ buffer }) => new Uint32Array(buffer)) : [null, null];
    const differs = (ray) => {
      for (let i = 4 * ray; i < 4 * ray + 4; ++i) if (a[i] !== b[i] || (c && c[i] !== d[i]) || (e && e[i] !== f[i])) return true;
      return false;
    };
    let differing = 0;
    let first = null;
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        if (!differs((height - 1 - y) * width + x)) continue;
        differing += 1;
        first ??= { x, y };
      }
    }
    return { pixels: picture(width, height, (ray) => (differs(ray) ? differentColor : sameColor)), differing, first };
  }

  function pixelOf(gpu, result, x, y) {
    const ray = (result.height - 1 - y) * result.width + x;
    const words = play.readHits(gpu, result).slice(4 * ray, 4 * ray + 4);
    const [t, u, v] = new Float32Array(words.buffer);
    const seen = result.observations ? play.readObservations(gpu, result) : null;
    return { t, u, v, triangle: words[3] | 0, words: [...words], visits: seen?.[4 * ray] ?? null, tests: seen?.[4 * ray + 1] ?? null };
  }

  function show(canvas, pixels) {
    canvas.width = pixels.width;
    canvas.height = pixels.height;
    canvas.getContext("2d").putImageData(pixels, 0, 0);
  }

  const legendColors = viridis.map((color) => `rgb(${color.join(" ")})`);
  Object.assign(play, { viewNames, observerOf, viewPicture, differencePicture, pixelOf, show, legendColors });
})();
