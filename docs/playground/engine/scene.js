// A scene with all its structures, as scripts/playground/playground_scene.cpp writes it.
//
//   play.addScene("knot:1", base64)   keeps the packed file (data/scene_*.js calls it)
//   play.offerScene("bunny", "data/scene_bunny.js")   a scene that is loaded when it is opened first
//   await play.loadScript("data/scene_bunny.js")   a script of the playground's folder
//   await play.unzip(base64)          the bytes; play.unpackScene(bytes) makes a scene of them
//   play.sceneNames()                 of all that were added or offered
//   await play.openScene("mirrors")   a scene:
//     {scene, scene_hash, triangles, view, middle_distance, background, reach,
//      arrays: {uniform: {kind, texels, data}}, families: {name: {arrays, points, counts, numbers, longest_walk}}}
//   play.familyOf(scene, "bvh_skip")  the structure that serves a walk
//   play.viewUniforms(scene)          the camera as uniforms of compute_rays.frag, for a square picture
//
// The kind of an array is that of its texels: float4, int4 or int1. `data` is a typed array.
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const folder = new URL("..", document.currentScript.src); // of the playground, wherever the page lies
  const octants = 8;
  const packed = new Map();
  const offered = new Map();
  const opened = new Map();

  function addScene(name, base64) {
    packed.set(name, base64);
  }

  function offerScene(name, address) {
    offered.set(name, address);
  }

  // By an element of the page, since a page from the disk may load a script and nothing else.
  function loadScript(address) {
    return new Promise((resolve, reject) => {
      const script = Object.assign(document.createElement("script"), { src: new URL(address, folder), onload: resolve });
      script.onerror = () => reject(new play.PlayError(`${address} could not be loaded. Is the folder of the playground whole?`));
      document.head.append(script);
    });
  }

  function load(name) {
    return packed.has(name) ? Promise.resolve() : loadScript(offered.get(name)).catch((error) => {
      opened.delete(name);
      throw error;
    });
  }

  async function unzip(base64) {
    if (!globalThis.DecompressionStream) {
      throw new play.PlayError("This browser cannot unpack the scenes (it has no DecompressionStream). A newer one runs the shaders; the recorded pictures and walks work all the same.");
    }
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  function widened(numbers) {
    const texels = new Float32Array(numbers.length / 3 * 4);
    for (let i = 0; i < numbers.length; ++i) texels[4 * Math.floor(i / 3) + i % 3] = numbers[i];
    return texels;
  }

  // The nodes once for each octant of directions, from the order of octant 0, in which the planes that come first are the
  // lower ones: shaders/structure/bvh/bvh_nodes.glsl has the form, common/structure/bvh/bvh.cpp makes the same.
  function allOctants(one) {
    const count = one.length / 8;
    const all = new Int32Array(octants * one.length);
    const skip = (node) => one[8 * node + 3];
    const link = (node) => one[8 * node + 7];
    const branch = (node) => (skip(node) < 0 ? count : skip(node)) - node;
    const second = (node) => (-1 - link(node)) >> 2;
    const axis = (node) => (-1 - link(node)) & 3;
    const places = new Int32Array(count);
    for (let octant = 0; octant < octants; ++octant) {
      const start = octant * count;
      places[0] = 0;
      for (let node = 0; node < count; ++node) {
        let own = link(node);
        if (own < 0) {
          const descends = octant >> axis(node) & 1;
          const [near, far] = descends ? [second(node), node + 1] : [node + 1, second(node)];
          places[near] = places[node] + 1;
          places[far] = places[near] + branch(near);
          own = -1 - (4 * (start + places[far]) + axis(node));
        }
        const texel = 8 * (start + places[node]);
        for (let i = 0; i < 3; ++i) {
          const descends = octant >> i & 1;
          all[texel + i] = one[8 * node + i + (descends ? 4 : 0)];
          all[texel + 4 + i] = one[8 * node + i + (descends ? 0 : 4)];
        }
        const behind = places[node] + branch(node);
        all[texel + 3] = behind === count ? -1 : start + behind;
        all[texel + 7] = own;
      }
    }
    return all;
  }

  // Each node of all octants by its number in octant 0, which people know it by.
  function placesInFirst(one) {
    const count = one.length / 8;
    const numbered = one.slice();
    for (let node = 0; node < count; ++node) numbered[8 * node] = numbered[8 * node + 4] = node;
    const all = allOctants(numbered);
    return Int32Array.from({ length: octants * count }, (_, place) => all[8 * place]);
  }

  function parentsOf(one) {
    const parents = new Int32Array(one.length / 8).fill(-1);
    for (let node = 0; node < parents.length; ++node) {
      const link = one[8 * node + 7];
      if (link < 0) parents[node + 1] = parents[(-1 - link) >> 2] = node;
    }
    return parents;
  }

  // The triangles in the order of the leaves, three texels each: shaders/structure/bvh/bvh_leaf.glsl.
  function leavesOf(order, corners) {
    const bits = new Int32Array(corners.buffer);
    const texels = new Int32Array(12 * order.length);
    order.forEach((entry, i) => {
      const triangle = entry >> 1;
      for (let corner = 0; corner < 3; ++corner) {
        for (let axis = 0; axis < 3; ++axis) texels[12 * i + 4 * corner + axis] = bits[12 * triangle + 4 * corner + axis];
      }
      texels[12 * i + 3] = triangle;
      texels[12 * i + 7] = entry & 1;
    });
    return texels;
  }

  // A child's box is its parent's with the plane between as one side: shaders/structure/kd_tree/kd_nodes.glsl.
  function kdBoxes(nodes, lower, upper) {
    const splits = new Float32Array(nodes.buffer, nodes.byteOffset, nodes.length);
    const boxes = new Float32Array(2 * nodes.length);
    boxes.set(lower, 0);
    boxes.set(upper, 4);
    for (let node = 0; node < nodes.length / 4; ++node) {
      const axis = nodes[4 * node] & 3;
      if (axis === 3) continue;
      const own = boxes.slice(8 * node, 8 * node + 8);
      const first = 8 * nodes[4 * node + 2];
      boxes.set(own, first);
      boxes.set(own, first + 8);
      boxes[first + 4 + axis] = boxes[first + 8 + axis] = splits[4 * node + 1];
    }
    return boxes;
  }

  function unpack(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
    const view = (Kind, { start, bytes }) => new Kind(buffer, 4 + length + start, bytes / 4);

    function readArrays(list, family) {
      const arrays = {};
      for (const entry of list) {
        const { name, kind, texels } = entry;
        if (kind === "octants") {
          const one = view(Int32Array, entry);
          arrays[name] = { kind: "int4", texels, data: allOctants(one) };
          arrays.bvh_parents = { kind: "int1", texels: one.length / 8, data: parentsOf(one) };
          arrays.bvh_first_octant = { kind: "int1", texels: one.length, data: placesInFirst(one) }; // for people: no walk has use for it
        } else if (kind === "leaves") {
          arrays[name] = { kind: "int4", texels, data: leavesOf(view(Int32Array, entry), scene.arrays.triangle_corners.data) };
        } else if (kind === "kd_boxes") {
          const nodes = view(Int32Array, list.find((other) => other.name === "kd_nodes"));
          arrays[name] = { kind: "float4", texels, data: kdBoxes(nodes, family.points.kd_lower, family.points.kd_upper) };
        } else if (kind === "float3") {
          arrays[name] = { kind: "float4", texels, data: widened(view(Float32Array, entry)) };
        } else {
          arrays[name] = { kind, texels, data: view(kind === "float4" ? Float32Array : Int32Array, entry) };
        }
      }
      return arrays;
    }

    const scene = { ...head, arrays: {}, families: {} };
    scene.arrays = readArrays(head.arrays, null);
    for (const family of head.families) {
      // A walk needs one of them, and what the page makes of the file may be large.
      let arrays = null;
      scene.families[family.name] = { ...family, get arrays() { return arrays ??= readArrays(family.arrays, family); } };
    }
    return scene;
  }

  function openScene(name) {
    if (!sceneNames().includes(name)) throw new play.PlayError(`There is no scene ${name}. Take one of ${sceneNames().join(", ")}.`);
    if (!opened.has(name)) opened.set(name, load(name).then(() => unzip(packed.get(name))).then(unpack));
    return opened.get(name);
  }

  const sceneNames = () => [...new Set([...packed.keys(), ...offered.keys()])];

  function familyOf(scene, walk) {
    const single = walk.replace(/^packet_/, "");
    const family = Object.values(scene.families).find(({ name }) => single === name || single.startsWith(`${name}_`));
    if (!family) throw new play.PlayError(`Nobody builds for the walk ${walk}. Name it after a structure: ${Object.keys(scene.families).join(", ")}.`);
    return family;
  }

  function viewUniforms(scene) {
    return Object.fromEntries(Object.entries(scene.view).map(([name, value]) => [`view.${name}`, value]));
  }

  Object.assign(play, { addScene, offerScene, loadScript, unzip, unpackScene: unpack, sceneNames, openScene, familyOf, viewUniforms });
})();
