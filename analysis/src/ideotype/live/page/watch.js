// SPDX-License-Identifier: Apache-2.0
// The page of `ideotype watch`: polls the state of all cases.

const EVERY = 2000; // [ms]
const PROVISIONAL = "Expected gain of the best plant of the last generation (shrinkage estimate), "
  + "± half of its 95 % confidence interval. The value by which the plant was selected is too good "
  + "on average. At the end the finalists are re-evaluated with independent random numbers.";
const seen = { state: null, chosen: null, plants: null, drawn: "", view: { ...START, turn: 0.75 } };

async function ask() {
  try {
    const answer = await fetch("state.json");
    if (!answer.ok) throw new Error(await answer.text());
    seen.state = await answer.json();
    byId("lost").hidden = true;
    showAll();
  } catch {
    byId("lost").hidden = false;
  }
  setTimeout(ask, EVERY);
}

function fact(name, value) {
  return make("div", {}, make("dt", {}, name), make("dd", {}, value));
}

function formatHours(hours) {
  if (hours === null || hours === undefined) return "–";
  if (hours === 0) return "0";
  return hours < 0.095 ? `${(60 * hours).toFixed(1)} core-min` : `${hours.toFixed(1)} core-h`;
}

function showAll() {
  const { state } = seen;
  byId("title").textContent = state.folder;
  const { running, finished, cases } = state;
  document.title = `${running} running, ${finished} of ${cases.length} finished · ideotype watch`;
  byId("about").textContent =
    `${cases.length} ${cases.length === 1 ? "case" : "cases"}; updated at ${new Date().toLocaleTimeString()}, every ${EVERY / 1000} s`;
  byId("sums").replaceChildren(
    fact("running", String(running)), fact("finished", `${finished} of ${cases.length}`),
    fact("evaluations", state.evaluations.toLocaleString("en")),
    fact("evaluations per second", state.rate ? state.rate.toFixed(1) : "–"),
    fact("failed evaluations", String(state.failures)),
    fact("CPU time left, at most", formatHours(state.core_hours_left)));
  byId("none").hidden = cases.length > 0;
  const focused = document.activeElement?.dataset?.file;
  byId("cases").replaceChildren(...cases.map((entry) => make("li", {}, boxOf(entry))));
  if (focused !== undefined)
    [...document.querySelectorAll(".case")].find((b) => b.dataset.file === focused)?.focus();
  const first = cases.find((c) => c.state === "running") || cases.find((c) => !c.problem);
  if (!cases.some((c) => c.file === seen.chosen && !c.problem)) seen.chosen = first?.file ?? null;
  showChosen();
  document.body.dataset.cases = cases.length;
}

// The gain of the best plant in words, which differ until it is re-evaluated.
function formatGain({ gain, is_final: isFinal }) {
  if (!gain || gain[0] === null) return [];
  const [value, half] = gain;
  const digits = half >= 10 ? 0 : 1;
  const text = `${formatSigned(value, digits)}${half === null ? "" : ` ± ${half.toFixed(digits)}`} %`;
  return isFinal
    ? [make("b", { class: "gain" }, `gain ${text}`)]
    : [make("span", { class: "gain provisional", title: PROVISIONAL },
      `expected gain ${text}, not yet re-evaluated`)];
}

