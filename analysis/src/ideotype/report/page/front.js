// SPDX-License-Identifier: Apache-2.0
// The chart of a Pareto front: a point for each plant, which mouse, finger or
// keys choose.
const SVG = "http://www.w3.org/2000/svg";
const REACH = 40;  // of a finger [CSS pixels]
// Marks of seeds, around the origin.
const MARKS = [
  "M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0z", "M-4.5,-4.5h9v9h-9z",
  "M0,-5.5L5.5,4.5H-5.5z", "M0,5.5L5.5,-4.5H-5.5z",
  "M-5.5,-2h3.5v-3.5h4v3.5h3.5v4h-3.5v3.5h-4v-3.5h-3.5z",
];
const DIAMOND = "M0,-6.5L6.5,0L0,6.5L-6.5,0z";

function element(name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes))
    made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// Round numbers within a range, about as many as asked for.
function ticksOf(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((x) => x * power >= rough);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i)
    ticks.push([i * step, (i * step).toFixed(digits).replace("-", "−")]);
  return ticks;
}

// A range that contains the members of the front with their errors, and the
// baseline.
function rangeOfAxis(front, k) {
  const shown = [front.baseline, ...front.members.map((m) => m.objectives)]
    .map((all) => all[k]);
  const low = Math.min(...shown.map(([value, error]) => value - (error || 0)));
  const high = Math.max(...shown.map(([value, error]) => value + (error || 0)));
  const room = 0.08 * (high - low) || 0.01 * Math.abs(high) || 1;
  return [low - room, high + room];
}

// Numbers of two objectives each: across, up.
function pairsOf(front) {
  return front.axes.flatMap((_, up) =>
    front.axes.slice(up + 1).map((_, i) => [up + 1 + i, up]));
}

class Chart {
  // `choose` is called with the number of a member.
  constructor(svg, choose) {
    [this.svg, this.choose] = [svg, choose];
    svg.addEventListener("click", (event) => {
      const { left, top } = svg.getBoundingClientRect();
      const [x, y] = [event.clientX - left, event.clientY - top];
      const away = this.places.map(([a, b]) => Math.hypot(a - x, b - y));
      const nearest = away.indexOf(Math.min(...away));
      if (away[nearest] < REACH) this.pick(nearest);
    });
    svg.addEventListener("keydown", (event) => this.move(event));
  }

  pick(member) {
    this.choose(member);
    this.svg.querySelector("[tabindex='0']").focus({ preventScroll: true });
  }

