// SPDX-License-Identifier: Apache-2.0
// Buttons, keys, files, and the search for a better plant.

let search = null;
let searches = 0;

function showImproved(message) {
  if (!search || message.number !== search.number) return;
  byId("progress").value = message.done || 0;
  if (message.genome) {
    page.shown.genome = message.genome;
    happen("changed");
    // The picture follows; the search has the processors.
    show();
  }
  if (!message.is_final) {
    byId("improve-text").textContent =
      `${message.done} of ${message.of} plants evaluated. Gains are provisional until the best plants are re-evaluated …`;
    return;
  }
  endSearch();
  byId("improve-text").textContent = formatGain(message);
}

function formatGain(message) {
  if (message.problem) return message.problem;
  const quantity = page.hello.quantities.find((q) => q.name === message.goal);
  const name = quantity.label;
  if (!message.is_better)
    return `No better plant for “${name}” in ${message.done} evaluations; your plant is restored.`;
  const error = halfWidth(message.standard_error);
  const digits = digitsFor(message.gain, error);
  return `${formatSigned(message.gain, digits)} ± ${error.toFixed(digits)} `
    + `${plainUnit(quantity.unit)} in “${name}” after ${message.done} evaluations, re-evaluated `
    + "with independent random numbers. Undo restores your plant.";
}

function endSearch() {
  search = null;
  byId("progress").hidden = true;
  byId("improve").textContent = "Improve from here";
  byId("improve").classList.replace("is-stop", "primary");
}

function improve() {
  if (search) {
    sendMessage({ kind: "stop" });
    byId("improve-text").textContent = "Stopping; the best plant is being re-evaluated …";
    return;
  }
  remember();
  searches += 1;
  search = { number: searches };
  byId("progress").hidden = false;
  byId("progress").value = 0;
  byId("progress").max = page.hello.evaluations;
  byId("improve").textContent = "Stop";
  byId("improve").classList.replace("primary", "is-stop");
  byId("improve-text").textContent = "Evaluating the first plants …";
  sendMessage({ kind: "improve", number: searches, goal: byId("goal").value, ...page.shown });
}

function offer(blob, name) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

async function save(form) {
  byId("save-menu").open = false;
  const name = page.hello.title.replace(/[^\w-]+/g, "_") || "plant";
  if (form === "picture") {
    pictureOf().toBlob((blob) => offer(blob, `${name}.png`));
    return;
  }
  const answer = await fetch(`save/${form}`, {
    method: "POST", body: JSON.stringify(page.shown),
  });
  if (!answer.ok) {
    announce(`Not saved: ${await answer.text()}`, true);
    return;
  }
  offer(await answer.blob(), `${name}_${form}.toml`);
  announce(form === "crop"
    ? "Saved as a crop file; “ideotype play FILE” opens it again."
    : "Saved as a campaign; “ideotype run FILE” optimises from this plant.");
}

// A picture of the view, with its main numbers below.
function pictureOf() {
  const view = byId("view");
  const dense = view.width / view.clientWidth;
  const canvas = make("canvas", { width: view.width, height: view.height + 92 * dense });
  const context = canvas.getContext("2d");
  context.fillStyle = "#fff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(view, 0, 0);
  context.scale(dense, dense);
  context.fillStyle = "#17231d";
  const texts = page.hello.quantities.filter((q) => q.is_key).map((q) => {
    const [value, standardError] = field.numbers.numbers[q.name];
    const error = halfWidth(standardError);
    return `${q.label} ${formatNumber(value, error)} ${formatError(value, error)} ${plainUnit(q.unit)}`;
  });
  const top = view.clientHeight;
  context.font = "600 15px system-ui, sans-serif";
  context.fillText(`${page.hello.title} — ideotype`, 14, top + 22);
  context.font = "13px system-ui, sans-serif";
  const { conditions } = page.shown;
  context.fillText(`${conditions.density.toFixed(1)} plants/m², rows ${(100 * conditions.row).toFixed(0)} cm`,
    14, top + 42);
  const half = Math.ceil(texts.length / 2);
  context.fillText(texts.slice(0, half).join("   "), 14, top + 62, view.clientWidth - 28);
  context.fillText(texts.slice(half).join("   "), 14, top + 80, view.clientWidth - 28);
  return canvas;
}

function keep() {
  const isKept = Boolean(page.shown.reference);
  remember();
  change({ reference: isKept ? null : [...page.shown.genome] });
  if (!isKept) byId("pair").checked = true;
}

function startAgain() {
  remember();
  change({ genome: [...page.hello.genome], conditions: { ...page.hello.conditions } });
}

function listen() {
  listenToView();
  byId("undo").addEventListener("click", undo);
  byId("redo").addEventListener("click", redo);
  byId("again").addEventListener("click", startAgain);
  byId("keep").addEventListener("click", keep);
  byId("improve").addEventListener("click", improve);
  byId("all").addEventListener("toggle", () => field.numbers && showNumbers(field.numbers));
  for (const button of document.querySelectorAll("[data-save]"))
    button.addEventListener("click", () => save(button.dataset.save));
  for (const button of document.querySelectorAll("[data-when]"))
    button.addEventListener("click", () => {
      remember();
      change({ conditions: { ...page.shown.conditions, when: button.dataset.when } });
    });
  for (const button of document.querySelectorAll("[data-tab]"))
    button.addEventListener("click", () => chooseTab(button.dataset.tab));
  byId("panels").addEventListener("change", () => {
    remember();
    change({ conditions: { ...page.shown.conditions, panels: byId("panels").checked } });
  });
  byId("component").addEventListener("change", () => {
    change({ component: byId("component").selectedIndex });
    buildSliders();
  });
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey)) return;
    const key = event.key.toLowerCase();
    const isRedo = key === "y" || (key === "z" && event.shiftKey);
    if (key !== "z" && !isRedo) return;
    event.preventDefault();
    (isRedo ? redo : undo)();
  });
}

function chooseTab(name) {
  for (const button of document.querySelectorAll("[data-tab]"))
    button.setAttribute("aria-pressed", String(button.dataset.tab === name));
  for (const panel of document.querySelectorAll("[data-panel]"))
    panel.hidden = panel.dataset.panel !== name;
}

when("hello", (message) => {
  document.title = `${message.title} · ideotype play`;
  byId("title").textContent = message.title;
  byId("about").textContent = message.about;
  byId("component").replaceChildren(
    ...message.components.map((name) => new Option(name)));
  byId("component").selectedIndex = page.shown.component;
  byId("component").parentElement.hidden = message.components.length < 2;
  byId("goal").replaceChildren(...message.goals.map((name) =>
    new Option(message.quantities.find((q) => q.name === name).label, name)));
  document.querySelector("[data-when=season]").hidden =
    message.conditions.when !== "season";
  for (const name of ["day", "hour"])
    document.querySelector(`[data-when=${name}]`).hidden = !message.has_days;
  byId("latitude-text").textContent =
    `The weather of the season is that of latitude ${message.conditions.latitude}°.`
    + (message.has_days ? " Choose a clear day to change the latitude." : "");
  buildSliders();
});
when("changed", () => {
  refreshSliders();
  byId("keep").textContent = page.shown.reference
    ? "Use the initial plant as reference" : "Set as reference";
});
when("numbers", showNumbers);
when("improved", showImproved);
when("link", (isOpen) => {
  byId("lost").hidden = isOpen;
  if (!isOpen && search) endSearch();
});

listen();
chooseTab("plant");
connect();