function boxOf(entry) {
  if (entry.problem)
    return make("div", { class: "bad-file" },
      make("span", { class: "state damaged" }, entry.file), make("br"), entry.problem);
  const words = [
    entry.state === "finished" ? `finished after ${entry.generation} generations`
      : `generation ${entry.generation} of ${entry.generations}`,
    entry.rate && entry.state === "running" ? `${entry.rate.toFixed(1)} evaluations per second` : "",
    entry.state !== "finished" && entry.seconds_left ? `time left ${formatDuration(entry.seconds_left)}` : "",
    entry.failures ? `${entry.failures} failed` : "",
  ].filter(Boolean);
  return make("button", {
    type: "button", class: "case", "data-file": entry.file,
    "aria-pressed": String(entry.file === seen.chosen),
    onclick: () => {
      seen.chosen = entry.file;
      showAll();
    },
  },
  make("span", { class: "name" }, entry.name),
  make("span", { class: `state ${entry.state}` }, entry.state),
  make("progress", {
    max: entry.generations, "aria-label": `${entry.name}: generations done`,
    value: entry.state === "finished" ? entry.generations : entry.generation,
  }),
  make("span", { class: "text" },
    ...formatGain(entry),
    ...words.map((word) => make("span", {}, word))));
}

function valueOf(plant, unit) {
  if (!plant) return "–";
  return `${formatNumber(plant[0], plant[1])} ${formatError(plant[0], plant[1])} ${plainUnit(unit)}`;
}

function showChosen() {
  const entry = seen.state.cases.find((c) => c.file === seen.chosen);
  byId("chosen").hidden = !entry;
  if (!entry) return;
  byId("chosen-name").textContent = entry.name;
  byId("facts").replaceChildren(
    fact("state", entry.state_text), fact("evaluations", String(entry.evaluations)),
    fact(entry.is_final ? "best plant, re-evaluated" : "best plant, expected", valueOf(entry.best, entry.unit)),
    fact("baseline", valueOf(entry.baseline, entry.unit)),
    fact("wall time", formatDuration(entry.wall_time)),
    fact("time left", entry.seconds_left === null ? "–" : formatDuration(entry.seconds_left)),
    fact("CPU time left, at most", formatHours(entry.core_hours_left)));
  byId("chart-name").textContent = `${entry.objective_label} by generation`;
  const [best, standardErrors, mean] = entry.convergence;
  const line = (values, off, kind) => ({
    kind, points: values.map((v, i) => [i, v, halfWidth(off?.[i])]),
  });
  drawChart(byId("convergence"), {
    lines: [line(mean, null, "other"), line(best, standardErrors, "mine")],
    xLabel: "generation", yLabel: plainUnit(entry.unit), zero: false, isWhole: true,
    about: `${entry.objective_label} of the best plant and of the population mean, by generation`,
  });
  byId("failure").textContent = entry.last_failure
    ? `Last failure: ${entry.last_failure}` : "";
  const key = `${entry.file} ${entry.best}`;
  if (key !== seen.drawn) {
    seen.drawn = key;
    askPlants(entry.file);
  }
}

async function askPlants(file) {
  const answer = await fetch(`plants?file=${encodeURIComponent(file)}`).catch(() => null);
  if (!answer || !answer.ok || file !== seen.chosen) return;
  const data = await answer.json();
  byId("plants").hidden = Boolean(data.problem);
  byId("plants-text").textContent = data.problem ? `No picture: ${data.problem}.` : "";
  if (data.problem) return;
  data.plants.forEach(unpackPlant);
  seen.plants = data;
  drawPlants();
}

function drawPlants() {
  if (!seen.plants) return;
  const stand = { ...seen.plants, row_direction: null };
  const shown = [0, 1].map((i) =>
    ({ stand, plant: stand.plants[i], values: stand.plants[i].light }));
  Object.assign(byId("view").dataset,
    drawScene(byId("view"), shown, seen.view, true));
  const [low, high] = rangeOf(shown);
  byId("low").textContent = low.toPrecision(2);
  byId("high").textContent = high.toPrecision(2);
}

for (const button of document.querySelectorAll("[data-look]"))
  button.addEventListener("click", () => {
    seen.view.turn += button.dataset.look === "left" ? 0.3 : -0.3;
    drawPlants();
  });
addEventListener("resize", drawPlants);
byId("ramp").style.background =
  `linear-gradient(to right, ${STOPS.map((color) => `rgb(${color.join()})`).join()})`;
ask();
