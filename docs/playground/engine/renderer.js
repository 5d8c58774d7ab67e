// The GPU as passes see it: textures, programs, draws, questions. One context for the whole page; pictures are read back
// and drawn into 2D canvases. What is made here keeps its numbers, so a lost context can be rebuilt.
//
//   const gpu = play.openGpu()        throws PlayError where WebGL2, float targets or 32 bits in a texture are missing
//   gpu.program(pass, parts, edits)   compiled and linked, once; throws CompileError {errors: [{file, line, message, words}]}
//   gpu.texture(format, w, h, {layers, data})   rgba32f, rgba32ui, rgba32i or r32i; `layers` makes an array texture
//   gpu.buffer(array)                 the texture of an array of play.openScene, made once
//   gpu.free(...textures)
//   gpu.draw(program, uniforms, targets, {live, clear, rows, blend, shape})
//       uniforms: {name: number | list | texture | array of a scene}; names that a program lacks are passed over
//       targets: textures, each layer an output; clear: a list of four numbers for each; rows: [first, end)
//   gpu.mask(w, h)                    which pixels still live; gpu.retire(mask, program, uniforms) takes out what is drawn
//   await gpu.any(program, uniforms, mask)   whether it draws a (live) pixel at all: an occlusion query
//   await gpu.finished()              milliseconds until what was asked for so far is done
//   gpu.readFloats(texture), gpu.readIntegers(texture, layer)
//   gpu.name                          of the renderer, as the browser tells it
//   gpu.generation()                  grows with each context: what was made before is gone
//   gpu.state                         "ready", "lost" (wait for gpu.onRestored) or "gone" (for good)
//   gpu.onLost, gpu.onRestored, gpu.onGone    functions to set. Nothing runs by itself after a loss.
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const rowOfBuffer = 2048; // texels: prelude.glsl
  const patience = 3000; // milliseconds that a browser has to give a lost context back
  const fullScreen = "pass/full_screen.vert";

  class CompileError extends play.PlayError {
    constructor(errors) {
      super(errors.map(({ file, line, message, words }) => `${file ? `${file}:${line}: ` : ""}${message}${words ? ` (${words})` : ""}`).join("\n"));
      this.errors = errors;
    }
  }
  class ContextLost extends play.PlayError {}

  function openGpu() {
    let canvas;
    let gl;
    let generation = 0;
    let losses = 0;
    let programs = new Map();
    let buffers = new WeakMap();
    let framebuffer;
    let formats;
    const gpu = { state: "ready", onLost() {}, onRestored() {}, onGone() {} };

    function open() {
      canvas = document.createElement("canvas");
      canvas.width = canvas.height = 1;
      gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: false, powerPreference: "high-performance" });
      if (!gl) return false;
      gpu.canvas = canvas;
      gpu.gl = gl;
      canvas.addEventListener("webglcontextlost", lost);
      canvas.addEventListener("webglcontextrestored", restored);
      return true;
    }

    function begin() {
      generation += 1;
      programs = new Map();
      buffers = new WeakMap();
      if (!gl.getExtension("EXT_color_buffer_float")) {
        throw new play.PlayError("This browser's WebGL2 cannot draw into textures of floats, and a walk keeps its rays in them. The recorded pictures and walks work all the same.");
      }
      gl.getExtension("EXT_float_blend");
      const info = gl.getExtension("WEBGL_debug_renderer_info");
      gpu.name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
      gpu.largestTexture = gl.getParameter(gl.MAX_TEXTURE_SIZE);
      framebuffer = gl.createFramebuffer();
      gl.bindVertexArray(gl.createVertexArray());
      formats = {
        rgba32f: [gl.RGBA32F, gl.RGBA, gl.FLOAT], rgba32ui: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT],
        rgba32i: [gl.RGBA32I, gl.RGBA_INTEGER, gl.INT], r32i: [gl.R32I, gl.RED_INTEGER, gl.INT],
      };
    }

    function lost(event) {
      event.preventDefault();
      losses += 1;
      const wasOn = canvas;
      if (losses > 1) {
        gpu.state = "gone";
        gpu.onGone();
        return;
      }
      gpu.state = "lost";
      gpu.onLost();
      setTimeout(() => {
        if (gpu.state !== "lost" || canvas !== wasOn) return;
        if (open()) restored();
        else { gpu.state = "gone"; gpu.onGone(); }
      }, patience);
    }

    function restored() {
      if (gpu.state !== "lost") return;
      begin();
      gpu.state = "ready";
      gpu.onRestored();
    }

    function check() {
      if (gpu.state === "ready" && !gl.isContextLost()) return;
      throw new ContextLost("The browser has taken the graphics context away. Your text is kept.");
    }

    function compile(kind, shader) {
      const made = gl.createShader(kind);
      gl.shaderSource(made, shader.text);
      gl.compileShader(made);
      return made;
    }

    function complain(made, shader) {
      if (gl.getShaderParameter(made, gl.COMPILE_STATUS)) return;
      check();
      const errors = play.nameFiles(gl.getShaderInfoLog(made) ?? "", shader.files).filter(({ message }) => message);
      throw new CompileError(errors.map((error) => ({ ...error, words: play.explain(error.message) })));
    }

    // `pass` is a .frag file; a .vert file of its name belongs to it.
    function program(pass, parts = {}, edits = {}, ending = play.endings.leaveNoMark) {
      check();
      const own = pass.replace(/\.frag$/, ".vert");
      const vertexFile = play.files[own] ? own : fullScreen;
      const vertex = play.readShader(vertexFile, parts, { edits });
      const fragment = play.readShader(pass, parts, { edits, ending });
      const key = vertex.text + fragment.text;
      if (programs.has(key)) return programs.get(key);
      for (const file of [...vertex.files, ...fragment.files]) {
        const refusal = edits[file] === undefined ? null : play.refuse(edits[file]);
        if (refusal) throw new CompileError([{ file, line: 0, message: refusal, words: "" }]);
      }
      const shaders = [compile(gl.VERTEX_SHADER, vertex), compile(gl.FRAGMENT_SHADER, fragment)];
      const linked = gl.createProgram();
      shaders.forEach((shader) => gl.attachShader(linked, shader));
      gl.linkProgram(linked);
      if (!gl.getProgramParameter(linked, gl.LINK_STATUS)) {
        const log = gl.getProgramInfoLog(linked);
        try {
          complain(shaders[0], vertex);
          complain(shaders[1], fragment);
          check();
          throw new CompileError([{ file: pass, line: 0, message: log ?? "The program cannot be linked.", words: "" }]);
        } finally {
          gl.deleteProgram(linked);
          shaders.forEach((shader) => gl.deleteShader(shader));
        }
      }
      shaders.forEach((shader) => gl.deleteShader(shader));
      const uniforms = [];
      let unit = 0;
      for (let i = 0; i < gl.getProgramParameter(linked, gl.ACTIVE_UNIFORMS); ++i) {
        const { name, type } = gl.getActiveUniform(linked, i);
        const place = gl.getUniformLocation(linked, name);
        uniforms.push({ name, type, place, unit: isSampler(type) ? unit++ : -1 });
      }
      const made = { linked, uniforms, generation, key, pass, parts, edits, files: fragment.files };
      programs.set(key, made);
      return made;
    }

    const isSampler = (type) => [gl.SAMPLER_2D, gl.INT_SAMPLER_2D, gl.UNSIGNED_INT_SAMPLER_2D,
      gl.UNSIGNED_INT_SAMPLER_2D_ARRAY, gl.SAMPLER_2D_ARRAY].includes(type);

    function forget(made) {
      gl.deleteProgram(made.linked);
      programs.delete(made.key);
    }

    function texture(format, width, height, { layers = 0, data = null } = {}) {
      check();
      const [internal, external, type] = formats[format];
      const target = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
      if (Math.max(width, height) > gpu.largestTexture) {
        throw new play.PlayError(`A texture of ${width} x ${height} is more than this GPU takes (${gpu.largestTexture}). Take a smaller picture or scene.`);
      }
      const id = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(target, id);
      gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      if (layers) gl.texStorage3D(target, 1, internal, width, height, layers);
      else gl.texStorage2D(target, 1, internal, width, height);
      const made = { id, target, format, width, height, layers, generation };
      if (data) write(made, data);
      return made;
    }

    // Whole rows, then what is left of one.
    function write({ format, width }, data) {
      const [, external, type] = formats[format];
      const components = format === "r32i" ? 1 : 4;
      const texels = data.length / components;
      const whole = Math.floor(texels / width);
      if (whole) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, whole, external, type, data, 0);
      if (texels % width) {
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, whole, texels % width, 1, external, type, data, whole * width * components);
      }
    }

    function buffer(array) {
      check();
      if (!buffers.has(array)) {
        const format = { float4: "rgba32f", int4: "rgba32i", int1: "r32i" }[array.kind];
        const rows = Math.max(1, Math.ceil(array.texels / rowOfBuffer));
        buffers.set(array, texture(format, rows > 1 ? rowOfBuffer : Math.max(1, array.texels), rows, { data: array.data }));
      }
      return buffers.get(array);
    }

    function free(...textures) {
      for (const each of textures) {
        if (each && each.generation === generation) gl.deleteTexture(each.id);
      }
    }

    function use(made, values) {
      if (made.generation !== generation) throw new ContextLost("This program was made before the graphics context was lost. Make it again.");
      gl.useProgram(made.linked);
      // Arrays become textures before any is bound, since making one binds it.
      const set = made.uniforms.filter(({ name }) => values[name] !== undefined).map((uniform) =>
        ({ ...uniform, value: values[uniform.name].data ? buffer(values[uniform.name]) : values[uniform.name] }));
      for (const { name, type, place, unit, value } of set) {
        if (unit >= 0) {
          const { id, target } = value;
          gl.activeTexture(gl.TEXTURE0 + unit);
          gl.bindTexture(target, id);
          gl.uniform1i(place, unit);
        } else if (type === gl.FLOAT) gl.uniform1f(place, value);
        else if (type === gl.INT || type === gl.BOOL) gl.uniform1i(place, Number(value));
        else if (type === gl.FLOAT_VEC2) gl.uniform2fv(place, value);
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
        else if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, value);
        else if (type === gl.INT_VEC3) gl.uniform3iv(place, value);
        else if (type === gl.INT_VEC2) gl.uniform2iv(place, value);
        else throw new play.PlayError(`${made.pass}: the page cannot set the uniform ${name}. Declare it as a float, an int, a vector or a texture.`);
      }
    }

    // Attaches the targets, each layer of one as an output.
    function attach(targets, depthStencil, depth) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      const places = [];
      for (const target of targets) {
        for (let layer = 0; layer < Math.max(1, target.layers); ++layer) {
          const place = gl.COLOR_ATTACHMENT0 + places.length;
          if (target.layers) gl.framebufferTextureLayer(gl.FRAMEBUFFER, place, target.id, 0, layer);
          else gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, target.id, 0);
          places.push(place);
        }
      }
      for (let i = places.length; i < 4; ++i) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, null, 0);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_STENCIL_ATTACHMENT, gl.RENDERBUFFER, depthStencil ?? null);
      if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth.id, 0);
      gl.drawBuffers(places.length ? places : [gl.NONE]);
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
        check();
        throw new play.PlayError("This browser's WebGL2 cannot draw into these textures of floats and integers. The recorded pictures and walks work all the same.");
      }
      return places.length;
    }

    function clearTo(targets, values) {
      let place = 0;
      targets.forEach((target, i) => {
        for (let layer = 0; layer < Math.max(1, target.layers); ++layer, ++place) {
          if (target.format === "rgba32ui") gl.clearBufferuiv(gl.COLOR, place, new Uint32Array(values[i]));
          else gl.clearBufferfv(gl.COLOR, place, new Float32Array(values[i]));
        }
      });
    }

    function cover(width, height, shape, rows) {
      gl.viewport(0, 0, width, height);
      if (rows) {
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(0, rows[0], width, rows[1] - rows[0]);
      }
      gl.drawArrays(shape === "rectangle" ? gl.TRIANGLE_STRIP : gl.TRIANGLES, 0, shape === "rectangle" ? 4 : 3);
      gl.disable(gl.SCISSOR_TEST);
    }

    function draw(made, values, targets, { live = null, clear = null, rows = null, blend = null, shape = "triangle" } = {}) {
      check();
      use(made, values);
      attach(targets, live?.id);
      if (clear) clearTo(targets, clear);
      if (live) testStencil(gl.KEEP, 0);
      if (blend === "add") {
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.ONE, gl.ONE);
      }
      cover(targets[0].width, targets[0].height, shape, rows);
      gl.disable(gl.BLEND);
      gl.disable(gl.STENCIL_TEST);
      gl.stencilMask(0xff);
    }

    function clear(target, value) {
      check();
      attach([target]);
      clearTo([target], [value]);
    }

    function testStencil(whenDrawn, mask) {
      gl.enable(gl.STENCIL_TEST);
      gl.stencilFunc(gl.EQUAL, 1, 1);
      gl.stencilOp(gl.KEEP, gl.KEEP, whenDrawn);
      gl.stencilMask(mask);
    }

    function mask(width, height) {
      check();
      const id = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, id);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH24_STENCIL8, width, height);
      attach([], id);
      gl.stencilMask(0xff);
      gl.clearBufferiv(gl.STENCIL, 0, new Int32Array([1]));
      return { id, width, height };
    }

    function retire(live, made, values) {
      check();
      use(made, values);
      attach([], live.id);
      testStencil(gl.ZERO, 0xff);
      cover(live.width, live.height);
      gl.disable(gl.STENCIL_TEST);
    }

    // Lets the browser go on in between: answers come only then.
    const nextTask = () => new Promise((resolve) => {
      const channel = new MessageChannel();
      channel.port1.onmessage = () => { channel.port1.close(); resolve(); };
      channel.port2.postMessage(0);
    });
    async function until(isDone) {
      for (let tries = 0; !isDone(); ++tries) {
        if (tries < 20) await nextTask();
        else await new Promise((resolve) => setTimeout(resolve, 1));
        check();
      }
    }

    async function any(made, values, live) {
      check();
      use(made, values);
      attach([], live.id);
      testStencil(gl.KEEP, 0);
      const query = gl.createQuery();
      gl.beginQuery(gl.ANY_SAMPLES_PASSED, query);
      cover(live.width, live.height);
      gl.endQuery(gl.ANY_SAMPLES_PASSED);
      gl.disable(gl.STENCIL_TEST);
      gl.stencilMask(0xff);
      gl.flush();
      await until(() => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE));
      const drawn = gl.getQueryParameter(query, gl.QUERY_RESULT) !== 0;
      gl.deleteQuery(query);
      return drawn;
    }

    async function finished() {
      check();
      const begun = performance.now();
      const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
      await until(() => gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED);
      gl.deleteSync(fence);
      return performance.now() - begun;
    }

    function readFloats(source) {
      check();
      attach([source]);
      const numbers = new Float32Array(4 * source.width * source.height);
      gl.readPixels(0, 0, source.width, source.height, gl.RGBA, gl.FLOAT, numbers);
      return numbers;
    }

    function readIntegers(source, layer = 0) {
      check();
      attach([source]);
      gl.readBuffer(gl.COLOR_ATTACHMENT0 + layer);
      const numbers = new Uint32Array(4 * source.width * source.height);
      gl.readPixels(0, 0, source.width, source.height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, numbers);
      gl.readBuffer(gl.COLOR_ATTACHMENT0);
      return numbers;
    }

    // At which line the loops of the first such pixel ran out: {file, line}; null where none did. The pass runs once more
    // for these rows, with another end.
    function lineThatRanOut(made, values, width, height, rows) {
      const other = program(made.pass, made.parts, made.edits, play.endings.leaveLine);
      const depth = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, depth);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT32F, width, height);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      const target = { id: depth, target: gl.TEXTURE_2D, format: "rgba32f", width, height, layers: 0, generation };
      use(other, values);
      attach([], null, target);
      gl.clearBufferfv(gl.DEPTH, 0, new Float32Array([0]));
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      cover(width, height, "triangle", rows);
      gl.disable(gl.DEPTH_TEST);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, null, 0);
      const copied = texture("rgba32f", width, height);
      draw(program("copy_depth.frag"), { depths: target }, [copied]);
      const depths = readFloats(copied);
      free(target, copied);
      const first = depths.findIndex((value, i) => i % 4 === 0 && value > 0);
      return first < 0 ? null : play.lineOf(Math.round(depths[first] * 16777216), other.files);
    }

    if (!open()) {
      throw new play.PlayError("This browser has no WebGL2, or its graphics are blocked. The recorded pictures and walks work all the same; a newer browser runs the shaders.");
    }
    begin();
    return Object.assign(gpu, {
      generation: () => generation,
      program, forget, texture, buffer, free, draw, clear, mask, retire, any, finished, nextTask, readFloats, readIntegers, lineThatRanOut,
    });
  }

  Object.assign(play, { CompileError, ContextLost, openGpu });
})();
