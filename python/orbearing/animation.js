// Plays one orbit of the rollers: rollers, cage and rings in the carrier frame, x outward (up), y along carrier rotation (left).
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (name) => document.getElementById(name);
const BLUE = "#0072B2", VERMILION = "#D55E00", GREY = "#767676", BLACK = "#1a1a1a", STEEL = "#d5dade", CAGE = "#e2cd96";
const BAR = 0.26; // longest load bar over the outside radius
const instants = data.time.length, rollers = data.angle.length, caged = "cageX" in data;

// Values between two stored instants; `place` runs from 0 to instants - 1.
const at = (series, place) => {
  const i = Math.min(Math.floor(place), instants - 2), share = place - i;
  return series[i] + share * (series[i + 1] - series[i]);
};
const fixed = (value, digits) => value.toFixed(digits).replace("-", "\u2212");
const thousands = (value) => Math.round(value).toLocaleString("en").replace("-", "\u2212");

// A canvas as sharp as the screen, cleared; lengths below are in CSS pixels.
const prepare = (canvas) => {
  const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  canvas.width = Math.round(ratio * box.width);
  canvas.height = Math.round(ratio * box.height);
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, box.width, box.height);
  return [pen, box.width, box.height];
};

// From millimetres in the carrier frame to the canvas: x is up, y is left.
class Page {
  constructor(pen, width) {
    this.pen = pen;
    this.centre = width / 2;
    this.scale = width / 2 / (data.size.outside / 2 * (1.3 + BAR));
  }
  point(x, y) { return [this.centre - y * this.scale, this.centre - x * this.scale]; }
  polar(radius, angle) { return this.point(radius * Math.cos(angle), radius * Math.sin(angle)); }
  circle(x, y, radius) {
    const [across, down] = this.point(x, y);
    this.pen.moveTo(across + radius * this.scale, down);
    this.pen.arc(across, down, radius * this.scale, 0, 2 * Math.PI);
  }
  ring(x, y, outer, inner, fill) {
    this.pen.beginPath();
    this.circle(x, y, outer);
    this.circle(x, y, inner);
    this.pen.fillStyle = fill;
    this.pen.fill("evenodd");
    this.pen.strokeStyle = GREY;
    this.pen.lineWidth = 0.8;
    this.pen.stroke();
  }
  line(from, to, colour, width) {
    this.pen.beginPath();
    this.pen.moveTo(...from);
    this.pen.lineTo(...to);
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = width;
    this.pen.stroke();
  }
  text(words, x, y, colour = BLACK, align = "center") {
    const [across, down] = this.point(x, y);
    this.pen.fillStyle = colour;
    this.pen.textAlign = align;
    this.pen.textBaseline = "middle";
    this.pen.font = `${Math.max(10, this.centre / 24)}px system-ui, "DejaVu Sans", sans-serif`;
    this.pen.fillText(words, across, down);
  }
  // An arc with its tip where the rotation leads; sense +1 is that of the carrier, counter-clockwise.
  turning(radius, middle, sense, colour) {
    const from = middle - 0.16 * sense, to = middle + 0.16 * sense, tip = 0.035;
    for (let i = 0; i < 16; ++i)
      this.line(this.polar(radius, from + (to - from) * i / 16), this.polar(radius, from + (to - from) * (i + 1) / 16), colour, 2);
    for (const side of [0.975, 1.025]) this.line(this.polar(radius, to), this.polar(radius * side, to - tip * sense), colour, 2);
  }
}

const drawRings = (page, place) => {
  const size = data.size, turned = data.outerSpeed * (at(data.time, place) - data.time[0]);
  page.ring(0, 0, size.outside / 2, size.outerRaceway / 2, STEEL);
  page.ring(0, 0, size.innerRaceway / 2, size.bore / 2, STEEL);
  for (let i = 0; i < 12; ++i) { // marks that turn with the planet
    const angle = turned + i * Math.PI / 6, long = i === 0 ? 0.55 : 0.25;
    const depth = long * (size.outside - size.outerRaceway) / 2;
    page.line(page.polar(size.outside / 2, angle), page.polar(size.outside / 2 - depth, angle), i ? GREY : BLACK, i ? 1 : 3);
  }
};

const drawCage = (page, place) => {
  const size = data.size;
  if (!caged) return;
  const x = data.factor * at(data.cageX, place) * 1e-3, y = data.factor * at(data.cageY, place) * 1e-3;
  page.ring(x, y, size.cageOuter / 2, size.cageInner / 2, CAGE);
  const angle = at(data.cageAngle, place);
  for (let j = 0; j < rollers; ++j) { // the bars between the pockets
    const bar = angle + 2 * Math.PI * (j + 0.5) / rollers, colour = j ? GREY : BLACK;
    const end = (radius) => page.point(x + radius * Math.cos(bar), y + radius * Math.sin(bar));
    page.line(end(size.cageInner / 2), end(size.cageOuter / 2), colour, j ? 1 : 3);
  }
};

