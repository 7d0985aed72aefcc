// Sets the equations that Sphinx marks with the delimiters of MathJax.
for (const element of document.querySelectorAll(".math")) {
  renderMathInElement(element, {
    delimiters: [
      {left: "\\[", right: "\\]", display: true},
      {left: "\\(", right: "\\)", display: false},
    ],
    throwOnError: false,
  });
}
