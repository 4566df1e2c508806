// Draws the sweeps in #data and the motion at the point chosen. No library, no network.
"use strict";

const { colour, highest, sweeps } = JSON.parse(document.getElementById("data").textContent);
const at = (id) => document.getElementById(id);
const INK = "#1a1a1a", ORBIT = "#56789a", DOT = "#d55e00", LINE = "#0072b2";
let chosen = 0, point = 0, shown = null;

// ---- data

const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
const unpacked = ({ low, step, data }) => Float64Array.from(new Uint16Array(bytes(data)), (n) => low + step * n);
const starts = (counts) => counts.reduce((ends, count) => [...ends, ends[ends.length - 1] + count], [0]);

function opened(sweep) {
  if (sweep.opened) return sweep;
  sweep.section = sweep.section.map(unpacked);
  sweep.orbit = sweep.orbit.map(unpacked);
  sweep.spectrum = new Float32Array(bytes(sweep.spectrum));
  for (const counts of ["dots", "samples", "lines"]) sweep[counts] = starts(sweep[counts]);
  sweep.opened = true;
  return sweep;
}

function motion(sweep, i) {
  const cut = (array, ends) => array.subarray(ends[i], ends[i + 1]);
  const [displacement, velocity, force] = sweep.orbit.map((array) => cut(array, sweep.samples));
  const periods = Math.max(displacement.length - 1, 0) / sweep.steps;
  return {
    value: sweep.value[i], rpm: sweep.rpm[i], motion: sweep.class[i], period: sweep.period[i],
    exponent: sweep.exponent[i], loss: sweep.loss[i], peak: sweep.peak[i],
    section: sweep.section.map((array) => cut(array, sweep.dots)),
    displacement, velocity, force, periods, lines: cut(sweep.spectrum, sweep.lines),
  };
}

// ---- drawing

function ticks(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough);
  const count = Math.floor(high / step + 1e-9) - Math.ceil(low / step - 1e-9) + 1;
  return Array.from({ length: count }, (_, n) => Number(((Math.ceil(low / step - 1e-9) + n) * step).toPrecision(10)));
}

function range(values, room = 0.05) {
  let low = Infinity, high = -Infinity;
  for (const value of values) if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
  if (low > high) return [0, 1];
  const more = (high - low) * room || Math.abs(low) * 0.01 || 1;
  return [low - more, high + more];
}

const word = (number) => String(number).replace("-", "−");

// A frame with axes; returns its markup and the scales. Lengths in pixels.
function frame({ width, top, height, left = 62, right = 8, x, y, label, title, decades = false, foot = true }) {
  const px = (value) => left + (value - x[0]) / (x[1] - x[0]) * (width - left - right);
  const py = (value) => top + height - (value - y[0]) / (y[1] - y[0]) * height;
  let marks = `<rect x="${left}" y="${top}" width="${width - left - right}" height="${height}" fill="none" stroke="#777"/>`;
  for (const tick of ticks(...x, Math.max(width / 90, 4))) {
    marks += `<path d="M${px(tick)} ${top + height}v4" stroke="#777"/>`;
    if (foot) marks += `<text x="${px(tick)}" y="${top + height + 16}" text-anchor="middle">${word(tick)}</text>`;
  }
  for (const tick of ticks(...y, Math.max(height / 40, 3)).filter((value) => !decades || Number.isInteger(value))) {
    const shownTick = decades ? `10<tspan dy="-4" font-size="8">${word(tick)}</tspan>` : word(tick);
    marks += `<path d="M${left} ${py(tick)}h-4" stroke="#777"/>`;
    marks += `<text x="${left - 6}" y="${py(tick) + 4}" text-anchor="end">${shownTick}</text>`;
  }
  if (label) marks += `<text x="${(left + width - right) / 2}" y="${top + height + 32}" text-anchor="middle">${label}</text>`;
  const middle = top + height / 2;
  marks += `<text transform="translate(11 ${middle}) rotate(-90)" text-anchor="middle">${title}</text>`;
  return { px, py, marks };
}

