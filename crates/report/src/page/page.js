"use strict";
// Draws every figure when it comes into view, and all before the page is printed; lays its panels out for the width there is.
(function () {
  var font = { family: "system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif", size: 12, color: "#1b1f24" };
  var config = { displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d", "sendDataToCloud"] };
  var clear = "rgba(0,0,0,0)";
  // px: a panel, the least width of one with its labels, labels between panels, a panel's title, the row of buttons
  var PANEL = 204, LEAST = 220, GAP = 62, ACROSS = 70, TITLE = 20, BUTTONS = 34, LEFT = 62, RIGHT = 14, BOTTOM = 50;
  // a sheet between its margins, with room for a caption, and the least panel to bring a figure onto one
  var SHEET = { width: 680, height: 780, gap: 50 }, SMALL = 72;
  var printing = false;

  function widthOf(place) { return printing ? SHEET.width : place.clientWidth; }

  // as many columns as fit, of a number by which the rows stay rows
  function columnsIn(width, wanted) {
    var columns = wanted;
    while (columns > 1 && (wanted % columns || width / columns < LEAST)) { columns -= 1; }
    return columns;
  }

  function gapOf(titled) { return (printing ? SHEET.gap : GAP) + titled; }

  function panelOf(rows, titled, legend) {
    var others = BUTTONS + legend + titled + (rows - 1) * gapOf(titled) + BOTTOM;
    return printing ? Math.min(PANEL, Math.max(SMALL, (SHEET.height - others) / rows)) : PANEL;
  }

  function heightOf(rows, titled, legend) {
    return BUTTONS + legend + titled + rows * panelOf(rows, titled, legend) + (rows - 1) * gapOf(titled) + BOTTOM;
  }

  function wrapped(text, width) {
    var cut = text.length * 6 > width ? text.lastIndexOf(" ", width / 6) : -1;
    return cut < 1 ? text : text.slice(0, cut) + "<br>" + wrapped(text.slice(cut + 1), width);
  }

  function layoutOf(data, width, legend) {
    var panels = data.panels, columns = columnsIn(width, data.columns), rows = Math.ceil(panels.length / columns);
    var titled = panels.some(function (panel) { return panel.title; }) ? TITLE : 6;
    var timed = panels.every(function (panel) { return panel.x === "time (s)"; });
    var height = heightOf(rows, titled, legend);
    var across = width - LEFT - RIGHT, high = panelOf(rows, titled, legend), down = rows * high + (rows - 1) * gapOf(titled);
    var part = (across - (columns - 1) * ACROSS) / columns;
    var layout = {
      height: height, width: width, annotations: [],
      margin: { l: LEFT, r: RIGHT, t: BUTTONS + legend + titled, b: BOTTOM },
    };
    panels.forEach(function (panel, place) {
      var number = place ? place + 1 : "", row = Math.floor(place / columns), column = place % columns;
      var left = column * (part + ACROSS), top = row * (high + gapOf(titled));
      var axis = function (text, anchor, from, to) {
        return {
          domain: [Math.max(from, 0), Math.min(to, 1)], anchor: anchor + number, title: { text: text, standoff: 6, font: { size: 12 } },
          linecolor: "#57606a", gridcolor: "#e8ecf0", zerolinecolor: "#c4cbd2", ticks: "outside", ticklen: 4, tickcolor: "#57606a", nticks: 7, tickangle: 0,
        };
      };
      layout["xaxis" + number] = axis(panel.x, "y", left / across, (left + part) / across);
      layout["yaxis" + number] = axis(panel.y, "x", 1 - (top + high) / down, 1 - top / down);
      // zooming into the time of one panel zooms all
      if (timed && place) { layout["xaxis" + number].matches = "x"; }
      if (panel.title) {
        layout.annotations.push({ text: wrapped(panel.title, part + ACROSS / 2), xref: "paper", yref: "paper", showarrow: false, x: (left + part / 2) / across, y: 1 - top / down, yanchor: "bottom", font: { size: part < 260 ? 11 : 13 } });
      }
    });
    return layout;
  }

  function spaceOf(data, width) {
    var narrow = width < 600, scene = JSON.parse(JSON.stringify(data.layout.scene));
    ["x", "y", "z"].forEach(function (axis) {
      // of a narrow window the scene fills more, and there is room for fewer numbers
      if (narrow) {
        scene.aspectratio[axis] *= 0.72;
        scene[axis + "axis"].nticks = 3;
      }
    });
    return { height: narrow ? 330 : 520, width: width, margin: { l: 0, r: 0, t: BUTTONS, b: 0 }, scene: scene };
  }

  // Plotly is told anew what is drawn: zoom, hidden curves and the camera stay while `uirevision` does.
  function draw(place, legend) {
    var data = place.figure || (place.figure = read(place));
    var width = widthOf(place);
    var named = data.traces.filter(function (trace) { return trace.showlegend; }).length > 1;
    legend = named ? legend || 24 : 0;
    var layout = data.panels ? layoutOf(data, width, legend) : spaceOf(data, width);
    Object.assign(layout, {
      font: font, paper_bgcolor: clear, plot_bgcolor: clear, hovermode: "closest", hoverlabel: { bgcolor: "#ffffff", font: font }, uirevision: "kept", showlegend: named,
      modebar: { bgcolor: clear, color: "#8c959f", activecolor: "#1b1f24" },
      // below the buttons, above the panels
      legend: { orientation: "h", x: 0, xref: "container", y: 1 - BUTTONS / layout.height, yref: "container", yanchor: "top", bgcolor: clear },
    });
    place.style.minHeight = layout.height + "px";
    window.Plotly.react(place, data.traces, layout, config).then(function () {
      // how high the names stand is known only now
      var needed = place._fullLayout.legend && Math.ceil(place._fullLayout.legend._height);
      if (data.panels && named && Math.abs(needed - legend) > 4 && !place.again) {
        place.again = true;
        draw(place, needed);
        return;
      }
      place.again = false;
      place.dataset.ready = "yes";
    });
  }

  function read(place) {
    var data = JSON.parse(place.parentElement.querySelector("script[type='application/json']").textContent);
    data.traces.forEach(function (trace) {
      if (data.x) { trace.x = data.x[trace.x]; }
      if (data.lift_m !== undefined) {
        // upwards, and sideways for what stands upright
        trace.customdata = trace.z.map(function (z, i) { return [trace.y[i], z]; });
        ["y", "z"].forEach(function (axis) {
          trace[axis] = trace[axis].map(function (place) { return place === null ? null : place + trace.meta * data.lift_m; });
        });
      }
    });
    place.dataset.drawn = "yes";
    return data;
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
  plots.forEach(function (place) {
    var rows = Math.ceil(place.dataset.panels / columnsIn(place.clientWidth || innerWidth, +place.dataset.columns));
    place.style.minHeight = (rows ? heightOf(rows, TITLE, 24) : 520) + "px";
  });
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

  function drawAgain() {
    plots.forEach(function (place) {
      if (place.figure && place.clientWidth && place._fullLayout.width !== widthOf(place)) { draw(place); }
    });
  }
  var waiting;
  window.addEventListener("resize", function () {
    clearTimeout(waiting);
    waiting = setTimeout(drawAgain, 150);
  });

  // On paper everything is unfolded, and as wide as the sheet.
  var folded = [];
  window.addEventListener("beforeprint", function () {
    if (printing) { return; }
    printing = true;
    folded = Array.from(document.querySelectorAll("details:not([open])"));
    folded.forEach(function (details) { details.open = true; });
    plots.forEach(function (place) { if (!place.closest(".shapes")) { draw(place); } });
  });
  window.addEventListener("afterprint", function () {
    printing = false;
    folded.forEach(function (details) { details.open = false; });
    drawAgain();
  });
})();
