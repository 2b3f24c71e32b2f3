// SPDX-License-Identifier: Apache-2.0
// One picture of the scene: plants side by side on their ground, with a
// compass and a scale. Parallel projection, so that the scale holds
// everywhere.

// viridis, as in all other figures
const STOPS = [
  [68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142],
  [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89],
  [180, 222, 44], [253, 231, 37],
];
const GROUND = [240, 233, 222];
const MARK = [120, 100, 75];
// Towards the viewer's upper left; across, up, away.
const LIGHT = [-0.32, 0.64, -0.7];
const START = { turn: 0.6, tilt: 0.25, zoom: 1 };

function colorAt(part) {
  const x = Math.min(Math.max(part, 0), 1) * (STOPS.length - 1);
  const i = Math.min(Math.floor(x), STOPS.length - 2);
  return STOPS[i].map((c, k) => c + (x - i) * (STOPS[i + 1][k] - c));
}

// The least and the largest value of the plants shown, so that their colours
// compare.
function rangeOf(shown) {
  const all = shown.flatMap(({ values }) => values)
    .filter((v) => v !== null);
  return all.length ? [Math.min(...all), Math.max(...all)] : [0, 1];
}

function mix(color, other, part) {
  return color.map((c, k) => Math.round(c + part * (other[k] - c)));
}

// Seen from a side and a height: turns [x, y, z] into [across, up, away].
function camera(view) {
  const [c, s] = [Math.cos(view.turn), Math.sin(view.turn)];
  const [ct, st] = [Math.cos(view.tilt), Math.sin(view.tilt)];
  return ([x, y, z]) => {
    const away = s * x + c * y;
    return [c * x - s * y, ct * z + st * away, ct * away - st * z];
  };
}

// Both sides of a face have the same brightness.
function shade([a, b, c]) {
  const u = b.map((v, i) => v - a[i]);
  const w = c.map((v, i) => v - a[i]);
  const n = [
    u[1] * w[2] - u[2] * w[1],
    u[2] * w[0] - u[0] * w[2],
    u[0] * w[1] - u[1] * w[0],
  ];
  const cosine = n.reduce((sum, v, i) => sum + v * LIGHT[i], 0);
  return 0.72 + 0.28 * Math.abs(cosine) / (Math.hypot(...n) || 1);
}

// Gives plants their shared shapes and their vertices.
function unpack(scene) {
  for (const plant of scene.cases.flatMap((item) => item.plants))
    unpackPlant(Object.assign(plant, scene.shapes[plant.shape]));
}

// Unpacks the vertices of a plant [m].
function unpackPlant(plant) {
  plant.vertices = [];
  const bytes = Uint8Array.from(atob(plant.points), (c) => c.charCodeAt(0));
  const steps = [...new Int16Array(bytes.buffer)];
  for (let i = 0; i < steps.length; i += 3)
    plant.vertices.push(steps.slice(i, i + 3).map((x) => x * plant.step));
  const largest = (size) => Math.max(...plant.vertices.map(size));
  plant.tall = largest((v) => v[2]);
  plant.wide = largest((v) => Math.hypot(v[0], v[1]));
  return plant;
}

// Scale and size of plants side by side, the same for all of their cases:
// `reach` is the ground's radius [m]. A case may ask for room for plants that
// are so `tall` and `wide` [m].
function frame(shown, places, width, height) {
  const count = shown.length;
  const largest = (size) => Math.max(
    ...shown.flatMap(({ stand }) => [stand, ...stand.plants].map((x) => x[size] || 0)));
  const [tall, wide] = [largest("tall"), largest("wide")];
  const far = Math.max(...places.map((p) => Math.hypot(...p)));
  const reach = far + Math.max(wide, 0.3);
  const [c, s] = [Math.cos(START.tilt), Math.sin(START.tilt)];
  // with room for labels around the ground, from above too
  const fit = Math.min(
    (height - 50) / (c * tall + 2 * s * reach), (height - 20) / 2.3 / reach,
    0.43 * width / count / reach);
  return { tall, reach, fit };
}

// The ground is a disc with the rows and an arrow to north, as flat faces.
function groundOf(reach, direction, places) {
  const at = (angle, radius, z) =>
    [radius * Math.sin(angle), radius * Math.cos(angle), z];
  const around = Array.from({ length: 48 }, (_, i) => i * Math.PI / 24);
  const faces = [
    [around.map((angle) => at(angle, reach, -0.004)), GROUND],
  ];
  for (const x of new Set(places.map((place) => place[0]))) {
    const [y, half] = [Math.sqrt(reach * reach - x * x), 0.008];
    faces.push([[[x - half, -y, 0], [x + half, -y, 0],
      [x + half, y, 0], [x - half, y, 0]], MARK]);
  }
  const labels = [];
  if (direction !== null) {
    const north = -direction * Math.PI / 180;
    const [length, half] = [0.22 * reach, 0.1];
    faces.push([[
      at(north, reach, 0), at(north + half, reach - length, 0),
      at(north, reach - 0.7 * length, 0),
      at(north - half, reach - length, 0),
    ], [0, 0, 0]]);
    labels.push(["N", at(north, 1.1 * reach, 0)]);
  }
  // at the end of the row that is farther from north
  const end = direction !== null && Math.cos(direction * Math.PI / 180) > 0.7;
  labels.push(["row", at(end ? Math.PI : 0, 1.1 * reach, 0)]);
  return { faces, labels };
}

