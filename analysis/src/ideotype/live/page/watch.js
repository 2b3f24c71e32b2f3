// SPDX-License-Identifier: Apache-2.0
// Cases of running campaigns, asked for again and again.

const EVERY = 2000; // [ms]
const PROVISIONAL = "The gain that the last generation lets expect of its best plant, with "
  + "half of the 95 % interval. The value by which that plant was chosen is too good on average. "
  + "At the end finalists are re-evaluated with independent random numbers, and may be better.";
const seen = { told: null, chosen: null, plants: null, drawn: "", view: { ...START, turn: 0.75 } };

async function ask() {
  try {
    const answer = await fetch("state.json");
    if (!answer.ok) throw new Error(await answer.text());
    seen.told = await answer.json();
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

function tellHours(hours) {
  if (hours === null || hours === undefined) return "–";
  return hours < 0.095 ? `${(60 * hours).toFixed(1)} core-min` : `${hours.toFixed(1)} core-h`;
}

function showAll() {
  const { told } = seen;
  byId("title").textContent = told.folder;
  const { running, finished, cases } = told;
  document.title = `${running} running, ${finished} of ${cases.length} finished · ideotype watch`;
  byId("about").textContent =
    `${cases.length} ${cases.length === 1 ? "case" : "cases"}; read at ${new Date().toLocaleTimeString()}, and again every ${EVERY / 1000} s`;
  byId("sums").replaceChildren(
    fact("running", String(running)), fact("finished", `${finished} of ${cases.length}`),
    fact("evaluations", told.evaluations.toLocaleString("en")),
    fact("each second, now", told.rate ? told.rate.toFixed(1) : "–"),
    fact("failed evaluations", String(told.failures)),
    fact("left, at most", tellHours(told.core_hours_left)));
  byId("none").hidden = cases.length > 0;
  const focused = document.activeElement?.dataset?.file;
  byId("cases").replaceChildren(...cases.map((each) => make("li", {}, boxOf(each))));
  if (focused !== undefined)
    [...document.querySelectorAll(".case")].find((b) => b.dataset.file === focused)?.focus();
  const first = cases.find((c) => c.state === "running") || cases.find((c) => !c.problem);
  if (!cases.some((c) => c.file === seen.chosen && !c.problem)) seen.chosen = first?.file ?? null;
  showChosen();
  document.body.dataset.cases = cases.length;
}

// The gain of the best plant in words, which differ until it is re-evaluated.
function tellGain({ gain, is_final: isFinal }) {
  if (!gain || gain[0] === null) return [];
  const [value, half] = gain;
  const digits = half >= 10 ? 0 : 1;
  const told = `${tellSigned(value, digits)}${half === null ? "" : ` ± ${half.toFixed(digits)}`} %`;
  return isFinal
    ? [make("b", { class: "gain" }, `gain ${told}`)]
    : [make("span", { class: "gain provisional", title: PROVISIONAL },
      `best of generation about ${told}, not yet re-evaluated`)];
}

function boxOf(each) {
  if (each.problem)
    return make("div", { class: "bad-file" },
      make("span", { class: "state damaged" }, each.file), make("br"), each.problem);
  const words = [
    each.state === "finished" ? `ended after ${each.generation} generations`
      : `generation ${each.generation} of ${each.generations}`,
    each.rate && each.state === "running" ? `${each.rate.toFixed(1)} evaluations/s` : "",
    each.state !== "finished" && each.seconds_left ? `${tellDuration(each.seconds_left)} left` : "",
    each.failures ? `${each.failures} failed` : "",
  ].filter(Boolean);
  return make("button", {
    type: "button", class: "case", "data-file": each.file,
    "aria-pressed": String(each.file === seen.chosen),
    onclick: () => {
      seen.chosen = each.file;
      showAll();
    },
  },
  make("span", { class: "name" }, each.name),
  make("span", { class: `state ${each.state}` }, each.state),
  make("progress", {
    max: each.generations, "aria-label": `${each.name}: generations done`,
    value: each.state === "finished" ? each.generations : each.generation,
  }),
  make("span", { class: "told" },
    ...tellGain(each),
    ...words.map((word) => make("span", {}, word))));
}

function valueOf(plant, unit) {
  if (!plant) return "–";
  return `${tellNumber(plant[0], plant[1])} ${tellError(plant[0], plant[1])} ${plainUnit(unit)}`;
}

function showChosen() {
  const each = seen.told.cases.find((c) => c.file === seen.chosen);
  byId("chosen").hidden = !each;
  if (!each) return;
  byId("chosen-name").textContent = each.name;
  byId("facts").replaceChildren(
    fact("state", each.state_told), fact("evaluations", String(each.evaluations)),
    fact(each.is_final ? "best, re-evaluated" : "best of generation, about", valueOf(each.best, each.unit)),
    fact("baseline", valueOf(each.baseline, each.unit)),
    fact("time so far", tellDuration(each.wall_time)), fact("left, at most", tellHours(each.core_hours_left)));
  byId("chart-name").textContent = `${each.objective.replace(/_/g, " ")}, by generation`;
  const [best, standardErrors, mean] = each.convergence;
  const line = (values, off, kind) => ({
    kind, points: values.map((v, i) => [i, v, halfWidth(off?.[i])]),
  });
  drawChart(byId("convergence"), {
    lines: [line(mean, null, "other"), line(best, standardErrors, "mine")],
    xLabel: "generation", yLabel: plainUnit(each.unit), zero: false, isWhole: true,
    about: `${each.objective} of the best and the mean plant, by generation`,
  });
  byId("failure").textContent = each.last_failure
    ? `Last failure: ${each.last_failure}` : "";
  const state = `${each.file} ${each.best}`;
  if (state !== seen.drawn) {
    seen.drawn = state;
    askPlants(each.file);
  }
}

async function askPlants(file) {
  const answer = await fetch(`plants?file=${encodeURIComponent(file)}`).catch(() => null);
  if (!answer || !answer.ok || file !== seen.chosen) return;
  const found = await answer.json();
  byId("plants").hidden = Boolean(found.problem);
  byId("plants-told").textContent = found.problem ? `No picture: ${found.problem}.` : "";
  if (found.problem) return;
  found.plants.forEach(unpackPlant);
  seen.plants = found;
  drawPlants();
}

function drawPlants() {
  if (!seen.plants) return;
  const of = { ...seen.plants, row_direction: null };
  const shown = [0, 1].map((i) =>
    ({ of, plant: of.plants[i], values: of.plants[i].light }));
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
