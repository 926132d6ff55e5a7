// SPDX-License-Identifier: Apache-2.0
// Live page: the compiled model runs here; sliders set its inputs and parameters, curves and scene follow.
"use strict";

const model = JSON.parse(document.getElementById("pp-model").textContent);
const bytes = Uint8Array.from(atob(document.getElementById("pp-code").textContent.trim()), (c) => c.charCodeAt(0));
// the module imports nothing that it calls: names of the system are bound to functions that end the run
const absent = new Proxy({}, { get: (_, name) => () => { throw new Error(`call of ${String(name)}`); } });
const module = new WebAssembly.Module(bytes);
const imports = Object.fromEntries(WebAssembly.Module.imports(module).map((each) => [each.module, absent]));
const code = new WebAssembly.Instance(module, imports).exports;
if (code._initialize) code._initialize();

const text = (s) => {
  const data = new TextEncoder().encode(s + "\0"), at = code.malloc(data.length);
  new Uint8Array(code.memory.buffer).set(data, at);
  return at;
};
const doubles = (at, n) => new Float64Array(code.memory.buffer, at, n);
const words = (at, n) => new Uint32Array(code.memory.buffer, at, n);

for (const each of model.settable) each.value = each.start;
const run = {
  one: code.fmi3InstantiateCoSimulation(text("live"), text(model.token), text(""), 0, 0, 0, 0, 0, 0, 0, 0, 0),
  reference: code.malloc(4), value: code.malloc(8), flags: code.malloc(32),
  references: code.malloc(4 * model.outputs.length), values: code.malloc(8 * model.outputs.length),
  steps: 0, failed: false,
  begin() {
    code.fmi3EnterInitializationMode(this.one, 0, 0, model.start, 0, 0);
    for (const each of model.settable) {
      if (!each.references && each.given) this.set(each.reference, each.value);
      else if (each.references) each.references.forEach((k, i) => this.set(k, each.values[i] * (each.value / each.start)));
    }
    this.failed = code.fmi3ExitInitializationMode(this.one) > 1; // 1: no equilibrium was found, the run starts with a transient
    this.steps = 0;
    // the model has balanced loads that were not given
    for (const each of model.settable) if (!each.references) each.value = this.read(each.reference);
  },
  read(reference) {
    words(this.reference, 1)[0] = reference;
    code.fmi3GetFloat64(this.one, this.reference, 1, this.value, 1);
    return doubles(this.value, 1)[0];
  },
  reset() { code.fmi3Reset(this.one); this.begin(); },
  set(reference, value) {
    words(this.reference, 1)[0] = reference;
    doubles(this.value, 1)[0] = value;
    return code.fmi3SetFloat64(this.one, this.reference, 1, this.value, 1);
  },
  get time() { return model.start + this.steps * model.sample; },
  step() {
    const at = this.flags;
    if (code.fmi3DoStep(this.one, this.time, model.sample, 1, at, at + 4, at + 8, at + 16)) this.failed = true;
    else this.steps += 1;
    return !this.failed;
  },
  get() {
    words(this.references, model.outputs.length).set(model.outputs.map((each) => each.reference));
    const n = model.outputs.length;
    code.fmi3GetFloat64(this.one, this.references, n, this.values, n);
    return doubles(this.values, n);
  },
};
run.begin();

// ------------------------------------------------------------------------------------------------- controls

const make = (tag, attributes = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), attributes);
  element.append(...children);
  return element;
};
const controls = document.getElementById("controls"), plots = document.getElementById("plots");
const status = document.getElementById("status"), button = document.getElementById("run");
const pace = document.getElementById("pace"), timeScale = document.getElementById("scale");
pace.value = Math.min(0, Math.max(-5, Math.log10(200 * model.sample)));  // 200 samples per second