const drawRollers = (page, place) => {
  const size = data.size, radius = size.roller / 2;
  for (let j = 0; j < rollers; ++j) {
    const angle = at(data.angle[j], place), x = size.pitch / 2 * Math.cos(angle), y = size.pitch / 2 * Math.sin(angle);
    const share = Math.max(at(data.inner[j], place), at(data.outer[j], place)) / data.largest;
    page.pen.beginPath();
    page.circle(x, y, radius);
    page.pen.fillStyle = `rgb(${Math.round(255 - 205 * share)}, ${Math.round(255 - 140 * share)}, ${Math.round(255 - 70 * share)})`;
    page.pen.fill();
    page.pen.strokeStyle = j ? BLACK : VERMILION;
    page.pen.lineWidth = j ? 0.8 : 2.4;
    page.pen.stroke();
    const mark = at(data.turned[j], place); // the roller's own rotation
    page.line(page.point(x, y), page.point(x + 0.85 * radius * Math.cos(mark), y + 0.85 * radius * Math.sin(mark)), BLACK, 1.2);
  }
};

const drawBars = (page, place) => {
  const outside = data.size.outside / 2, width = Math.max(2, 0.45 * data.size.roller * page.scale);
  const bars = [[data.outer, 1.03 * outside, 1, VERMILION], [data.inner, 0.97 * data.size.innerRaceway / 2, -1, BLUE]];
  for (const [loads, foot, sign, colour] of bars)
    for (let j = 0; j < rollers; ++j) {
      const load = at(loads[j], place), angle = at(data.angle[j], place);
      if (load > 0)
        page.line(page.polar(foot, angle), page.polar(foot + sign * BAR * outside * load / data.largest, angle), colour, width);
    }
  const [right, low] = page.point(-(1.24 + BAR) * outside, -(1.2 + BAR) * outside); // the scale of the bars
  page.line([right, low], [right - BAR * outside * page.scale, low], GREY, 5);
  page.text(`${thousands(data.largest)} N`, -(1.16 + BAR) * outside, -(1.2 + BAR) * outside, BLACK, "right");
};

const drawSenses = (page) => {
  const outside = data.size.outside / 2, edge = (1.1 + BAR) * outside, side = Math.sign(data.outerSpeed);
  page.turning(edge, 0, 1, BLACK);
  page.text("carrier turns", 1.07 * edge, 0);
  page.turning(0.93 * outside, Math.PI / 4, side, BLACK);
  page.turning(data.size.pitch / 2, Math.PI / 4 + Math.PI / rollers, Math.sign(data.orbitSpeed[0]), VERMILION);
  page.line(page.point(-0.98 * edge, 0), page.point(-1.08 * edge, 0), BLACK, 2);
  for (const y of [-0.02, 0.02]) page.line(page.point(-1.08 * edge, 0), page.point(-1.05 * edge, y * edge), BLACK, 2);
  page.text("sun", -1.12 * edge, 0);
  for (const [x, y, name] of [[1, 0, "x"], [0, 1, "y"]]) { // the frame, in a corner
    const foot = [0.85 * edge, 0.86 * edge], reach = 0.16 * edge, tip = [foot[0] + x * reach, foot[1] + y * reach];
    page.line(page.point(...foot), page.point(...tip), GREY, 1.5);
    for (const side of [-0.03, 0.03])
      page.line(page.point(tip[0] - 0.05 * edge * x + side * edge * y, tip[1] - 0.05 * edge * y + side * edge * x), page.point(...tip), GREY, 1.5);
    page.text(name, foot[0] + 1.35 * x * reach, foot[1] + 1.35 * y * reach, GREY);
  }
};

// The cage's centre inside its clearance, at a scale of its own, in the empty bore.
const drawOrbit = (page, place) => {
  if (!caged) return;
  const room = 0.42 * data.size.bore / 2, reach = Math.max(data.clearance, ...data.cageX.map((x, i) => Math.hypot(x, data.cageY[i])), 1e-9);
  const spot = (x, y) => page.point(x / reach * room, y / reach * room);
  page.pen.beginPath();
  page.circle(0, 0, room * data.clearance / reach);
  page.pen.strokeStyle = GREY;
  page.pen.lineWidth = 1;
  page.pen.stroke();
  page.pen.beginPath();
  data.cageX.forEach((x, i) => (i ? page.pen.lineTo(...spot(x, data.cageY[i])) : page.pen.moveTo(...spot(x, data.cageY[i]))));
  page.pen.strokeStyle = BLUE;
  page.pen.stroke();
  const [across, down] = spot(at(data.cageX, place), at(data.cageY, place));
  page.pen.beginPath();
  page.pen.arc(across, down, 4, 0, 2 * Math.PI);
  page.pen.fillStyle = VERMILION;
  page.pen.fill();
  page.text("cage centre", 1.7 * room, 0);
  if (data.clearance) page.text(`circle: ${fixed(data.clearance, 0)} \u00b5m`, 1.25 * room, 0);
};

