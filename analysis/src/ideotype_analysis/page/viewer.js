// Draws plants face by face, far ones first, on a plain canvas: it needs no
// graphics driver and works wherever the page opens.
"use strict";
(function () {
  const source = document.getElementById("scene");
  if (!source) return;
  const scene = JSON.parse(source.textContent);
  const canvas = document.getElementById("view");
  const context = canvas.getContext("2d");
  const caseList = document.getElementById("view-case");
  const quantityList = document.getElementById("view-quantity");
  const start = { turn: 0.6, tilt: 0.25, zoom: 1 };
  const view = { ...start };
  // viridis, as in all other figures
  const stops = [
    [68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142],
    [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89],
    [180, 222, 44], [253, 231, 37],
  ];
  const stalk = [150, 150, 150];

  function colorAt(part) {
    const x = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
    const i = Math.min(Math.floor(x), stops.length - 2);
    return stops[i].map((c, k) => c + (x - i) * (stops[i + 1][k] - c));
  }

  function fill(list, labels) {
    list.replaceChildren(
      ...labels.map((label, i) => new Option(label, String(i))));
  }

  // Of the values of both plants, so that their colours compare.
  function rangeOf(quantity) {
    const all = quantity.values.flat().filter((v) => v !== null);
    return all.length ? [Math.min(...all), Math.max(...all)] : [0, 1];
  }

  // Screen places and depth; the middle of the plant's height stays put.
  function project(plant, height) {
    const [c, s] = [Math.cos(view.turn), Math.sin(view.turn)];
    const [ct, st] = [Math.cos(view.tilt), Math.sin(view.tilt)];
    return plant.vertices.map(([x, y, z]) => {
      const right = c * x - s * y;
      const away = s * x + c * y;
      const up = z - height / 2;
      return [right, ct * up + st * away, ct * away - st * up];
    });
  }

  function shade(points) {
    const [a, b, c] = points;
    const u = b.map((v, i) => v - a[i]);
    const w = c.map((v, i) => v - a[i]);
    const n = [
      u[1] * w[2] - u[2] * w[1],
      u[2] * w[0] - u[0] * w[2],
      u[0] * w[1] - u[1] * w[0],
    ];
    const length = Math.hypot(...n) || 1;
    return 0.78 + 0.22 * Math.abs(n[2]) / length;
  }

  function drawPlant(plant, values, range, height, center, scale) {
    const points = project(plant, height);
    const faces = plant.faces.map((face, i) => {
      const corners = face.map((v) => points[v]);
      const depth = corners.reduce((sum, p) => sum + p[2], 0) / face.length;
      return { corners, depth, group: plant.group[i] };
    });
    faces.sort((a, b) => b.depth - a.depth);
    for (const { corners, group } of faces) {
      const value = values[group];
      const spread = range[1] - range[0] || 1;
      const base =
        value === null ? stalk : colorAt((value - range[0]) / spread);
      const light = shade(corners);
      const color = `rgb(${base.map((c) => Math.round(c * light)).join()})`;
      context.beginPath();
      for (const [x, y] of corners)
        context.lineTo(center[0] + scale * x, center[1] - scale * y);
      context.closePath();
      context.fillStyle = context.strokeStyle = color;
      context.fill();
      context.stroke();  // closes the seams between faces
    }
    return faces.length;
  }

  function drawScale(range, width, height) {
    const [x, y, w, h] = [width / 2 - 120, height - 34, 240, 12];
    for (let i = 0; i < w; ++i) {
      context.fillStyle = `rgb(${colorAt(i / w).map(Math.round).join()})`;
      context.fillRect(x + i, y, 1.5, h);
    }
    context.fillStyle = "#000";
    context.font = "13px sans-serif";
    context.textAlign = "right";
    context.fillText(range[0].toPrecision(3), x - 6, y + h - 1);
    context.textAlign = "left";
    context.fillText(range[1].toPrecision(3), x + w + 6, y + h - 1);
  }

  function draw() {
    const dense = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    canvas.width = width * dense;
    canvas.height = height * dense;
    context.setTransform(dense, 0, 0, dense, 0, 0);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, width, height);
    context.lineWidth = 0.6;
    const chosen = scene.cases[caseList.selectedIndex];
    const quantity = chosen.quantities[quantityList.selectedIndex];
    const range = rangeOf(quantity);
    const all = chosen.plants.flatMap((plant) => plant.vertices);
    const tall = Math.max(...all.map((v) => v[2]));
    const wide = 2 * Math.max(...all.map((v) => Math.hypot(v[0], v[1])));
    const scale = view.zoom * Math.min(
      (height - 90) / tall, width / chosen.plants.length / wide);
    let faces = 0;
    chosen.plants.forEach((plant, i) => {
      const x = width * (i + 0.5) / chosen.plants.length;
      faces += drawPlant(
        plant, quantity.values[i], range, tall, [x, height / 2 - 8], scale);
      context.fillStyle = "#000";
      context.font = "14px sans-serif";
      context.textAlign = "center";
      context.fillText(plant.title, x, 20);
    });
    drawScale(range, width, height);
    canvas.dataset.faces = faces;
  }

  function chooseCase() {
    const { quantities } = scene.cases[caseList.selectedIndex];
    const kept = Math.max(quantityList.selectedIndex, 0);
    fill(quantityList, quantities.map((q) => q.label));
    quantityList.selectedIndex = Math.min(kept, quantities.length - 1);
    draw();
  }

  function turnBy(right, up) {
    view.turn += right;
    view.tilt = Math.min(Math.max(view.tilt + up, -0.2), Math.PI / 2);
    draw();
  }

  function zoomBy(factor) {
    view.zoom = Math.min(Math.max(view.zoom * factor, 0.3), 10);
    draw();
  }

  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons & 1)
      turnBy(-event.movementX / 120, event.movementY / 120);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 500));
  }, { passive: false });
  const keys = {
    ArrowLeft: () => turnBy(0.1, 0), ArrowRight: () => turnBy(-0.1, 0),
    ArrowUp: () => turnBy(0, 0.1), ArrowDown: () => turnBy(0, -0.1),
    "+": () => zoomBy(1.1), "-": () => zoomBy(1 / 1.1),
    Home: () => { Object.assign(view, start); draw(); },
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in keys)) return;
    event.preventDefault();
    keys[event.key]();
  });
  caseList.addEventListener("change", chooseCase);
  quantityList.addEventListener("change", draw);
  window.addEventListener("resize", draw);
  fill(caseList, scene.cases.map((each) => each.name));
  chooseCase();
})();
