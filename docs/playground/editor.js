// The editor: CodeMirror where the page has it (the book does: scripts/book/editor_library.py), else a text area with line numbers.
//
//   const editor = play.openEditor(parent, {label, onChange, onRun})   onChange(text) at each key, onRun by Ctrl-Enter
//   editor.text(), editor.setText(text), editor.mark([line, ...]), editor.goTo(line)
"use strict";

(() => {
  const play = (globalThis.Raysteps ??= {}).play ??= {};

  function openTextArea(parent, { label, onChange, onRun }) {
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

  // In a shadow root, so that its styles are sheets, which a page may add whatever its Content-Security-Policy says of styles.
  function openCodeMirror(parent, { label, onChange, onRun }) {
    const { state: { StateEffect, StateField, Prec }, view, commands, language, mode } = play.codeMirror;
    const { EditorView, Decoration, keymap } = view;
    const setMarked = StateEffect.define();
    const markedLine = Decoration.line({ class: "marked" });
    const marks = StateField.define({
      create: () => Decoration.none,
      update(lines, { effects, changes, state }) {
        const found = effects.find((effect) => effect.is(setMarked));
        if (!found) return lines.map(changes);
        const inside = [...new Set(found.value)].filter((line) => line >= 1 && line <= state.doc.lines).sort((a, b) => a - b);
        return Decoration.set(inside.map((line) => markedLine.range(state.doc.line(line).from)));
      },
      provide: (field) => EditorView.decorations.from(field),
    });
    parent.classList.add("editor");
    const root = parent.attachShadow({ mode: "open" });
    let isSilent = false;
    const editor = new EditorView({
      parent: root, root,
      extensions: [
        Prec.highest(keymap.of([{ key: "Mod-Enter", run: () => { onRun(); return true; } }])),
        view.lineNumbers(), view.gutters({ fixed: false }), view.drawSelection(), view.highlightActiveLine(), commands.history(), language.bracketMatching(),
        keymap.of([...commands.defaultKeymap, ...commands.historyKeymap]), // Tab leaves the editor, as everywhere in a page
        language.StreamLanguage.define(mode.shader), language.syntaxHighlighting(colors()), marks,
        EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false", autocapitalize: "off" }),
        EditorView.updateListener.of((update) => { if (update.docChanged && !isSilent) onChange(update.state.doc.toString()); }),
        EditorView.theme({
          "&": { height: "100%", color: "inherit", backgroundColor: "transparent" },
          ".cm-scroller": { font: "13px/1.5 ui-monospace, monospace" },
          ".cm-gutters": { color: "inherit", backgroundColor: "transparent", border: "0", opacity: "0.75" },
          ".cm-content": { caretColor: "currentColor" },
          ".cm-cursor": { borderLeftColor: "currentColor" },
          "&.cm-focused": { outline: "2px solid var(--accent, #b3470b)" },
          ".cm-activeLine": { backgroundColor: "color-mix(in srgb, currentColor 6%, transparent)" },
          "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "color-mix(in srgb, #b3470b 35%, transparent)" },
          ".marked": { backgroundColor: "color-mix(in srgb, #b3470b 35%, transparent)" },
        }),
      ],
    });
    Object.assign(editor.dom.style, { flex: "1", minWidth: "0" });
    editor.dom.addEventListener("keydown", (event) => event.stopPropagation()); // the site's own keys are letters

    function colors() {
      const { tags } = play.codeMirror.highlight;
      const shade = (light, dark) => `light-dark(${light}, ${dark})`;
      return language.HighlightStyle.define([
        { tag: tags.comment, color: shade("#57606a", "#a4acb4"), fontStyle: "italic" },
        { tag: [tags.keyword, tags.meta, tags.processingInstruction], color: shade("#8a2be2", "#c9a2ff") },
        { tag: [tags.typeName, tags.standard(tags.variableName)], color: shade("#0550ae", "#79b8ff") },
        { tag: [tags.number, tags.atom, tags.bool], color: shade("#1a7f4b", "#58c98c") },
      ]);
    }

    return {
      text: () => editor.state.doc.toString(),
      setText(text) {
        if (editor.state.doc.toString() === text) return;
        isSilent = true;
        editor.dispatch({ changes: { from: 0, to: editor.state.doc.length, insert: text }, effects: setMarked.of([]) });
        isSilent = false;
        editor.scrollDOM.scrollTop = 0;
      },
      mark(lines) {
        editor.dispatch({ effects: setMarked.of(lines) });
      },
      goTo(line) {
        const { from, to } = editor.state.doc.line(Math.max(1, Math.min(line, editor.state.doc.lines)));
        editor.focus();
        editor.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
      },
    };
  }

  const openEditor = (parent, options) => (play.codeMirror ? openCodeMirror : openTextArea)(parent, options);

  Object.assign(play, { openEditor });
})();