function drawLabel(context, text, x, y) {
  context.lineWidth = 3;
  context.strokeStyle = "#fff";
  context.strokeText(text, x, y);
  context.fillStyle = "#000";
  context.fillText(text, x, y);
}

function drawScale(context, scale, width, height) {
  const metres = [1, 0.5, 0.2, 0.1, 0.05]
    .find((m) => m * scale < 0.45 * width) || 0.02;
  const [x, y, end] = [12, height - 10, 12 + metres * scale];
  context.beginPath();
  for (const [a, b] of [[x, y - 5], [x, y], [end, y], [end, y - 5]])
    context.lineTo(a, b);
  context.lineWidth = 1.5;
  context.strokeStyle = "#000";
  context.stroke();
  drawLabel(context, `${metres} m`, (x + end) / 2, y - 8);
  return metres;
}

// The plant, and its neighbours in colours that are paler by a part, at
// `shifts` on the screen.
function paintPlant(raster, plant, colors, at) {
  const { seen, points, shifts, columns, paler } = at;
  plant.faces.forEach((face, i) => {
    const light = shade(face.map((v) => seen[v]));
    const shaded = mix([0, 0, 0], colors[plant.group[i]], light);
    const pale = mix(shaded, [255, 255, 255], paler);
    const corners = face.map((v) => points[v]);
    shifts.forEach((shift, k) =>
      raster.fill(corners, shift, k ? pale : shaded, columns));
  });
}

let last = null;

// An empty raster as large as the canvas; that of the last picture if it fits.
function rasterOf(canvas, width, height) {
  if (last === null || last.width !== width || last.height !== height) {
    [canvas.width, canvas.height] = [width, height];
    last = new Raster(width, height);
  }
  last.clear();
  return last;
}

// Draws plants next to each other, each with its stand, which may have `objects`
// and say how `paler` neighbours are, and the values of its groups. Returns how
// many of their faces were drawn, the pixels of a metre, and the length of the
// scale. A canvas without a size, as while it is hidden, stays as it is.
function drawScene(canvas, shown, view, hasNeighbours) {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (!width || !height) return { faces: 0, scale: 0, metres: 0 };
  // two pixels a point have smooth edges; too many are slow to turn
  const dense = Math.min(
    Math.max(window.devicePixelRatio || 1, 2),
    Math.sqrt(3e6 / (width * height)));
  const raster = rasterOf(
    canvas, Math.round(width * dense), Math.round(height * dense));
  // kept in memory, where the raster is too
  const context = canvas.getContext("2d", { willReadFrequently: true });
  const placesOf = ({ neighbours }) =>
    [[0, 0], ...(hasNeighbours ? neighbours : [])];
  const positions = shown.flatMap(({ stand }) => placesOf(stand));
  const { tall, reach, fit } = frame(shown, positions, width, height);
  const scale = fit * view.zoom;
  const look = camera(view);
  const panel = width / shown.length;
  const [s, c] = [Math.sin(view.tilt), Math.cos(view.tilt)];
  const middle = c * tall / 2 - s * c * reach / 2;
  const [low, high] = rangeOf(shown);
  const labels = [];
  let faces = 0;
  shown.forEach(({ stand, plant, values }, index) => {
    const places = placesOf(stand);
    const ground = groundOf(reach, stand.row_direction, places);
    faces += plant.faces.length * places.length;
    const onScreen = (point) => {
      const [across, up, away] = look(point);
      return [
        dense * (panel * (index + 0.5) + scale * across),
        dense * (height / 2 - scale * (up - middle)), away];
    };
    const columns = [index, index + 1]
      .map((i) => Math.round(i * panel * dense));
    for (const [corners, color] of [...ground.faces, ...(stand.objects || [])])
      raster.fill(corners.map(onScreen), [0, 0, 0], color, columns);
    const origin = onScreen([0, 0, 0]);
    const colors = values.map((value, i) => value === null
      ? plant.colors[i] : colorAt((value - low) / (high - low || 1)));
    paintPlant(raster, plant, colors, {
      seen: plant.vertices.map(look),
      points: plant.vertices.map(onScreen),
      shifts: places.map(([x, y]) =>
        onScreen([x, y, 0]).map((v, k) => v - origin[k])),
      columns, paler: stand.paler ?? 0.6,
    });
    for (const [text, at] of ground.labels) {
      const [x, y] = onScreen(at);
      // not over the other plant when zoomed
      if (x > columns[0] && x < columns[1])
        labels.push([text, x / dense, y / dense + 4]);
    }
  });
  context.putImageData(raster.image, 0, 0);
  context.setTransform(dense, 0, 0, dense, 0, 0);
  context.font = "13px system-ui, sans-serif";
  context.textAlign = "center";
  for (const label of labels) drawLabel(context, ...label);
  const metres = drawScale(context, scale, panel, height);
  return { faces, scale, metres };
}