const placed = (number) => number.toFixed(1);
const dots = (xs, ys, size, tint) => {
  let path = "";
  for (let i = 0; i < xs.length; i++) path += `M${placed(xs[i])} ${placed(ys[i])}h0`;
  return `<path d="${path}" stroke="${tint}" stroke-width="${size}" stroke-linecap="round" fill="none"/>`;
};
const line = (xs, ys, tint, thick) => {
  let path = "";
  for (let i = 0; i < xs.length; i++) path += `${i ? "L" : "M"}${placed(xs[i])} ${placed(ys[i])}`;
  return `<path d="${path}" stroke="${tint}" stroke-width="${thick}" stroke-linejoin="round" fill="none"/>`;
};
const scaled = (values, scale) => Array.from(values, scale);

function into(id, height, marks) {
  at(id).innerHTML = `<svg role="img" aria-label="${id}" height="${height}">${marks}</svg>`;
}

let across = null;  // value of the sweep -> pixel, of the diagram on the screen

function drawDiagram(sweep) {
  const width = at("diagram").clientWidth, small = width < 600, high = small ? 180 : 250;
  const count = sweep.value.length, x = [sweep.value[0], sweep.value[count - 1]];
  const body = frame({ width, top: 20, height: high, x, y: range(sweep.section[0]), title: "Displacement", foot: false });
  const lyapunov = range(sweep.exponent);
  const foot = frame({ width, top: high + 28, height: 60, x, y: [Math.min(lyapunov[0], 0), Math.max(lyapunov[1], 0.01)],
    title: "Exponent", label: sweep.label });
  across = body.px;
  let strip = "";
  for (let i = 0; i < count; i++) {
    const from = across((sweep.value[Math.max(i - 1, 0)] + sweep.value[i]) / 2);
    const to = across((sweep.value[Math.min(i + 1, count - 1)] + sweep.value[i]) / 2);
    strip += `<rect x="${placed(from)}" y="0" width="${(to - from + 0.3).toFixed(2)}" height="14" fill="${colour[sweep.class[i]]}" shape-rendering="crispEdges"/>`;
  }
  const xs = [], ys = [];
  for (let i = 0; i < count; i++) {
    const first = sweep.dots[i], many = sweep.dots[i + 1] - first, step = Math.max(1, Math.ceil(many / sweep.most_dots));
    for (let k = 0; k < many; k += step) { xs.push(across(sweep.value[i])); ys.push(body.py(sweep.section[0][first + k])); }
  }
  const known = sweep.exponent.map((_, i) => i).filter((i) => sweep.exponent[i] !== null);
  const marks = strip + body.marks + dots(xs, ys, 1.6, INK) + foot.marks
    + `<path d="M${across(x[0])} ${foot.py(0)}H${across(x[1])}" stroke="#777" stroke-dasharray="3 3"/>`
    + line(known.map((i) => across(sweep.value[i])), known.map((i) => foot.py(sweep.exponent[i])), DOT, 1)
    + `<path id="here" stroke="${LINE}" stroke-width="2" opacity="0.75"/>`;
  into("diagram", high + 126, marks);
}

function drawPanels(sweep, now) {
  const width = at("section").clientWidth, size = { width, top: 8, height: Math.min(220, width * 0.75) }, high = size.height + 46;
  const displacement = `Displacement over ${sweep.unit}`;
  const [sx, sv] = now.section;
  const near = frame({ ...size, x: range(sx, 0.15), y: range(sv, 0.15), label: displacement, title: "Velocity" });
  const big = now.period ? 6 : 2;
  into("section", high, near.marks + dots(scaled(sx, near.px), scaled(sv, near.py), big, DOT));
  const plane = frame({ ...size, x: range([...now.displacement, ...sx]), y: range([...now.velocity, ...sv]), label: displacement, title: "Velocity" });
  into("portrait", high, plane.marks + line(scaled(now.displacement, plane.px), scaled(now.velocity, plane.py), ORBIT, now.period ? 1.4 : 0.5)
    + dots(scaled(sx, plane.px), scaled(sv, plane.py), now.period ? 6 : 2, DOT));
  const time = frame({ ...size, x: [0, 1], y: range([0, ...now.force]), label: "Mesh phase", title: "Force over mean" });
  let curves = `<path d="M${time.px(0)} ${time.py(1)}H${time.px(1)}" stroke="#999" stroke-dasharray="3 3"/>`;
  for (let n = 0; n < now.periods; n++) {
    const part = now.force.subarray(n * sweep.steps, (n + 1) * sweep.steps + 1);
    curves += line(scaled(part, (_, i) => time.px(i / sweep.steps)), scaled(part, time.py), LINE, now.period ? 1.4 : 0.6);
  }
  into("force", high, time.marks + curves);
  const floor = -5, levels = Array.from(now.lines, (value) => Math.max(Math.log10(value), floor));
  const orders = frame({ ...size, x: [0, highest], y: [floor, Math.max(range(levels, 0)[1] + 0.3, floor + 1)], label: "Order of the mesh frequency",
    title: "Amplitude over mean", decades: true });
  let stems = "";
  levels.forEach((level, i) => { if (level > floor) stems += `M${placed(orders.px((i + 1) / now.periods))} ${placed(orders.py(floor))}V${placed(orders.py(level))}`; });
  into("spectrum", high, orders.marks + `<path d="${stems}" stroke="${LINE}" stroke-width="${now.periods > 4 ? 1 : 2.5}"/>`);
}