  // Arrow keys move from point to point, from left to right.
  move(event) {
    const order = this.places.map((_, i) => i).sort((a, b) =>
      this.places[a][0] - this.places[b][0]
      || this.places[b][1] - this.places[a][1]);
    const [at, end] = [order.indexOf(this.chosen), order.length - 1];
    const to = {
      ArrowRight: Math.min(at + 1, end), ArrowUp: Math.min(at + 1, end),
      ArrowLeft: Math.max(at - 1, 0), ArrowDown: Math.max(at - 1, 0),
      Home: 0, End: end,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.pick(order[to]);
  }

  // Objectives `across` and `up` of a front.
  show(front, across, up, chosen) {
    this.chosen = chosen;
    const [width, height] = [this.svg.clientWidth, this.svg.clientHeight];
    const box = { left: 52, right: width - 12, top: 28, bottom: height - 50 };
    const [x, y] = [[across, box.left, box.right], [up, box.bottom, box.top]]
      .map(([k, from, to]) => {
        const [low, high] = rangeOfAxis(front, k);
        const at = (value) => from + (value - low) / (high - low) * (to - from);
        return { k, low, high, at, position: (values) => at(values[k][0]), ...front.axes[k] };
      });
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.places = front.members.map((m) => [x, y].map((a) => a.position(m.objectives)));
    const order = this.places.map((_, i) => i);
    // the chosen one is painted last, above the others
    order.push(...order.splice(chosen, 1));
    this.svg.replaceChildren(
      ...this.axes(x, y, box), this.cloud(front, x, y, box),
      this.point(front.baseline, x, y, DIAMOND, "baseline"),
      ...order.map((i) => this.member(front.members[i], x, y, i)));
  }

  axes(x, y, { left, right, top, bottom }) {
    const made = [];
    const line = (x1, y1, x2, y2, kind) => made.push(
      element("line", { x1, y1, x2, y2, class: kind }));
    const text = (words, at) => made.push(element("text", at, words));
    for (const [value, label] of ticksOf(x.low, x.high, (right - left) / 80)) {
      line(x.at(value), top, x.at(value), bottom, "grid");
      text(label, { x: x.at(value), y: bottom + 16, "text-anchor": "middle" });
    }
    for (const [value, label] of ticksOf(y.low, y.high, (bottom - top) / 50)) {
      line(left, y.at(value), right, y.at(value), "grid");
      text(label, { x: left - 6, y: y.at(value) + 4, "text-anchor": "end" });
    }
    line(left, bottom, right, bottom, "axis");
    line(left, top, left, bottom, "axis");
    const describe = ({ label, sense }) => `${label}, ${sense}d`;
    const isLess = (axis) => axis.sense === "minimise";
    const labels = [
      element("text", { x: (left + right) / 2, y: bottom + 40,
        "text-anchor": "middle" },
      isLess(x) ? `← ${describe(x)}` : `${describe(x)} →`),
      element("text", { x: 2, y: 14 }, `${isLess(y) ? "↓" : "↑"} ${describe(y)}`),
    ];
    // no wider than the chart
    this.svg.replaceChildren(...labels);
    for (const label of labels) {
      const long = label.getComputedTextLength() / (right - 2);
      if (long > 1) label.style.fontSize = `${13 / long}px`;
    }
    return [...made, ...labels];
  }

  // The last generation, as it was evaluated then.
  cloud(front, x, y, { left, right, top, bottom }) {
    const made = element("g", { class: "others" });
    for (const row of front.others) {
      const [cx, cy] = [x.at(row[x.k]), y.at(row[y.k])];
      if (cx >= left && cx <= right && cy >= top && cy <= bottom)
        made.append(element("circle", { cx, cy, r: 2.5 }));
    }
    return made;
  }

  // With its standard errors.
  point(objectives, x, y, mark, kind) {
    const made = element("g", { class: kind });
    const [cx, cy] = [x.position(objectives), y.position(objectives)];
    const [ex, ey] = [x, y].map((axis) => {
      const [value, error] = objectives[axis.k];
      return Math.abs(axis.at(value + (error || 0)) - axis.at(value));
    });
    made.append(
      element("path", { class: "error", d:
        `M${cx - ex},${cy}h${2 * ex}M${cx},${cy - ey}v${2 * ey}` +
        (ex ? `M${cx - ex},${cy - 3}v6m${2 * ex},0v-6` : "") +
        (ey ? `M${cx - 3},${cy - ey}h6m0,${2 * ey}h-6` : "") }),
      element("path", { d: mark, transform: `translate(${cx} ${cy})` }));
    return made;
  }

  member(member, x, y, i) {
    const isChosen = i === this.chosen;
    const mark = MARKS[member.seed % MARKS.length];
    const made = this.point(member.objectives, x, y, mark,
      `member${member.is_kept ? "" : " fallen"}${isChosen ? " chosen" : ""}`);
    const [cx, cy] = this.places[i];
    const values = [x, y].map((a) => `${a.label} ${member.objectives[a.k][0]}`);
    const name = [member.title, ...values].join(", ")
      + (member.is_kept ? "" : ", dominated after re-evaluation");
    const about = { role: "radio", tabindex: isChosen ? 0 : -1,
      "aria-checked": isChosen, "aria-label": name, "data-member": i };
    for (const [key, value] of Object.entries(about))
      made.setAttribute(key, value);
    made.prepend(element("title", {}, name));
    if (isChosen)
      made.append(element("circle", { cx, cy, r: 10, class: "ring" }));
    return made;
  }
}

function cellsOf(row, kind) {
  return row.map((text, i) => {
    const cell = document.createElement(i && kind === "td" ? "td" : "th");
    cell.textContent = text;
    if (cell.tagName === "TH") cell.scope = kind === "td" ? "row" : "col";
    return cell;
  });
}

function tableOf(header, rows) {
  const table = document.createElement("table");
  const add = (part, row, kind) =>
    part.insertRow().append(...cellsOf(row, kind));
  add(table.createTHead(), header, "th");
  const body = table.createTBody();
  for (const row of rows) add(body, row, "td");
  return table;
}

// Returns tables of the quantities of a member and of the baseline.
function tablesOf(front, member) {
  const columns = ["baseline", member.title, "difference [%]"];
  const rows = front.quantities.map((name, i) => [name, ...member.numbers[i]]);
  return [
    tableOf(["", ...columns], rows),
    ...member.scenarios.map(({ title, rows: cells }) =>
      tableOf([title, ...columns], cells)),
  ];
}
