// SPDX-License-Identifier: Apache-2.0
// The map of an atlas, for choosing the best plant of a kind.

function spanOf(axis, cell) {
  const format = (edge) => Number(edge.toPrecision(3));
  return `${format(axis.edges[cell])} to ${format(axis.edges[cell + 1])} ${plainUnit(axis.unit)}`.trim();
}

const wordsOf = (name) => name.replaceAll("_", " ");

function kindOf(map, plant) {
  return map.axes.map((axis, k) =>
    `${wordsOf(axis.name)} ${spanOf(axis, plant.cell[k])}`).join(", ");
}

function formatPlant(map, plant) {
  const error = halfWidth(plant.standard_error);
  const digits = digitsFor(plant.value, error);
  return `${kindOf(map, plant)}: ${wordsOf(map.goal.name)} ${plant.value.toFixed(digits)} `
    + `± ${error.toFixed(digits)} ${plainUnit(map.goal.unit)}, `
    + (plant.is_confirmed ? "confirmed" : "not confirmed");
}

// The colour of a plant between the worst and the best of the map.
function shadeOf(map, plant) {
  const worth = map.plants.map((other) => map.goal.sign * other.value);
  const [low, high] = [Math.min(...worth), Math.max(...worth)];
  const part = high > low ? (map.goal.sign * plant.value - low) / (high - low) : 1;
  return `hsl(150 45% ${92 - 66 * part}%)`;
}

function choosePlant(map, plant) {
  remember();
  change({ genome: [...plant.genome] });
  byId("map-text").textContent = formatPlant(map, plant);
}

function squareOf(map, plant) {
  const text = formatPlant(map, plant);
  plant.square = make("button", {
    type: "button", title: text, "aria-label": text,
    class: plant.is_confirmed ? null : "is-open",
    onclick: () => choosePlant(map, plant),
  });
  plant.square.style.background = shadeOf(map, plant);
  return plant.square;
}

function headOf(axis, cell, scope) {
  return make("th", { scope, title: spanOf(axis, cell) },
    String(Number(axis.edges[cell].toPrecision(3))));
}

function rowOf(map, j) {
  const [across, up] = map.axes;
  const cells = across.edges.slice(1).map((_, i) => {
    const leader = map.plants.find(({ cell }) => cell[0] === i && (!up || cell[1] === j));
    return make("td", {}, leader ? squareOf(map, leader) : null);
  });
  return make("tr", {}, up ? headOf(up, j, "row") : make("td"), ...cells);
}

function buildMap(map) {
  byId("map-card").hidden = !map;
  if (!map) return;
  const [across, up] = map.axes;
  const rows = up ? up.edges.slice(1).map((_, j) => rowOf(map, j)).reverse() : [rowOf(map, 0)];
  const format = (axis) => `${wordsOf(axis.name)} from … ${plainUnit(axis.unit)}`.trim();
  byId("map").replaceChildren(
    make("caption", {}, `across: ${format(across)}${up ? `; upwards: ${format(up)}` : ""}`),
    ...rows,
    make("tr", {}, make("td"),
      ...across.edges.slice(1).map((_, i) => headOf(across, i, "col"))));
}

when("hello", (message) => buildMap(message.map));
when("changed", () => {
  for (const plant of (page.hello && page.hello.map ? page.hello.map.plants : []))
    plant.square.setAttribute("aria-pressed",
      String(plant.genome.every((gene, i) => gene === page.shown.genome[i])));
});
