// What every page does: paper is light, and a word's meaning opens under a finger before its link is followed.
"use strict";

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
