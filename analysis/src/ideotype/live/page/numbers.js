// SPDX-License-Identifier: Apache-2.0
// Quantities with intervals and differences from the reference plant, and two
// charts.

const REACH = [2, 5, 10, 20, 50, 100, 200, 400];

// The difference from the other plant in per cent, with half of its interval.
function percentOf(name, message) {
  const other = message.reference?.[name]?.[0];
  const [apart, standardError] = message.differences?.[name] || [];
  if (!other || apart === null || apart === undefined) return null;
  return [100 * apart / Math.abs(other), 100 * halfWidth(standardError) / Math.abs(other)];
}

function differenceBar([value, error], reach) {
  const at = (x) => 50 + 46 * Math.max(-1, Math.min(1, x / reach));
  return makeSvg("svg", {
    viewBox: "0 0 100 12", preserveAspectRatio: "none", class: "bar", "aria-hidden": "true",
  },
  makeSvg("line", { class: "track", x1: 4, x2: 96, y1: 6, y2: 6 }),
  makeSvg("line", { class: "middle", x1: 50, x2: 50, y1: 1, y2: 11 }),
  makeSvg("rect", {
    class: isClear([value, error]) ? "fill clear" : "fill", y: 4, height: 4,
    x: Math.min(50, at(value)), width: Math.abs(at(value) - 50),
  }),
  makeSvg("line", { class: "whisker", x1: at(value - error), x2: at(value + error), y1: 6, y2: 6 }));
}

// A difference as words: "+3.1 ± 0.4 %".
function formatPercent([value, error]) {
  if (Math.max(Math.abs(value), error) < 0.005) return "no difference";
  // One digit of the error is enough.
  const digits = Math.min(2, Math.max(0, -Math.floor(Math.log10(error || 0.1))));
  const off = error ? ` ± ${error.toFixed(digits)}` : "";
  return `${formatSigned(value, digits)}${off} %`;
}

const isClear = ([value, error]) => Math.abs(value) > error && value !== 0;

function numberRow(quantity, message, reach) {
  const [value, standardError] = message.numbers[quantity.name] || [null, null];
  const error = halfWidth(standardError);
  const isShare = quantity.unit === "1" && /fraction|fapar/.test(quantity.name);
  const factor = isShare ? 100 : 1;
  const unit = isShare ? "%" : plainUnit(quantity.unit);
  const percent = percentOf(quantity.name, message);
  const scaled = value === null ? null : value * factor;
  return make("div", { class: "number", "data-name": quantity.name },
    make("dt", { title: quantity.meaning }, quantity.label),
    make("dd", {},
      make("span", { class: "text" },
        make("span", { class: "value" }, formatNumber(scaled, error * factor)),
        ` ${formatError(scaled, error * factor)} ${unit}`),
      percent ? make("span", { class: isClear(percent) ? "apart clear" : "apart" },
        formatPercent(percent)) : null,
      percent ? differenceBar(percent, reach) : null));
}

// The main differences, for small screens.
function showStrip(message) {
  const names = page.hello.goals.slice(0, 3);
  byId("strip").replaceChildren(...names.map((name) => {
    const percent = percentOf(name, message);
    const { label } = page.hello.quantities.find((q) => q.name === name);
    return make("span", {}, `${label} `,
      make("b", {}, percent ? formatPercent([percent[0], 0]) : "…"));
  }));
}

function showNumbers(message) {
  const { quantities } = page.hello;
  const rows = (isKey) => quantities.filter((q) => q.is_key === isKey);
  const largest = Math.max(...rows(true).filter(
    (q) => !q.name.startsWith("distance")).map((q) =>
    Math.abs(percentOf(q.name, message)?.[0] || 0)));
  const reach = REACH.find((r) => r >= 1.1 * largest) || 800;
  byId("numbers").replaceChildren(
    ...rows(true).map((q) => numberRow(q, message, reach)));
  if (byId("all").open)
    byId("all-numbers").replaceChildren(
      ...rows(false).map((q) => numberRow(q, message, reach)));
  byId("rough").textContent = message.is_final
    ? `mean of ${message.evaluations} evaluations` : "refining …";
  byId("rough").title = `${message.evaluations} evaluations with independent random numbers`;
  byId("rough").classList.toggle("done", Boolean(message.is_final));
  byId("reach").textContent = `Bars: ± ${reach} %.`;
  showStrip(message);
  showCharts(message);
  showDay(message);
}

