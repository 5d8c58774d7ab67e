// What every page does: it is dark where the system wishes it, until the reader turns the switch; paper is light; and
// a word's meaning opens under a finger before its link is followed.
"use strict";

// theme/main.html forgets what the theme keeps, unless the reader has chosen it.
const schemes = "[data-md-component=palette]";
const chosen = "raysteps.scheme is chosen";
document.querySelectorAll(`${schemes} label`).forEach((label) => label.addEventListener("click", () => {
  localStorage.setItem(chosen, "yes");
}));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ({ matches }) => {
  if (localStorage.getItem(chosen)) return;
  document.querySelector(`${schemes} input[data-md-color-media*=${matches ? "dark" : "light"}]`)?.click();
});

let schemeOnScreen = null;
addEventListener("beforeprint", () => {
  schemeOnScreen = document.body.dataset.mdColorScheme;
  document.body.dataset.mdColorScheme = "default";
});
addEventListener("afterprint", () => { document.body.dataset.mdColorScheme = schemeOnScreen; });

let lastPointer = "mouse";
addEventListener("pointerdown", (event) => { lastPointer = event.pointerType; }, { capture: true });
document.querySelectorAll("a.word").forEach((word) => word.addEventListener("click", (event) => {
  if (lastPointer === "mouse" || word.classList.contains("open")) return;
  event.preventDefault();
  document.querySelectorAll("a.word.open").forEach((other) => other.classList.remove("open"));
  word.classList.add("open");
}));
