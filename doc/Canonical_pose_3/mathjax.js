MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false,
  menuSettings: { inTabOrder: false },
  SVG: { linebreaks: { automatic: true } }
});
