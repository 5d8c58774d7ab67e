// A text area with line numbers. What takes its place has the same four functions.
//
//   const editor = play.openEditor(parent, {label, onChange, onRun})   onChange(text) at each key, onRun by Ctrl-Enter
//   editor.text(), editor.setText(text), editor.mark([line, ...]), editor.goTo(line)
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};

  function openEditor(parent, { label, onChange, onRun }) {
    const numbers = document.createElement("ol");
    numbers.className = "numbers";
    numbers.ariaHidden = "true";
    const area = document.createElement("textarea");
    Object.assign(area, { spellcheck: false, wrap: "off", ariaLabel: label });
    for (const name of ["autocapitalize", "autocomplete", "autocorrect"]) area.setAttribute(name, "off");
    parent.classList.add("editor");
    parent.append(numbers, area);
    let marked = new Set();

    function number() {
      const count = area.value.split("\n").length;
      while (numbers.childElementCount > count) numbers.lastChild.remove();
      while (numbers.childElementCount < count) numbers.append(document.createElement("li"));
      [...numbers.children].forEach((line, index) => line.classList.toggle("marked", marked.has(index + 1)));
    }
    const follow = () => { numbers.scrollTop = area.scrollTop; };

    area.addEventListener("scroll", follow);
    area.addEventListener("input", () => { number(); onChange(area.value); });
    area.addEventListener("keydown", (event) => {
      event.stopPropagation(); // the site's own keys are letters
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
        event.preventDefault();
        onRun();
      }
    });

    return {
      text: () => area.value,
      setText(text) {
        if (area.value === text) return;
        area.value = text;
        area.scrollTop = 0;
        marked = new Set();
        number();
        follow();
      },
      mark(lines) {
        marked = new Set(lines);
        number();
      },
      goTo(line) {
        const lines = area.value.split("\n");
        const start = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
        area.focus();
        area.setSelectionRange(start, start + (lines[line - 1] ?? "").length);
        area.scrollTop = Math.max(0, (line - 4) * area.scrollHeight / lines.length);
        follow();
      },
    };
  }

  Object.assign(play, { openEditor });
})();
