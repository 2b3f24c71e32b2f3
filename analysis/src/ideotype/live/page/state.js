// SPDX-License-Identifier: Apache-2.0
// The state of the page, undo, and messages to and from the program.

const page = {
  hello: null,
  shown: null, // {genome, conditions, component, reference}
  past: [], future: [],
  number: 0, sent: 0, answered: 0, isBusy: false,
  latencies: [],
};
const MOST_STEPS = 200;
const listeners = { hello: [], picture: [], numbers: [], improved: [], changed: [], link: [] };

function when(kind, work) {
  listeners[kind].push(work);
}

function happen(kind, ...words) {
  for (const work of listeners[kind]) work(...words);
}

function copyOf(shown) {
  return { ...shown, genome: [...shown.genome], conditions: { ...shown.conditions } };
}

// Stores the present plant for undo, before a change.
function remember() {
  page.past.push(copyOf(page.shown));
  if (page.past.length > MOST_STEPS) page.past.shift();
  page.future = [];
}

function step(from, to) {
  if (!from.length) return;
  to.push(copyOf(page.shown));
  page.shown = from.pop();
  happen("changed");
  show();
}
const undo = () => step(page.past, page.future);
const redo = () => step(page.future, page.past);

// Changes the plant or its conditions in part.
function change(part) {
  Object.assign(page.shown, part);
  happen("changed");
  show();
}

// Requests the evaluation of the plant in the view. While an answer is pending
// only the last change waits.
let changedAt = 0;
function show() {
  page.number += 1;
  changedAt = performance.now();
  if (!page.isBusy) send();
}

let socket = null;
function send() {
  if (!socket || socket.readyState !== WebSocket.OPEN) return;
  page.isBusy = true;
  page.sent = page.number;
  page.sentAt = changedAt;
  sendMessage({ kind: "show", number: page.sent, ...page.shown });
}

function sendMessage(message) {
  socket.send(JSON.stringify(message));
}

// The last request is answered; later changes are sent next.
function settle() {
  page.isBusy = false;
  if (page.number > page.sent) send();
}

const heard = {
  hello(message) {
    page.hello = message;
    const fits = page.shown && page.shown.genome.length === message.genome.length;
    if (!fits) {
      const { genome, conditions } = message;
      page.shown = copyOf({ genome, conditions, component: 0, reference: null });
      [page.past, page.future] = [[], []];
    }
    page.isBusy = false;
    happen("hello", message);
    happen("changed");
    show();
  },
  picture(message) {
    happen("picture", message);
  },
  numbers(message) {
    announce("");
    if (page.answered < message.number) {
      page.answered = message.number;
      page.latencies.push(performance.now() - page.sentAt);
      if (page.latencies.length > 500) page.latencies.shift();
    }
    happen("numbers", message);
    document.body.dataset.number = message.number;
    document.body.dataset.final = Boolean(message.is_final);
    if (page.isBusy) settle();
  },
  problem(message) {
    announce(message.text, true);
    settle();
  },
  improved(message) {
    happen("improved", message);
  },
};

function connect() {
  socket = new WebSocket(new URL("talk", location.href.replace(/^http/, "ws")));
  socket.addEventListener("message", (event) => {
    const message = JSON.parse(event.data);
    // Answers to earlier requests are dropped.
    if (["picture", "numbers"].includes(message.kind) && message.number < page.sent) return;
    heard[message.kind](message);
  });
  socket.addEventListener("open", () => happen("link", true));
  socket.addEventListener("close", () => {
    page.isBusy = false;
    happen("link", false);
    setTimeout(connect, 2000);
  });
}
