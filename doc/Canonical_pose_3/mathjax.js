MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false,
  menuSettings: { inTabOrder: false },
  SVG: { scale: 88, linebreaks: { automatic: true } }
});
