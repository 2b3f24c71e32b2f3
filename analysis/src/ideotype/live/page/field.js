// SPDX-License-Identifier: Apache-2.0
// The plants in their field; leaf colour shows absorbed PAR or assimilation.

const AT_FIRST = { turn: 0.75, tilt: 0.2, zoom: 1.25 };
const field = {
  view: { ...AT_FIRST },
  plants: [], message: null, numbers: null, tall: 0, wide: 0, key: "",
};
const PANEL = [58, 74, 98];

function leafValues(plant, curves, name, isPerArea) {
  const curve = curves?.[name];
  const ground = field.message.ground;
  return plant.groups.map((group, i) => {
    const match = /^leaf(\d+)$/.exec(group);
    if (!match || !curve || page.shown.component) return null;
    const value = curve.values[Number(match[1]) - 1];
    if (value === undefined || value === null) return null;
    return isPerArea ? value * ground / (plant.areas[i] || Infinity) : value;
  });
}

function quantityShown() {
  const [name, per] = byId("color").value.split(" ");
  const { numbers, plants } = field;
  return {
    name,
    isPerArea: per === "area",
    values: [numbers?.reference_curves || numbers?.curves, numbers?.curves]
      .map((curves, i) => leafValues(plants[i], curves, name, per === "area")),
  };
}

let isDrawing = false;
function drawField() {
  if (isDrawing || !field.message) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    paintField();
  });
}

function paintField() {
  const { message, plants, view } = field;
  const isPair = byId("pair").checked;
  const sides = isPair ? [0, 1] : [1];
  const quantity = quantityShown();
  const stand = {
    plants, row_direction: message.direction, paler: 0.3,
    neighbours: message.neighbours, tall: field.tall, wide: field.wide,
    objects: message.panels.map((corners) => [corners, PANEL]),
  };
  const shown = sides.map((i) =>
    ({ stand, plant: plants[i], values: quantity.values[i] }));
  const drawn = drawScene(byId("view"), shown, isPair ? { ...view, zoom: view.zoom / AT_FIRST.zoom } : view, byId("neighbours").checked);
  Object.assign(byId("view").dataset, drawn);
  const other = page.shown.reference ? "reference plant" : "initial plant";
  const date = message.date ? `, ${message.date}` : "";
  byId("titles").replaceChildren(...sides.map((i) =>
    make("span", { class: i ? "mine" : "other" }, (i ? "this plant" : other) + date)));
  showKey(quantity, shown);
}

function showKey(quantity, shown) {
  const [low, high] = rangeOf(shown);
  const unit = plainUnit(field.numbers?.curves[quantity.name]?.unit || "");
  byId("key").hidden = !unit || Boolean(page.shown.component);
  byId("low").textContent = low.toPrecision(2);
  byId("high").textContent = high.toPrecision(2);
  byId("key-unit").textContent = unit + (quantity.isPerArea ? " of leaf" : " of ground");
}

when("picture", (message) => {
  field.message = message;
  field.plants = [message.plants[1], message.plants[0]].map(unpackPlant);
  const { conditions, component } = page.shown;
  const key = [conditions.age, conditions.panels, component].join();
  // The view does not jump while a slider moves.
  if (key !== field.key) [field.tall, field.wide, field.key] = [0, 0, key];
  const top = message.panels.length ? conditions.panel_height : 0;
  field.tall = Math.max(field.tall, top, ...field.plants.map((p) => p.tall));
  field.wide = Math.max(field.wide, ...field.plants.map((p) => p.wide));
  drawField();
});
when("numbers", (message) => {
  field.numbers = message;
  drawField();
});

function look(part) {
  Object.assign(field.view, part);
  field.view.tilt = Math.min(Math.max(field.view.tilt, 0), Math.PI / 2);
  field.view.zoom = Math.min(Math.max(field.view.zoom, 0.3), 10);
  drawField();
}
const turn = (right, up) => look({
  turn: field.view.turn + right, tilt: field.view.tilt + up,
});
const zoom = (factor) => look({ zoom: field.view.zoom * factor });
const LOOKS = {
  ArrowLeft: () => turn(0.1, 0), ArrowRight: () => turn(-0.1, 0),
  ArrowUp: () => turn(0, 0.1), ArrowDown: () => turn(0, -0.1),
  "+": () => zoom(1.15), "-": () => zoom(1 / 1.15),
  Home: () => look(AT_FIRST),
  above: () => look({ turn: 0, tilt: Math.PI / 2, zoom: 1 }),
};

function listenToView() {
  const canvas = byId("view");
  const pointers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (event.pointerType === "mouse") canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const gap = () => {
      const [[ax, ay], [bx, by]] = pointers.values();
      return Math.hypot(ax - bx, ay - by);
    };
    const wide = pointers.size === 2 ? gap() : 0;
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (wide) zoom(gap() / wide);
    else turn((before[0] - event.clientX) / 120, (event.clientY - before[1]) / 120);
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"])
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 600));
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in LOOKS)) return;
    event.preventDefault();
    LOOKS[event.key]();
  });
  for (const button of document.querySelectorAll("[data-look]"))
    button.addEventListener("click", () => LOOKS[button.dataset.look]());
  for (const id of ["pair", "neighbours"])
    byId(id).addEventListener("change", drawField);
  byId("color").addEventListener("change", () => {
    drawField();
    if (field.numbers) showCharts(field.numbers);
  });
  new ResizeObserver(drawField).observe(canvas);
  const ramp = STOPS.map((color) => `rgb(${color.join()})`).join();
  byId("ramp").style.background = `linear-gradient(to right, ${ramp})`;
}
