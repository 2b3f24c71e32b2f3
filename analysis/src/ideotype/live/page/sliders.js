// SPDX-License-Identifier: Apache-2.0
// Sliders of the plant and of its field.

// A slider with its name, its value and a reset button.
class Slider {
  constructor({ name, label, unit, low, high, step, digits, start, help, get, set }) {
    Object.assign(this, { unit, digits, start, get, set, label });
    this.input = make("input", {
      type: "range", min: low, max: high, step, id: `s-${name}`,
      "aria-label": label, title: help || null,
      oninput: () => this.move(Number(this.input.value)),
      onpointerdown: () => remember(),
      onkeydown: (event) => {
        if (/^(Arrow|Page|Home|End)/.test(event.key) && !event.repeat) remember();
      },
    });
    this.output = make("output", { for: `s-${name}` });
    this.reset = make("button", {
      type: "button", class: "reset", title: "Reset",
      "aria-label": `${label}: reset`,
      onclick: () => {
        remember();
        this.move(this.start());
      },
    }, "↺");
    const shortLabel = label.split(", ").pop();
    this.element = make("div", { class: "slider" },
      make("span", { class: "own" }, shortLabel), this.reset, this.output, this.input);
    this.mark = [low, high];
  }

  move(value) {
    this.set(value);
  }

  // Shows the value that the page has now.
  refresh() {
    const value = this.get();
    this.input.value = value;
    const number = value.toFixed(this.digits).replace("-", "−");
    const gap = this.unit === "°" || !this.unit ? "" : " ";
    const text = `${number}${gap}${this.unit}`;
    this.output.textContent = text;
    this.input.setAttribute("aria-valuetext", text);
    const [low, high] = this.mark;
    const part = (x) => `${100 * Math.min(1, Math.max(0, (x - low) / (high - low)))}%`;
    const start = this.start();
    this.input.style.setProperty("--start", part(start));
    this.input.style.setProperty("--now", part(value));
    const half = 0.5 * 10 ** -this.digits;
    this.element.classList.toggle("moved", Math.abs(value - start) > half);
  }
}

let sliders = [];

function leverSlider(lever, index) {
  const shownOf = (gene) => gene * lever.scale + lever.shift;
  const ends = [shownOf(lever.lower), shownOf(lever.upper)].sort((a, b) => a - b);
  const span = ends[1] - ends[0];
  const digits = span > 30 ? 0 : 1;
  const name = [lever.component, lever.group, lever.label]
    .filter((word, i, all) => word && all.indexOf(word) === i).join(", ");
  const slider = new Slider({
    name: lever.name, label: name, unit: lever.unit, help: lever.help,
    low: ends[0], high: ends[1], step: 10 ** -digits / 2, digits,
    start: () => shownOf(page.hello.genome[index]),
    get: () => shownOf(page.shown.genome[index]),
    set: (value) => {
      page.shown.genome[index] = (value - lever.shift) / lever.scale;
      change({});
    },
  });
  slider.index = index;
  return slider;
}

// A box of related sliders with a description.
function groupBox(title, help, members) {
  const heading = make("h3", {}, title);
  return make("section", { class: "group" }, heading,
    help ? make("p", { class: "help" }, help) : null,
    ...members.map((slider) => slider.element));
}

function buildPlant(levers) {
  const component = page.hello.components[page.shown.component];
  const shownLevers = levers.map((lever, i) => ({ lever, i })).filter(({ lever }) =>
    page.shown.component ? lever.component === component : !lever.component);
  const build = ({ lever, i }) => {
    const slider = leverSlider(lever, i);
    sliders.push(slider);
    return slider;
  };
  const boxes = [];
  const groups = new Map();
  for (const entry of shownLevers.filter(({ lever }) => lever.kind === "profile")) {
    const key = entry.lever.name.replace(/_\d+$/, "");
    groups.set(key, [...(groups.get(key) || []), entry]);
  }
  // The top leaf comes first, as it does in the plant.
  for (const members of groups.values())
    boxes.push(groupBox(members[0].lever.group, members[0].lever.help,
      members.reverse().map(build)));
  for (const entry of shownLevers.filter(({ lever }) => lever.kind === "plant"))
    boxes.push(groupBox(entry.lever.group, entry.lever.help, [build(entry)]));
  const single = shownLevers.filter(({ lever }) => lever.kind === "leaf");
  byId("traits").replaceChildren(...boxes);
  byId("leaves").hidden = !single.length;
  buildLeaves(single);
}

function buildLeaves(single) {
  const ranks = [...new Set(single.map(({ lever }) => lever.leaf))];
  const list = byId("leaf");
  const top = ranks[ranks.length - 1];
  list.replaceChildren(...ranks.map((rank) => new Option(
    `leaf ${rank}${rank === 1 ? " (lowest)" : rank === top ? " (top)" : ""}`, rank)));
  const pick = () => {
    sliders = sliders.filter((slider) => !slider.isOfLeaf);
    const boxes = single.filter(({ lever }) => lever.leaf === Number(list.value))
      .map(({ lever, i }) => {
        const slider = leverSlider(lever, i);
        slider.isOfLeaf = true;
        sliders.push(slider);
        return groupBox(lever.group, lever.help, [slider]);
      });
    byId("leaf-traits").replaceChildren(...boxes);
    refreshSliders();
  };
  list.onchange = pick;
  pick();
}

