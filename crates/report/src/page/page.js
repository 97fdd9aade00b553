"use strict";
// Draws every figure when it comes into view, and all that are not folded up before the page is printed.
(function () {
  var font = { family: "system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif", size: 12, color: "#1b1f24" };
  var config = { responsive: true, displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d", "sendDataToCloud"] };

  function axes(layout, timed) {
    Object.keys(layout).forEach(function (key) {
      if (/^[xy]axis\d*$/.test(key)) {
        Object.assign(layout[key], { linecolor: "#57606a", gridcolor: "#e8ecf0", zerolinecolor: "#c4cbd2", ticks: "outside", ticklen: 4, tickcolor: "#57606a", nticks: 7, automargin: true });
        layout[key].title.font = { size: 12 };
      }
    });
  }

  function draw(place) {
    if (place.dataset.drawn) { return; }
    place.dataset.drawn = "yes";
    var source = place.parentElement.querySelector("script[type='application/json']");
    var data = JSON.parse(source.textContent);
    data.traces.forEach(function (trace) {
      if (data.x) { trace.x = data.x[trace.x]; }
    });
    var layout = Object.assign({ font: font, paper_bgcolor: "#ffffff", plot_bgcolor: "#ffffff", hovermode: "closest", hoverlabel: { bgcolor: "#ffffff", font: font }, margin: { l: 62, r: 14, t: 46, b: 50 } }, data.layout);
    axes(layout);
    place.style.minHeight = layout.height + "px";
    window.Plotly.newPlot(place, data.traces, layout, config).then(function () { place.dataset.ready = "yes"; });
  }

  function canTurn() {
    var canvas = document.createElement("canvas");
    return Boolean(window.WebGLRenderingContext && (canvas.getContext("webgl") || canvas.getContext("experimental-webgl")));
  }

  var space = Array.from(document.querySelectorAll(".shapes"));
  if (space.length && !canTurn()) {
    space.forEach(function (figure) { figure.classList.add("no-space"); });
  }
  var plots = Array.from(document.querySelectorAll(".plot"));
  var drawable = function (place) { return !place.closest(".no-space") && !place.closest("details:not([open])"); };
  var watcher = new IntersectionObserver(function (entries) {
    entries.forEach(function (entry) {
      if (entry.isIntersecting && drawable(entry.target)) {
        watcher.unobserve(entry.target);
        draw(entry.target);
      }
    });
  }, { rootMargin: "500px" });
  plots.forEach(function (place) { watcher.observe(place); });
  window.addEventListener("beforeprint", function () {
    plots.filter(drawable).forEach(function (place) { if (!place.closest(".shapes")) { draw(place); } });
  });
})();
