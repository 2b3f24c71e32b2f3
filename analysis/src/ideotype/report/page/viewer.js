// SPDX-License-Identifier: Apache-2.0
// Choices, mouse, fingers and keys of the 3D view.
const scene = JSON.parse(document.getElementById("scene").textContent);
unpack(scene);
const part = (name) => document.getElementById(`view${name}`);
const canvas = part("");
const quantityList = part("-quantity");
const sides = [part("-left"), part("-right")];
const pairList = part("-pair");
const neighbours = part("-neighbours");
const view = { ...START };
let member = 0;
const chart = new Chart(part("-chart"), (i) => {
  member = i;
  chooseMember();
  drawAll();
});

// The case and the plant of it that a list chooses.
const entries = scene.cases.flatMap((item, i) =>
  item.plants.map((plant, k) => ({ stand: item, case: i, plant: k })));
const chosen = (side) => entries[sides[side].selectedIndex];
// The front, if any, is that of the plant on the right.
const frontOf = () =>
  (chosen(1)?.stand ?? scene.cases.find((item) => item.front))?.front;

function fill(list, labels) {
  list.replaceChildren(
    ...labels.map((label, i) => new Option(label, String(i))));
}

function fillPlants(list) {
  const groups = scene.cases.map((item) => {
    const group = document.createElement("optgroup");
    group.label = item.name;
    group.append(...item.plants.map((plant) => new Option(plant.title)));
    return group;
  });
  list.replaceChildren(...groups);
}

function draw() {
  if (!entries.length) return;
  const place = quantityList.selectedIndex;
  const shown = [0, 1].map((side) => {
    const { stand, plant } = chosen(side);
    const quantity = stand.quantities[Math.min(place, stand.quantities.length - 1)];
    return { stand, plant: stand.plants[plant], values: quantity.values[plant] };
  });
  const drawn = drawScene(canvas, shown, view, neighbours.checked);
  Object.assign(canvas.dataset, drawn);
  const isOneCase = shown[0].stand === shown[1].stand;
  part("-titles").replaceChildren(...shown.map(({ stand, plant }) => {
    const title = document.createElement("span");
    title.textContent = isOneCase ? plant.title : `${stand.name}, ${plant.title}`;
    return title;
  }));
  const [low, high] = rangeOf(shown);
  part("-low").textContent = low.toPrecision(2);
  part("-high").textContent = high.toPrecision(2);
  part("-bar").textContent =
    `absorbed PAR ${quantityList.selectedOptions[0]?.text ?? ""}`;
}

// The chart, and the numbers of the chosen member.
function drawFront() {
  const front = frontOf();
  if (!front) return;
  chart.show(front, ...pairsOf(front)[pairList.selectedIndex], member);
  part("-tables").replaceChildren(...tablesOf(front, front.members[member]));
}

function drawAll() {
  drawFront();
  draw();
}

// Shows the chosen member of the front on the right.
function chooseMember() {
  const caseIndex = chosen(1)?.case;
  const index = entries.findIndex(
    (item) => item.case === caseIndex && item.plant === member + 1);
  if (index >= 0) sides[1].selectedIndex = index;
}

function choose() {
  const front = frontOf();
  part("-panel").classList.toggle("has-front", Boolean(front));
  part("-plant").hidden = !entries.length;
  part("-missing").hidden = entries.length > 0;
  pairList.parentElement.hidden = !front || front.axes.length < 3;
  if (front) {
    fill(pairList, pairsOf(front).map((pair) =>
      pair.map((k) => front.axes[k].name).join(", ")));
    const plant = chosen(1)?.plant ?? 0;
    // Plants of one's own come after those of the front.
    const isMember = plant > 0 && plant <= front.members.length;
    member = isMember ? plant - 1 : front.first;
    part("-text").textContent = front.text;
    part("-seeds").hidden = front.seeds < 2;
  }
  if (entries.length) {
    const { stand } = chosen(1);
    const kept = Math.max(quantityList.selectedIndex, 0);
    fill(quantityList, stand.quantities.map((q) => q.label));
    quantityList.selectedIndex = Math.min(kept, stand.quantities.length - 1);
    neighbours.disabled = !stand.neighbours.length;
  }
  drawAll();
}

function show(change) {
  Object.assign(view, change);
  view.tilt = Math.min(Math.max(view.tilt, 0), Math.PI / 2);
  view.zoom = Math.min(Math.max(view.zoom, 0.3), 10);
  draw();
}

function turnBy(right, up) {
  show({ turn: view.turn + right, tilt: view.tilt + up });
}

function zoomBy(factor) {
  show({ zoom: view.zoom * factor });
}

// A finger that moves up or down scrolls the page (touch-action in the style
// sheet); the others arrive here.
const pointers = new Map();
let before = { ...view };

function apart() {
  const [[ax, ay], [bx, by]] = pointers.values();
  return Math.hypot(ax - bx, ay - by);
}

canvas.addEventListener("pointerdown", (event) => {
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  before = { ...view };
});
canvas.addEventListener("pointermove", (event) => {
  const last = pointers.get(event.pointerId);
  if (!last || !(event.buttons & 1)) return;
  const gap = pointers.size === 2 ? apart() : 0;
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  if (gap)
    zoomBy(apart() / gap);
  else
    turnBy((last[0] - event.clientX) / 120, (event.clientY - last[1]) / 120);
});
for (const end of ["pointerup", "pointercancel", "pointerleave"])
  canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
// The gesture is a scroll: its rotation so far is undone.
canvas.addEventListener("pointercancel", () => show(before));

// Without Ctrl the wheel scrolls the page; a pinch on a touch pad has it.
canvas.addEventListener("wheel", (event) => {
  if (!event.ctrlKey) return;
  event.preventDefault();
  zoomBy(Math.exp(-event.deltaY / 500));
}, { passive: false });

const actions = {
  ArrowLeft: () => turnBy(0.1, 0), ArrowRight: () => turnBy(-0.1, 0),
  ArrowUp: () => turnBy(0, 0.1), ArrowDown: () => turnBy(0, -0.1),
  "+": () => zoomBy(1.1), "-": () => zoomBy(1 / 1.1),
  Home: () => show(START),
  above: () => show({ ...START, turn: 0, tilt: Math.PI / 2 }),
};
canvas.addEventListener("keydown", (event) => {
  if (!(event.key in actions)) return;
  event.preventDefault();
  actions[event.key]();
});
for (const button of document.querySelectorAll("button[data-view]"))
  button.addEventListener("click", () => actions[button.dataset.view]());
for (const list of sides) list.addEventListener("change", choose);
pairList.addEventListener("change", drawFront);
quantityList.addEventListener("change", draw);
neighbours.addEventListener("change", draw);
// Parts that were hidden have no size until they show.
const sizes = new ResizeObserver(() => requestAnimationFrame(drawAll));
for (const name of ["", "-chart"]) sizes.observe(part(name));
const ramp = STOPS.map((color) => `rgb(${color.join()})`).join();
part("-ramp").style.background = `linear-gradient(to right, ${ramp})`;
for (const list of sides) fillPlants(list);
if (entries.length > 1) {
  sides[0].selectedIndex = 0;
  sides[1].selectedIndex = 1 + (entries[0].stand.front?.first ?? 0);
}
choose();
