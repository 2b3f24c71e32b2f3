// SPDX-License-Identifier: Apache-2.0
// A small chart of lines with bands of their 95 % confidence intervals.

const CHART = { width: 420, height: 230, left: 46, right: 20, top: 8, bottom: 38 };

// Round numbers from low to high, about `count` of them, or whole ones.
function ticks(low, high, isWhole = false, count = 4) {
  const rough = (high - low) / Math.min(count, isWhole ? high - low || 1 : count) || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((s) => s * power >= rough) * power;
  const values = [];
  for (let t = Math.ceil(low / step - 1e-9) * step; t <= high + 1e-9 * step; t += step)
    values.push(Number(t.toPrecision(10)));
  return values;
}

// Full hours from low to high, at most seven of them.
function hours(low, high) {
  const step = [1, 2, 3, 4].find((s) => (high - low) / s < 7) || 6;
  const values = [];
  for (let t = Math.ceil(low / step) * step; t <= high; t += step) values.push(t);
  return values;
}

// Draws lines, each with points [x, y, error], a class and a name, into an
// <svg>. `isUpright`: y is the independent variable, such as height, and the
// error is that of x. `isClock`: x is in hours.
function drawChart(svg, { lines, xLabel, yLabel, isUpright, zero = true, isWhole, isClock, about }) {
  const { width, height, left, right, top, bottom } = CHART;
  const allPoints = lines.flatMap((line) => line.points)
    .filter((p) => p[0] !== null && p[1] !== null);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.setAttribute("aria-label", about);
  svg.replaceChildren();
  if (!allPoints.length) return;
  const error = (p) => p[2] || 0;
  const [ex, ey] = isUpright ? [error, () => 0] : [() => 0, error];
  const range = (k, off, fromZero) => {
    const low = Math.min(...allPoints.map((p) => p[k] - off(p)));
    const high = Math.max(...allPoints.map((p) => p[k] + off(p)));
    return [fromZero ? Math.min(0, low) : low, high > low ? high : low + 1];
  };
  const [x0, x1] = range(0, ex, isUpright && zero);
  const [y0, y1] = range(1, ey, zero || isUpright);
  const atX = (x) => left + (x - x0) / (x1 - x0) * (width - left - right);
  const atY = (y) => height - bottom - (y - y0) / (y1 - y0) * (height - top - bottom);
  const text = (content, x, y, anchor = "middle", kind = "tick") =>
    makeSvg("text", { x, y, "text-anchor": anchor, class: kind }, content);
  for (const t of isClock ? hours(x0, x1) : ticks(x0, x1, isWhole))
    svg.append(
      makeSvg("line", { class: "grid", x1: atX(t), x2: atX(t), y1: top, y2: height - bottom }),
      text(isClock ? `${t}:00` : String(t).replace("-", "−"), atX(t), height - bottom + 14));
  for (const t of ticks(y0, y1))
    svg.append(
      makeSvg("line", { class: "grid", x1: left, x2: width - right, y1: atY(t), y2: atY(t) }),
      text(String(t).replace("-", "−"), left - 5, atY(t) + 4, "end"));
  svg.append(
    text(xLabel, (left + width - right) / 2, height - 4, "middle", "name"),
    makeSvg("text", {
      class: "name", "text-anchor": "middle",
      transform: `translate(11 ${(top + height - bottom) / 2}) rotate(-90)`,
    }, yLabel));
  for (const { points, kind } of lines) {
    const known = points.filter((p) => p[0] !== null && p[1] !== null);
    if (!known.length) continue;
    const way = (side) => known.map((p) =>
      `${atX(p[0] + side * ex(p)).toFixed(1)} ${atY(p[1] + side * ey(p)).toFixed(1)}`);
    svg.append(
      makeSvg("path", {
        class: `band ${kind}`,
        d: `M${[...way(1), ...way(-1).reverse()].join("L")}Z`,
      }),
      makeSvg("path", { class: `line ${kind}`, d: `M${way(0).join("L")}` }));
  }
}