for (const each of model.settable) {
  const span = Math.abs(each.start) || 1 / each.factor, { least: floor = -Infinity, most: ceiling = Infinity } = each;
  const least = Math.max(floor, each.start - span), most = Math.min(ceiling, each.start + span);
  const shown = (value) => Number((value * each.factor).toPrecision(6)), unit = each.unit === "1" ? "" : ` ${each.unit}`;
  const slider = make("input", { type: "range", min: 0, max: 400, step: 1, value: (400 * (each.start - least)) / (most - least) });
  const number = make("input", { type: "number", step: "any", value: shown(each.start) });
  const note = make("output", { className: "note" });
  const change = (value) => {
    note.textContent = "";
    if (!Number.isFinite(value)) note.textContent = "not a number: unchanged";
    else {
      const limited = Math.min(Math.max(value, floor), ceiling), before = each.value;
      if (limited !== value) note.textContent = `${shown(value)}${unit} is ${value < limited ? "below" : "above"} the range: set to ${shown(limited)}${unit}`;
      each.value = limited;
      each.given = true;
      if (each.references) begin();
      else if (run.set(each.reference, limited) > 1) {
        each.value = before;
        note.textContent = `${shown(value)}${unit} is refused: unchanged`;
      }
    }
    each.show();
  };
  each.show = () => {
    slider.value = (400 * (each.value - least)) / (most - least);
    number.value = shown(each.value);
  };
  slider.setAttribute("aria-label", `${each.name}, slider`);
  number.setAttribute("aria-label", each.name);
  slider.addEventListener("input", () => change(least + (slider.valueAsNumber / 400) * (most - least)));
  number.addEventListener("change", () => change(number.valueAsNumber / each.factor));
  const ends = make("div", { className: "ends" }, make("span", { textContent: shown(least) }), make("span", { textContent: shown(most) }));
  controls.append(make("div", { className: "control" }, make("span", {}, ...each.name.split(/(?<=[._])/).flatMap((part) => [part, make("wbr")])), make("div", {}, number, make("span", { textContent: unit })), slider, ends, note));
}

let running = true;
button.addEventListener("click", () => { running = !running; show(); });
const begin = () => { run.reset(); clear(); running = true; show(); model.settable.forEach((each) => each.show()); };
document.getElementById("reset").addEventListener("click", begin);
const show = () => {
  button.textContent = running && !run.failed ? "Pause" : "Run";
  button.disabled = run.failed;
};

// --------------------------------------------------------------------------------------------------- curves

const ROOM = 1000, GUTTER = 64, FOOT = 20;
const samples = { t: new Float64Array(ROOM), y: model.shown.map(() => new Float64Array(ROOM)), n: 0, next: 0 };
const clear = () => { samples.n = samples.next = 0; };
const colours = getComputedStyle(document.documentElement);
const ink = (name) => colours.getPropertyValue(`--pp-${name}`).trim();
const curves = model.shown.map((chosen, k) => {
  const select = make("select");
  select.setAttribute("aria-label", `channel of curve ${k + 1}`);
  model.outputs.forEach((each, i) => select.append(make("option", { value: i, textContent: `${each.name}${each.unit === "1" ? "" : `, ${each.unit}`}`, selected: i === chosen })));
  select.addEventListener("change", clear);
  const range = make("output"), canvas = make("canvas");
  plots.append(make("figure", {}, make("figcaption", {}, select, range), canvas));
  return { select, range, canvas };
});

const keep = () => {
  const all = run.get();
  samples.t[samples.next] = run.time;
  curves.forEach((curve, k) => {
    const i = Number(curve.select.value);
    samples.y[k][samples.next] = all[i] * model.outputs[i].factor;
  });
  samples.next = (samples.next + 1) % ROOM;
  samples.n = Math.min(samples.n + 1, ROOM);
};
const digits = (x) => (x === 0 ? "0" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e6 ? Number(x.toPrecision(5)).toString() : x.toExponential(3));

/** Round values from low to high, at most `most` of them, and their number of decimals. */
const ticks = (low, high, most) => {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((k) => k * power >= rough * (1 - 1e-9)), found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  if (found.length < 2 && most < 8) return ticks(low, high, 2 * most);
  return { found, places: Math.min(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), 12) };
};
/** Label of a tick; very large and very small numbers with an exponent. */
const label = (x, places) => (Math.abs(x) >= 1e6 || places > 6 ? Number(x.toPrecision(6)).toExponential() : x.toFixed(places).replace(/^-(0(\.0*)?)$/, "$1"));