function chartOf(id, message, name, { isUpright, isClock, xLabel, title }) {
  const mine = message.curves[name];
  // Rough answers lack some curves; the earlier curves stay until refined.
  if (message.is_rough && !mine) return;
  const box = byId(id).closest("figure");
  box.hidden = !mine || mine.at.length < 3;
  if (box.hidden) return;
  const other = message.reference_curves?.[name];
  // Layers above the plants are empty.
  const top = isUpright ? 2 + Math.max(...[mine, other].map((curve) =>
    curve ? curve.values.findLastIndex((v) => v > 0) : 0)) : undefined;
  const pointsOf = (curve) => curve.at.map((at, i) => (isUpright
    ? [curve.values[i], 100 * at, halfWidth(curve.standard_errors[i])]
    : [at, curve.values[i], halfWidth(curve.standard_errors[i])])).slice(0, top);
  const unit = plainUnit(mine.unit);
  box.querySelector("figcaption").textContent = title;
  drawChart(byId(id), {
    lines: [
      ...(other ? [{ points: pointsOf(other), kind: "other" }] : []),
      { points: pointsOf(mine), kind: "mine" },
    ],
    isUpright, isClock, xLabel: isUpright ? unit : xLabel,
    yLabel: isUpright ? "height [cm]" : unit,
    about: `${title}, in ${unit}`,
  });
}

function showCharts(message) {
  const kind = byId("color").value.startsWith("net") ? "assimilation" : "absorbed";
  const label = kind === "absorbed" ? "Absorbed PAR" : "Gross assimilation";
  chartOf("by-height", message, `${kind}_by_layer`,
    { isUpright: true, title: `${label} by height` });
  const hourly = message.curves[`${kind}_by_hour`];
  if (hourly)
    chartOf("by-hour", message, `${kind}_by_hour`,
      { isClock: true, xLabel: "time of day", title: `${label} by hour` });
  else if (!message.is_rough || message.curves.day_of_stage)
    byStage(message, kind);
}

// Growing canopies have stages instead of hours.
function byStage(message, kind) {
  const days = message.curves.day_of_stage?.values;
  const name = kind === "absorbed" ? "absorbed_par_by_stage" : "net_assimilation_by_stage";
  const at = (curves) => curves?.[name] && days
    ? { [name]: { ...curves[name], at: days } } : {};
  chartOf("by-hour", {
    is_rough: message.is_rough, curves: at(message.curves), reference_curves: at(message.reference_curves),
  }, name, {
    xLabel: "days after emergence",
    title: `${kind === "absorbed" ? "Absorbed PAR" : "Net assimilation"} over the season`,
  });
}

// Leaf area and absorption on the selected day, interpolated between stages.
function showDay(message) {
  const { age, when: time } = page.shown.conditions;
  const days = message.curves.day_of_stage?.values;
  const box = byId("day-text");
  box.hidden = !(days && age && time === "season");
  if (box.hidden) return;
  const between = (name) => {
    const curve = message.curves[name];
    if (!curve) return null;
    const i = Math.max(1, days.findIndex((day) => day >= age));
    const part = Math.min(1, Math.max(0, (age - days[i - 1]) / (days[i] - days[i - 1])));
    return curve.values[i - 1] + part * (curve.values[i] - curve.values[i - 1]);
  };
  const [lai, share] = [between("lai_by_stage"), between("fapar_by_stage")];
  box.textContent = `${age} days after emergence: leaf area index ${formatNumber(lai)}`
    + (share === null ? "." : `, ${(100 * share).toFixed(0)} % of PAR absorbed.`);
}