// ---- choosing

const number = (value, figures) => value === null ? "unknown" : word(Number(value.toPrecision(figures)));
const kinds = { CH: "chaotic", QP: "quasi-periodic", not_converged: "motion not decided" };

function sentence(sweep, now) {
  const kind = kinds[now.motion] || `${now.motion}, repeats ${now.period === 1 ? "every mesh period" : `after ${now.period} mesh periods`}`;
  const loss = now.loss === null ? "unknown" : `${number(100 * now.loss, 3)} % of the time`;
  return `${sweep.title}${sweep.condition ? `, ${sweep.condition}` : ""}. ${sweep.label} ${number(now.value, 5)}${now.rpm === null ? "" : ` (${Math.round(now.rpm)} rpm)`}: `
    + `${kind}; Lyapunov exponent ${number(now.exponent, 3)}; out of contact ${loss}; peak force ${number(now.peak, 4)} times the mean.`;
}

function show() {
  const sweep = sweeps[chosen];
  shown = motion(sweep, point);
  at("here").setAttribute("d", `M${across(shown.value)} 0v${at("diagram").querySelector("svg").clientHeight - 40}`);
  drawPanels(sweep, shown);
  const said = sentence(sweep, shown), slider = at("diagram");
  at("said").textContent = said;
  for (const [name, value] of [["min", 0], ["max", sweep.value.length - 1], ["now", point], ["text", said]]) slider.setAttribute(`aria-value${name}`, value);
  history.replaceState(null, "", `#${sweep.case}/${sweep.sweep}/${point}`);
}

function choose(sweep, i) {
  chosen = sweep;
  point = Math.min(Math.max(i, 0), sweeps[chosen].value.length - 1);
  at("choice").value = chosen;
  drawDiagram(opened(sweeps[chosen]));
  show();
}

function walk(i) {
  const wanted = Math.min(Math.max(i, 0), sweeps[chosen].value.length - 1);
  if (wanted !== point) { point = wanted; show(); }
}

function nearest(event) {
  const x = event.clientX - at("diagram").getBoundingClientRect().left, values = sweeps[chosen].value;
  return values.reduce((best, value, i) => Math.abs(across(value) - x) < Math.abs(across(values[best]) - x) ? i : best, 0);
}

// The first view: a motion with a subharmonic, if the sweep has one.
const opening = (sweep) => Math.max(sweep.period.findIndex((period) => period > 1), 0) || Math.floor(sweep.value.length / 2);

at("choice").addEventListener("change", () => choose(Number(at("choice").value), opening(sweeps[Number(at("choice").value)])));
at("diagram").addEventListener("pointerdown", (event) => {
  at("diagram").setPointerCapture(event.pointerId);
  walk(nearest(event));
});
at("diagram").addEventListener("pointermove", (event) => { if (event.buttons) walk(nearest(event)); });
at("diagram").addEventListener("keydown", (event) => {
  const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity };
  if (!(event.key in steps)) return;
  event.preventDefault();
  walk(point + steps[event.key]);
});
// Once a frame at most, and before it is painted: what is on the screen always has the width of its place.
let width = at("diagram").clientWidth;
new ResizeObserver(() => {
  if (at("diagram").clientWidth === width) return;
  width = at("diagram").clientWidth;
  choose(chosen, point);
}).observe(at("diagram"));

const [ofCase, ofSweep, ofPoint] = location.hash.slice(1).split("/");
const linked = sweeps.findIndex((sweep) => sweep.case === ofCase && sweep.sweep === ofSweep);
choose(Math.max(linked, 0), linked < 0 || !/^\d+$/.test(ofPoint) ? opening(sweeps[Math.max(linked, 0)]) : Number(ofPoint));