const draw = (curve, values) => {
  const canvas = curve.canvas, scale = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const c = canvas.getContext("2d");
  c.scale(scale, scale);
  const first = (samples.next - samples.n + ROOM) % ROOM;
  let low = Infinity, high = -Infinity;
  for (let k = 0; k < samples.n; k++) {
    const y = values[(first + k) % ROOM];
    if (y < low) low = y;
    if (y > high) high = y;
  }
  curve.range.textContent = "";
  if (!(high >= low)) return;
  const middle = (low + high) / 2, half = Math.max((high - low) / 2, 1e-9 * Math.abs(middle), 1e-300) * 1.08;
  const bottom = height - FOOT, inner = bottom - 8;
  const shown = [125, 250, 500, ROOM].find((n) => n >= samples.n), begin = samples.t[first], span = (shown - 1) * model.sample, unit = begin + span < 1 ? 1e3 : 1; // ms or s
  const acrossTo = (t) => GUTTER + ((width - GUTTER - 8) * (t - begin)) / span, upTo = (y) => 4 + inner * (0.5 - (y - middle) / (2 * half));
  c.strokeStyle = ink("grid");
  c.fillStyle = ink("soft");
  c.font = "11px system-ui, sans-serif";
  const line = (x1, y1, x2, y2) => { c.beginPath(); c.moveTo(x1, y1); c.lineTo(x2, y2); c.stroke(); };
  c.textAlign = "right";
  const upright = ticks(middle - half, middle + half, Math.max(2, Math.floor(inner / 34)));
  for (const y of upright.found) {
    line(GUTTER, upTo(y), width - 8, upTo(y));
    c.fillText(label(y, upright.places), GUTTER - 6, Math.min(Math.max(upTo(y) + 4, 10), bottom));
  }
  const words = unit === 1 ? "s" : "ms", flat = ticks(begin * unit, (begin + span) * unit, Math.max(2, Math.floor((width - GUTTER) / 70)));
  c.textAlign = "center";
  for (const t of flat.found) {
    const x = acrossTo(t / unit);
    line(x, 4, x, bottom + 3);
    if (x < width - 42) c.fillText(label(t, flat.places), x, height - 4);
  }
  c.textAlign = "right";
  c.fillText(words, width - 8, height - 4);
  line(GUTTER, bottom, width - 8, bottom);
  c.strokeStyle = ink("curve");
  c.lineWidth = 1.4;
  c.beginPath();
  for (let k = 0; k < samples.n; k++) {
    const i = (first + k) % ROOM;
    if (k) c.lineTo(acrossTo(samples.t[i]), upTo(values[i]));
    else c.moveTo(acrossTo(samples.t[i]), upTo(values[i]));
  }
  c.stroke();
  curve.range.textContent = `${digits(low)} ... ${digits(high)}`;
};

// ---------------------------------------------------------------------------------------------------- scene