const drawTrace = (place) => {
  const [pen, width, height] = prepare(byId("trace")), left = 46, bottom = height - 30, top = 18;
  const across = (i) => left + (width - left - 8) * i / (instants - 1), down = (load) => bottom - (bottom - top) * load / data.largest;
  pen.font = "11px system-ui, \"DejaVu Sans\", sans-serif";
  pen.fillStyle = BLACK;
  pen.textAlign = "right";
  for (const share of [0, 0.5, 1]) pen.fillText(thousands(share * data.largest), left - 5, down(share * data.largest) + 4);
  pen.textAlign = "left";
  pen.fillText("load of the marked roller (N): outer race, inner race dashed", left, 11);
  for (const share of [0, 0.5, 1]) {
    pen.textAlign = share === 1 ? "right" : share ? "center" : "left";
    pen.fillText(fixed(1e3 * (at(data.time, share * (instants - 1)) - data.time[0]), 2), across(share * (instants - 1)), height - 17);
  }
  pen.textAlign = "center";
  pen.fillText("time (ms)", (left + width) / 2, height - 4);
  for (const [loads, colour, dash] of [[data.outer[0], VERMILION, []], [data.inner[0], BLUE, [4, 3]]]) {
    pen.beginPath();
    loads.forEach((load, i) => (i ? pen.lineTo(across(i), down(load)) : pen.moveTo(across(i), down(load))));
    pen.setLineDash(dash);
    pen.strokeStyle = colour;
    pen.lineWidth = 1.3;
    pen.stroke();
  }
  pen.setLineDash([]);
  pen.beginPath();
  pen.moveTo(across(place), top);
  pen.lineTo(across(place), bottom);
  pen.strokeStyle = BLACK;
  pen.lineWidth = 1;
  pen.stroke();
};

const tell = (place) => {
  const loads = data.outer.map((load, j) => Math.max(at(load, place), at(data.inner[j], place)));
  const speed = at(data.orbitSpeed, place);
  byId("now-time").textContent = `${fixed(1e3 * (at(data.time, place) - data.time[0]), 3)} ms`;
  byId("now-orbit").textContent = `${thousands(speed * 30 / Math.PI)} rpm`;
  byId("now-slip").textContent = data.orbitRolling ? `${fixed(100 * (1 - speed / data.orbitRolling), 2)} %` : "not known";
  byId("now-load").textContent = `${thousands(Math.max(...loads))} N`;
  byId("now-carrying").textContent = `${loads.filter((load) => load > 0.05 * data.largest).length} of ${rollers}`;
  if (caged) byId("now-shift").textContent = `${fixed(Math.hypot(at(data.cageX, place), at(data.cageY, place)), 1)} \u00b5m`;
};

const slider = byId("instant"), button = byId("play"), pace = byId("pace");
let place = 0, playing = false, before = 0;
const show = () => {
  const [pen, width] = prepare(byId("bearing")), page = new Page(pen, width);
  drawRings(page, place);
  drawCage(page, place);
  drawRollers(page, place);
  drawBars(page, place);
  drawOrbit(page, place);
  drawSenses(page);
  drawTrace(place);
  tell(place);
  slider.value = place / (instants - 1);
};
const step = (now) => {
  if (!playing) return;
  const share = Math.min(now - before, 100) / 1e3 / Number(pace.value); // of one orbit since the picture before
  before = now;
  place = (place + share * (instants - 1)) % (instants - 1);
  show();
  requestAnimationFrame(step);
};
const play = (wanted) => {
  playing = wanted;
  button.textContent = playing ? "Pause" : "Play";
  if (playing) requestAnimationFrame((now) => { before = now; step(now); });
};
button.addEventListener("click", () => play(!playing));
slider.addEventListener("input", () => { play(false); place = Number(slider.value) * (instants - 1); show(); });
const slowed = () => {
  const orbit = data.time[instants - 1] - data.time[0];
  for (const choice of pace.options) choice.textContent = `${choice.value} s for ${fixed(1e3 * orbit, 2)} ms: slowed ${thousands(choice.value / orbit)} times`;
};
window.addEventListener("resize", show);
// "#0.25" in the address opens the page standing at a quarter of the orbit.
const wanted = Number(window.location.hash.slice(1));
slowed();
if (window.location.hash && wanted >= 0 && wanted <= 1) place = wanted * (instants - 1);
show();
if (!window.location.hash && !window.matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
