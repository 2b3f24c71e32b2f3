// SPDX-License-Identifier: Apache-2.0
// Choices, mouse, fingers and keys of the 3D view.
const scene = JSON.parse(document.getElementById("scene").textContent);
unpack(scene);
const part = (name) => document.getElementById(`view${name}`);
const canvas = part("");
const [caseList, quantityList] = [part("-case"), part("-quantity")];
const pairList = part("-pair");
const neighbours = part("-neighbours");
const view = { ...START };
let member = 0;
const chart = new Chart(part("-chart"), (i) => {
  member = i;
  drawAll();
});

const chosenCase = () => scene.cases[caseList.selectedIndex];

function fill(list, labels) {
  list.replaceChildren(
    ...labels.map((label, i) => new Option(label, String(i))));
}

function draw() {
  const chosen = chosenCase();
  if (!chosen.plants.length) return;
  const shown = [0, chosen.front ? 1 + member : 1];
  const quantity = chosen.quantities[quantityList.selectedIndex];
  const drawn =
    drawScene(canvas, chosen, shown, quantity, view, neighbours.checked);
  Object.assign(canvas.dataset, drawn);
  part("-titles").replaceChildren(...shown.map((i) => {
    const title = document.createElement("span");
    title.textContent = chosen.plants[i].title;
    return title;
  }));
  const [low, high] = rangeOf(quantity, shown);
  part("-low").textContent = low.toPrecision(3);
  part("-high").textContent = high.toPrecision(3);
  part("-bar").textContent = `absorbed PAR ${quantity.label}`;
}

// The chart, and the numbers of the chosen member.
function drawFront() {
  const { front } = chosenCase();
  if (!front) return;
  chart.show(front, ...pairsOf(front)[pairList.selectedIndex], member);
  part("-tables").replaceChildren(...tablesOf(front, front.members[member]));
}

function drawAll() {
  drawFront();
  draw();
}

function chooseCase() {
  const { front, plants, quantities, neighbours: others } = chosenCase();
  part("-panel").classList.toggle("has-front", Boolean(front));
  part("-plant").hidden = !plants.length;
  part("-missing").hidden = plants.length > 0;
  pairList.parentElement.hidden = !front || front.axes.length < 3;
  if (front) {
    fill(pairList, pairsOf(front).map((pair) =>
      pair.map((k) => front.axes[k].name).join(", ")));
    member = front.first;
    part("-told").textContent = front.told;
    part("-seeds").hidden = front.seeds < 2;
  }
  if (plants.length) {
    const kept = Math.max(quantityList.selectedIndex, 0);
    fill(quantityList, quantities.map((q) => q.label));
    quantityList.selectedIndex = Math.min(kept, quantities.length - 1);
    neighbours.disabled = !others.length;
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
// The finger scrolls: what it turned until that was clear is taken back.
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
caseList.addEventListener("change", chooseCase);
pairList.addEventListener("change", drawFront);
quantityList.addEventListener("change", draw);
neighbours.addEventListener("change", draw);
window.addEventListener("resize", drawAll);
const ramp = STOPS.map((color) => `rgb(${color.join()})`).join();
part("-ramp").style.background = `linear-gradient(to right, ${ramp})`;
fill(caseList, scene.cases.map((each) => each.name));
chooseCase();