/** Matrix (three rows) of a quaternion x, y, z, w. */
const rotation = ([x, y, z, w]) => [
  [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
  [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
  [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
];
/** Quaternion of a rotation matrix, written to `out`. */
const quaternion = (r, out) => {
  const trace = r[0][0] + r[1][1] + r[2][2];
  const squares = [1 + 2 * r[0][0] - trace, 1 + 2 * r[1][1] - trace, 1 + 2 * r[2][2] - trace, 1 + trace];
  const k = squares.indexOf(Math.max(...squares)), s = 2 * Math.sqrt(squares[k]);
  if (k === 3) out.set([(r[2][1] - r[1][2]) / s, (r[0][2] - r[2][0]) / s, (r[1][0] - r[0][1]) / s, s / 4]);
  else {
    const i = (k + 1) % 3, j = (k + 2) % 3;
    out[3] = (r[j][i] - r[i][j]) / s;
    out[k] = s / 4;
    out[i] = (r[i][k] + r[k][i]) / s;
    out[j] = (r[j][k] + r[k][j]) / s;
  }
};
const back = (r, v) => [0, 1, 2].map((k) => r[0][k] * v[0] + r[1][k] * v[1] + r[2][k] * v[2]);
const product = (a, b) => [0, 1, 2].map((k) => back(a, b.map((row) => row[k]))); // columns of a transposed times b
/** Origin, axes that do not spin, and angle of a body in the memory of the model. */
const frameOf = (at, b) => {
  const { size, r, R, phi } = model.follow.frame, first = at + b * size, m = doubles(first + R, 9);
  return { r: [...doubles(first + r, 3)], R: [[m[0], m[1], m[2]], [m[3], m[4], m[5]], [m[6], m[7], m[8]]], phi: doubles(first + phi, 1)[0] };
};
const turned = ({ R, phi }) => {
  const c = Math.cos(phi), s = Math.sin(phi);
  return R.map(([x, y, z]) => [c * x + s * y, c * y - s * x, z]);
};
const row = (n) => ({ data: new Float64Array(n), shape: [1, n], width: n, count: 1 });
/** Poses and forces of the present state, as tables of the scene with one row. */
const poses = (scene) => {
  const at = code.live_frames(run.one), all = run.get();
  scene.bodies.forEach((body, k) => {
    const numbers = model.follow.bodies[k];
    if (!numbers) return;
    const own = frameOf(at, numbers[0]), parent = frameOf(at, numbers[1]);
    const inverse = turned(parent);
    body.rest ??= rotation(body.axes);
    body.travel ??= row(3);
    body.quaternion ??= row(4);
    body.spin ??= row(1);
    const place = back(inverse, own.r.map((x, i) => x - parent.r[i]));
    body.travel.data.set(back(body.rest, place.map((x, i) => x - body.place[i])));
    const columns = product(inverse, own.R), axes = [0, 1, 2].map((i) => columns.map((column) => column[i]));
    const relative = product(body.rest, axes);
    quaternion([0, 1, 2].map((i) => relative.map((column) => column[i])), body.quaternion.data);
    body.spin.data[0] = own.phi;
  });
  scene.arrows.forEach((arrow, k) => {
    const { state, components } = model.follow.arrows[k];
    for (const [part, terms] of Object.entries(components)) {
      const sum = new Float64Array(3);
      for (const [channel, ...vector] of terms) vector.forEach((x, i) => { sum[i] += x * all[channel]; });
      arrow.components[part].data = sum;
    }
    if (state >= 0) arrow.state.data = Uint8Array.of(Math.round(all[state]) & 255);
  });
};
let scene = false;
if (model.follow)
  pitchpointViewer.mount(document.getElementById("scene"), { start: model.follow.start }).then((shown) => { scene = shown; });

// ----------------------------------------------------------------------------------------------------- loop

let before = performance.now(), owed = 0, rate = 0;
const frame = () => {
  const now = performance.now(), passed = Math.min(now - before, 100) * 1e-3;
  before = now;
  const room = Math.max(12, 500 * passed); // a slow drawing leaves half of the time to the model
  if (running && !run.failed) {
    owed += (passed * 10 ** Number(pace.value)) / model.sample;
    let done = 0;
    while (owed >= 1 && performance.now() - now < room && run.step()) { keep(); owed -= 1; done += 1; }
    owed = Math.min(owed, 1);
    rate = 0.9 * rate + (0.1 * done * model.sample) / Math.max(passed, 1e-3);
  }
  curves.forEach((curve, k) => draw(curve, samples.y[k]));
  if (scene) pitchpointViewer.live(poses);
  const asked = 10 ** -Number(pace.value);
  timeScale.textContent = asked < 1.05 ? "real time" : `1 : ${Number(asked.toPrecision(2))}`;
  const slower = rate > 0 ? `, ${rate >= 0.5 ? "real time" : `${digits(Number((1 / rate).toPrecision(2)))} times slower than real time`}` : "";
  status.textContent = run.failed
    ? `The run has failed at ${digits(run.time)} s: reset it, with smaller changes.`
    : `${run.time.toFixed(5)} s${running ? slower : ", paused"}`;
  show();
  requestAnimationFrame(frame);
};
window.live = { run, model, poses, ticks };
requestAnimationFrame(frame);
