// Sets the formulas of a page, which arithmatex has marked as \(...\) and \[...\].
document.querySelectorAll(".arithmatex").forEach((element) => {
  const text = element.textContent.trim();
  const isBlock = text.startsWith("\\[");
  katex.render(text.slice(2, -2), element, { displayMode: isBlock, throwOnError: true });
});