function conditionSlider(name, label, unit, low, high, step, help, factor = 1) {
  const digits = Math.max(0, Math.ceil(-Math.log10(step)));
  return new Slider({
    name, label, unit, low, high, step, digits, help,
    start: () => page.hello.conditions[name] * factor,
    get: () => page.shown.conditions[name] * factor,
    set: (value) => {
      const kept = factor === 1 ? value : value / factor;
      change({ conditions: { ...page.shown.conditions, [name]: kept } });
    },
  });
}

const MONTHS = ["January", "February", "March", "April", "May", "June", "July",
  "August", "September", "October", "November", "December"];

function dateOf(day) {
  const date = new Date(Date.UTC(2025, 0, day));
  return `${date.getUTCDate()} ${MONTHS[date.getUTCMonth()]}`;
}

// Shows the value of a slider as a text.
function showAs(slider, textOf) {
  const plain = slider.refresh.bind(slider);
  slider.refresh = () => {
    plain();
    const text = textOf(slider.get());
    slider.output.textContent = text;
    slider.input.setAttribute("aria-valuetext", text);
  };
}

// A slider for each price of the campaign, from 0 to three times its value.
function buildPrices() {
  const { conditions, prices } = page.hello;
  const members = Object.entries(prices)
    .filter(([name]) => conditions[`price_${name}`] > 0)
    .map(([name, unit]) => {
      const usual = conditions[`price_${name}`];
      const label = name === "other" ? "Other costs" : `${name[0].toUpperCase()}${name.slice(1)}`;
      return conditionSlider(`price_${name}`, label, unit, 0, 3 * usual,
        10 ** Math.floor(Math.log10(usual / 20)), "");
    });
  sliders.push(...members);
  byId("prices").replaceChildren(...(members.length
    ? [groupBox("Prices", "In the currency of the campaign; they change the margin.", members)] : []));
}

function buildField() {
  const { conditions, days, seasons } = page.hello;
  const few = conditions.density > 0.4;
  const box = (id, title, help, ...args) => {
    const slider = conditionSlider(...args);
    sliders.push(slider);
    const element = groupBox(title, help, [slider]);
    element.id = id;
    return element;
  };
  byId("spacing").replaceChildren(
    box("f-density", "Density", "Plants per square metre of ground.",
      "density", "Density", "plants/m²", few ? 1 : 0.2,
      Math.max(16, Math.ceil(2.5 * conditions.density)), 0.1, ""),
    box("f-row", "Row distance", "Between adjacent rows; the distance of plants in the row changes so that density stays constant.",
      "row", "Row distance", "cm", 10, Math.max(150, 150 * conditions.row), 1, "", 100),
    box("f-direction", "Row direction", "Clockwise from north: 0° is a north-south row, 90° an east-west row.",
      "direction", "Row direction", "°", 0, 180, 1, ""));
  const [day, hour] = [
    box("f-day", "Day", "Date of the clear day.",
      "day", "Day", "", 1, 365, 1, ""),
    box("f-hour", "Hour", "Start of the hour, local time.",
      "hour", "Hour", ":00", 3, 21, 1, "")];
  showAs(sliders.find((slider) => slider.input.id === "s-day"), dateOf);
  const latitude = box("f-latitude", "Latitude", "Positive north of the equator.",
    "latitude", "Latitude", "°", -60, 66, 0.5, "");
  const years = [];
  if (seasons.length > 1) {
    years.push(box("f-season", "Season", "Weather of the seasons of the campaign.",
      "season", "Season", "", 0, seasons.length - 1, 1, ""));
    showAs(sliders.at(-1), (number) => seasons[number]);
  }
  byId("time").replaceChildren(...years,
    ...(days ? [box("f-age", "Days after emergence",
      "Days after emergence of the plant in the view; 0 shows it full-grown.",
      "age", "Days after emergence", "days", 0, days - 1, 1, "")] : []),
    day, hour, latitude);
  byId("modules").replaceChildren(
    box("f-panel_height", "Height of the modules", "From the soil to the middle of the modules.",
      "panel_height", "Height of the modules", "cm", 100, 800, 5, "", 100),
    box("f-panel_width", "Width of the modules", "Across the row of modules.",
      "panel_width", "Width of the modules", "cm", 40, 600, 5, "", 100),
    box("f-panel_rows", "Rows between modules", "Rows of plants from one row of modules to the next.",
      "panel_rows", "Rows between modules", "rows", 3, 16, 1, ""));
}

function refreshSliders() {
  for (const slider of sliders) slider.refresh();
  const { conditions } = page.shown;
  for (const button of document.querySelectorAll("[data-when]"))
    button.setAttribute("aria-pressed", String(button.dataset.when === conditions.when));
  const hide = (id, isHidden) => {
    if (byId(id)) byId(id).hidden = isHidden;
  };
  const isSeason = conditions.when === "season";
  hide("f-day", isSeason);
  hide("f-latitude", isSeason);
  hide("f-hour", conditions.when !== "hour");
  hide("f-age", !isSeason);
  hide("f-season", !isSeason);
  hide("prices", !isSeason);
  hide("latitude-text", !isSeason);
  byId("panels").checked = conditions.panels;
  byId("modules").hidden = !conditions.panels;
  byId("undo").disabled = !page.past.length;
  byId("redo").disabled = !page.future.length;
}

function buildSliders() {
  sliders = [];
  buildField();
  buildPrices();
  buildPlant(page.hello.levers);
  refreshSliders();
}
