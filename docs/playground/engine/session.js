// One place in a page where a text is run: what is chosen, what is edited, the last good picture, the loss of the context.
//
//   const run = play.openSession(gpu, choices)
//       choices: {scene, walk, triangle, view, size}; run.choices may be changed, then ask again
//   run.lit                           {lamps, mirrors, gloss, all}: what engine/plan.js makes a plan of
//   run.edits                         {path: text}; run.edit(path, text) changes one, and forgets it where it is as it was
//   run.files()                       the files that go into the programs of these choices, the edited ones first
//   await run.go({onProgress})        one run; a run that is still going on is stopped first. The outcome is one of
//       {kind: "picture", mine, right, difference, result, stopped, milliseconds, rays, scene, plan}   right, difference: null while nothing is edited
//       {kind: "errors", errors}      [{file, line, message, words}]: the last good picture stays
//       {kind: "stopped"}             by run.stop(), or by another run
//       {kind: "lost", sentence}      the graphics context is away
//       {kind: "failed", sentence}    anything else, in words
//   run.stop()
//   run.pixel(x, y)                   {mine, right} of the last run: play.pixelOf of both; nothing where there is none
//   run.release()                     gives back all that is on the GPU
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};

  function openSession(gpu, choices) {
    const run = { choices: { ...choices }, edits: {}, lit: { lamps: true, mirrors: true, gloss: true, all: false } };
    let stopping = null;
    let last = null; // {mine, right}: results of traces
    let rightOf = null; // {key, result, picture}

    function edit(path, text) {
      if (text === play.files[path]) delete run.edits[path];
      else run.edits[path] = text;
    }

    function files() {
      const parts = play.walkParts({ ...run.choices, observer: play.observerOf(run.choices.view) });
      const traced = play.filesOf("pass/trace/resume.frag", parts, run.edits);
      const { view } = run.choices;
      const lit = play.passesOf(view);
      const shown = lit.length ? lit.flatMap((pass) => play.filesOf(pass.file, pass.parts, run.edits))
        : play.observerOf(view) !== "none" ? [] : play.filesOf("pass/show/show_hits.frag", { real: parts.real, view: play.findPart("view", view) }, run.edits);
      const rays = play.filesOf("pass/rays/compute_rays.frag", { real: parts.real }, run.edits);
      const first = [parts.structure, ...(parts.packet ? [parts.packet] : []), parts.triangle];
      return [...new Set([...first, ...traced, ...rays, ...shown])];
    }

    const isEdited = () => files().some((file) => run.edits[file] !== undefined);

    function stop() {
      stopping?.abort();
      stopping = null;
    }

    // The picture of the project's own text, kept while the choices stay.
    async function rightPicture(scene, options) {
      const { view, size, walk, triangle } = run.choices;
      const key = JSON.stringify([run.choices.scene, walk, triangle, view, size, run.lit]);
      if (rightOf?.key !== key || rightOf.result.hits.generation !== gpu.generation()) {
        forgetRight();
        const rays = play.cameraRays(gpu, scene, size);
        try {
          const result = await play.trace(gpu, scene, rays, { ...options, edits: {}, trial: false });
          rightOf = { key, result, picture: await play.viewPicture(gpu, scene, rays, result, view, { ...options, edits: {} }) };
        } finally {
          gpu.free(rays.origins, rays.directions);
        }
      }
      return rightOf;
    }

    function forgetRight() {
      play.release(gpu, rightOf?.result);
      if (last && last.right === rightOf?.result) last.right = null;
      rightOf = null;
    }

    async function go({ onProgress } = {}) {
      stop();
      const own = stopping = new AbortController();
      const { view, size, walk, triangle } = run.choices;
      const edits = { ...run.edits };
      const begun = performance.now();
      let rays = null;
      let mine = null;
      try {
        const scene = play.changedScene(await play.openScene(run.choices.scene), run.lit);
        const options = {
          walk, triangle, observer: play.observerOf(view), edits, signal: own.signal, onProgress, plan: play.planOf(view, scene, run.lit.all),
        };
        rays = play.cameraRays(gpu, scene, size, edits);
        mine = await play.trace(gpu, scene, rays, options);
        const right = isEdited() ? await rightPicture(scene, options) : null;
        const picture = await play.viewPicture(gpu, scene, rays, mine, view, { ...options, upper: right?.picture.legend?.upper });
        const difference = right ? play.differencePicture(gpu, mine, right.result, [picture.linear, right.picture.linear]) : null;
        if (own.signal.aborted) throw new play.Stopped("Stopped.");
        play.release(gpu, last?.mine);
        last = { mine, right: right?.result ?? null };
        const result = mine;
        mine = null;
        return {
          kind: "picture", mine: picture, right: right?.picture ?? null, difference, result, stopped: result.stopped ?? picture.stopped,
          milliseconds: options.plan ? performance.now() - begun : result.milliseconds, rays: size * size, scene, plan: options.plan,
        };
      } catch (error) {
        if (error instanceof play.CompileError) return { kind: "errors", errors: error.errors };
        if (error instanceof play.Stopped) return { kind: "stopped" };
        if (error instanceof play.ContextLost) return { kind: "lost", sentence: error.message };
        if (error instanceof play.PlayError) return { kind: "failed", sentence: error.message };
        console.error(error);
        return { kind: "failed", sentence: `The page itself has a fault (${error.message}). Your text is kept: reload the page, and report the fault.` };
      } finally {
        if (rays) gpu.free(rays.origins, rays.directions);
        play.release(gpu, mine);
        if (stopping === own) stopping = null;
      }
    }

    function pixel(x, y) {
      return last && last.mine.hits.generation === gpu.generation() && {
        mine: play.pixelOf(gpu, last.mine, x, y), right: last.right ? play.pixelOf(gpu, last.right, x, y) : null,
      };
    }

    function release() {
      stop();
      play.release(gpu, last?.mine);
      last = null;
      forgetRight();
    }

    return Object.assign(run, { edit, files, isEdited, go, stop, pixel, release });
  }

  Object.assign(play, { openSession });
})();
