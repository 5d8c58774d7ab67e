// Exercises and the playground in a page, loaded only when they come near: <div data-play="6.2"></div>, and
// <div data-play="#scene=mirrors&view=shaded"></div> with the hash of a link. The page of the exercises asks at once.
//
//   await Raysteps.play.loadAll()     all that an exercise needs, in order
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};
  const here = document.currentScript.src;
  const near = "600px"; // below the screen
  const scripts = ["engine/reader.js", "engine/scene.js", "engine/renderer.js", "engine/tracer.js", "engine/probe.js", "engine/plan.js", "engine/shading.js", "engine/picture.js", "engine/session.js",
    "engine/sentences.js", "engine/exercises.js", "data/shaders.js", "data/exercises.js", "data/scenes.js", "editor.js", "workbook.js", "exercise.js"];
  let loading = null;

  function loadAll() {
    loading ??= Promise.all(scripts.map((name) => new Promise((resolve, reject) => {
      const script = Object.assign(document.createElement("script"), { src: new URL(name, here), async: false, onload: resolve });
      script.onerror = () => reject(new Error(`${name} could not be loaded. Is the folder of the playground whole?`));
      document.head.append(script);
    }))).then(() => play.openShaders());
    return loading;
  }

  // The whole page, as high as it says.
  function frame(place) {
    const inside = Object.assign(document.createElement("iframe"), { src: new URL(`index.html${place.dataset.play}`, here), title: "The playground" });
    addEventListener("message", ({ source, data }) => {
      if (source === inside.contentWindow && Number.isFinite(data?.playgroundHeight)) inside.style.height = `${Math.ceil(data.playgroundHeight)}px`;
    });
    place.append(inside);
    place.dataset.state = "shown";
  }

  async function open(place) {
    if (place.dataset.play.startsWith("#")) {
      frame(place);
      return;
    }
    place.dataset.state = "loading";
    try {
      await loadAll();
      await play.showExercise(place, place.dataset.play, { heading: "h4" });
      place.dataset.state = "shown";
    } catch (error) {
      place.dataset.state = "failed"; // the link to the page of the exercises stays
      place.append(error.message);
    }
  }

  play.loadAll = loadAll;
  addEventListener("DOMContentLoaded", () => {
    const places = document.querySelectorAll("[data-play]");
    if (!places.length) return;
    document.head.append(Object.assign(document.createElement("link"), { rel: "stylesheet", href: new URL("exercise.css", here) }));
    const observer = new IntersectionObserver((seen) => seen.filter(({ isIntersecting }) => isIntersecting).forEach(({ target }) => {
      observer.unobserve(target);
      open(target);
    }), { rootMargin: `0px 0px ${near} 0px` });
    places.forEach((place) => observer.observe(place));
  });
})();
