// SPDX-License-Identifier: LGPL-2.1-or-later
// Shows the scene of a page: turns, zooms, switches groups and layers, and tells what is clicked.
// Plain WebGL 2; it goes on where scene.js ends.
const kLineWidth = { curve: 4, net: 1.3, hatch: 1.4 };  // CSS pixels
const kOutlineColour = [0.22, 0.26, 0.32], kPickedColour = [1.0, 0.78, 0.0];
const kOpaque = 0.9;  // groups from this opacity on hide what is behind them
const kMarkSize = 15, kReach = 8;  // CSS pixels; the second is how near a click has to be

// ---- drawing ----------------------------------------------------------------------------------

const kProject = `#version 300 es
uniform mat3 turn; uniform vec3 target; uniform vec2 scale; uniform float depth, lift;
vec4 project(vec3 p) {
  vec3 q = turn * (p - target);
  return vec4(q.xy * scale, -q.z * depth - lift, 1.0);
}`;
const kFaceVertex = kProject + `
in vec3 point; in vec3 normal; out vec3 seen;
void main() { gl_Position = project(point); seen = turn * normal; }`;
const kFaceFragment = `#version 300 es
precision highp float; uniform vec4 colour; in vec3 seen; out vec4 result;
void main() {
  vec3 n = length(seen) > 0.0 ? normalize(seen) : vec3(0.0, 0.0, 1.0);
  if (n.z < 0.0) n = -n;
  vec3 lamp = normalize(vec3(-0.35, 0.45, 0.8));
  float shine = pow(max(dot(n, normalize(lamp + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
  result = vec4((0.62 + 0.43 * max(dot(n, lamp), 0.0)) * colour.rgb + 0.16 * shine, colour.a);
}`;
// A segment is a rectangle that goes on by half its width at both ends.
const kLineVertex = kProject + `
in vec3 a; in vec3 b; uniform vec2 size; uniform float width;
void main() {
  vec4 p = project(a), q = project(b);
  vec2 along = (q.xy - p.xy) * size;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  float end = gl_VertexID < 2 ? -1.0 : 1.0, side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
  vec4 at = gl_VertexID < 2 ? p : q;
  at.xy += (end * along + side * vec2(-along.y, along.x)) * width / size;
  gl_Position = at;
}`;
const kPlainFragment = `#version 300 es
precision highp float; uniform vec4 colour; out vec4 result;
void main() { result = colour; }`;
const kMarkVertex = kProject + `
in vec3 point; uniform float width;
void main() { gl_Position = project(point); gl_PointSize = width; }`;
const kMarkFragment = `#version 300 es
precision highp float; uniform vec4 colour; uniform int shape; out vec4 result;
void main() {
  vec2 p = abs(gl_PointCoord * 2.0 - 1.0);
  float r = shape == 2 ? max(p.x, p.y) : length(p);
  if (r > 1.0) discard;
  bool ink = shape == 0 ? r < 0.75 : r > 0.62 && r < 0.9;
  if (!ink && (shape == 0 || r > 0.45)) result = vec4(1.0);
  else if (!ink) discard;
  else result = colour;
}`;

function program(vertex, fragment) {
  const made = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(shader));
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  return { made, at: (name) => gl.getUniformLocation(made, name) };
}

function buffer(kind, values) {
  const made = gl.createBuffer();
  gl.bindBuffer(kind, made);
  gl.bufferData(kind, values, gl.STATIC_DRAW);
  return made;
}

// A vertex array with attributes {name: [buffer, type, stride, offset, divisor]}.
function vertices(shader, attributes, elements) {
  const made = gl.createVertexArray();
  gl.bindVertexArray(made);
  for (const [name, [values, type, stride, offset, divisor]] of Object.entries(attributes)) {
    const at = gl.getAttribLocation(shader.made, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, values);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, 3, type, type !== gl.FLOAT, stride, offset);
    gl.vertexAttribDivisor(at, divisor);
  }
  if (elements) buffer(gl.ELEMENT_ARRAY_BUFFER, elements);
  gl.bindVertexArray(null);
  return made;
}

let shaders = null, picked = null;

function lineVertices(segments) {
  const values = buffer(gl.ARRAY_BUFFER, segments);
  return { first: -1, values, count: segments.length / 6 };
}

function upload() {
  shaders = { face: program(kFaceVertex, kFaceFragment), line: program(kLineVertex, kPlainFragment),
              mark: program(kMarkVertex, kMarkFragment) };
  for (const group of groups) {
    group.array = vertices(shaders.face, {
      point: [buffer(gl.ARRAY_BUFFER, group.points), gl.FLOAT, 0, 0, 0],
      normal: [buffer(gl.ARRAY_BUFFER, group.normals), gl.BYTE, 0, 0, 0] }, group.corners);
    group.outline = lineVertices(group.segments);
  }
  for (const layer of layers) layer.lines = lineVertices(layer.segments);
}

function use(shader, colour, opacity, lift) {
  const [right, up, back] = axes(), scale = pixelScale();
  gl.useProgram(shader.made);
  gl.uniformMatrix3fv(shader.at("turn"), false,
    [right[0], up[0], back[0], right[1], up[1], back[1], right[2], up[2], back[2]]);
  gl.uniform3fv(shader.at("target"), camera.target);
  gl.uniform2f(shader.at("scale"), 2 * scale / canvas.clientWidth, 2 * scale / canvas.clientHeight);
  gl.uniform1f(shader.at("depth"), 0.6 / data.size);
  gl.uniform1f(shader.at("lift"), lift);
  gl.uniform4f(shader.at("colour"), ...colour, opacity);
}

function drawFaces(group, colour, opacity, first, count) {
  // Translucent faces lie behind opaque ones that coincide with them.
  use(shaders.face, colour, opacity, opacity < kOpaque ? -1e-3 : 0);
  gl.bindVertexArray(group.array);
  gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
}

function drawLines(lines, first, count, colour, opacity, width) {
  if (count === 0) return;
  use(shaders.line, colour, opacity, 2e-3);
  gl.uniform2f(shaders.line.at("size"), canvas.clientWidth, canvas.clientHeight);
  gl.uniform1f(shaders.line.at("width"), width);
  if (lines.first !== first) {
    if (lines.array) gl.deleteVertexArray(lines.array);
    lines.array = vertices(shaders.line, { a: [lines.values, gl.FLOAT, 24, 24 * first, 1],
                                           b: [lines.values, gl.FLOAT, 24, 24 * first + 12, 1] });
    lines.first = first;
  }
  gl.bindVertexArray(lines.array);
  gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
}

function drawMarks(layer, ratio) {
  use(shaders.mark, layer.colour, 1, 0);
  gl.uniform1f(shaders.mark.at("width"), kMarkSize * ratio);
  gl.uniform1i(shaders.mark.at("shape"), ["dot", "ring", "square"].indexOf(layer.style));
  layer.marks ??= vertices(shaders.mark, { point: [layer.lines.values, gl.FLOAT, 0, 0, 0] });
  gl.bindVertexArray(layer.marks);
  gl.drawArrays(gl.POINTS, 0, layer.items.length);
}

function drawLayers(opacity) {
  for (const layer of layers)
    if (layer.shown && !layer.isMark)
      drawLines(layer.lines, 0, layer.lines.count, layer.colour, opacity, kLineWidth[layer.style]);
  const { layer, item } = picked ?? {};
  if (layer && !layer.isMark && layer.shown)
    for (const other of layer.items.filter((i) => i.label === item.label))
      drawLines(layer.lines, other.first, other.count, kPickedColour, opacity,
                1.4 * kLineWidth[layer.style]);
}

function draw() {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.BLEND);
  gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  gl.depthFunc(gl.LEQUAL);
  const shown = groups.filter((group) => group.shown);
  for (const group of shown.filter((g) => g.opacity >= kOpaque))
    drawFaces(group, group.colour, 1, 0, group.corners.length);
  const drawPicked = (solid) => {
    const { group, face } = picked ?? {};
    if (face && group.shown && group.opacity >= kOpaque === solid)
      drawFaces(group, kPickedColour, solid ? 1 : 0.6, face.first, face.count);
  };
  drawPicked(true);
  if (element("outlines").checked)
    for (const { outline } of shown) drawLines(outline, 0, outline.count, kOutlineColour, 1, 1);
  drawLayers(1);
  gl.depthMask(false);
  for (const group of shown.filter((g) => g.opacity < kOpaque))
    drawFaces(group, group.colour, group.opacity, 0, group.corners.length);
  drawPicked(false);
  gl.depthFunc(gl.GREATER);  // what is hidden shines through
  drawLayers(0.3);
  gl.depthMask(true);
  gl.disable(gl.DEPTH_TEST);
  for (const layer of layers) if (layer.shown && layer.isMark) drawMarks(layer, ratio);
}

let waiting = false;
function redraw() {
  if (waiting || !gl) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; draw(); });
}

// ---- what is clicked --------------------------------------------------------------------------

// The faces under a place of the canvas, the nearest first, each with its group and depth.
function facesAt(x, y) {
  const found = [];
  for (const group of groups.filter((g) => g.shown)) {
    const count = group.points.length / 3, at = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i)
      at.set(place([...group.points.subarray(3 * i, 3 * i + 3)]), 3 * i);
    for (const face of group.faces) {
      let nearest = -Infinity;
      for (let t = face.first; t < face.first + face.count; t += 3) {
        const [i, j, k] = [group.corners[t] * 3, group.corners[t + 1] * 3, group.corners[t + 2] * 3];
        const ax = at[i] - x, ay = at[i + 1] - y, bx = at[j] - x, by = at[j + 1] - y;
        const cx = at[k] - x, cy = at[k + 1] - y;
        const u = bx * cy - by * cx, v = cx * ay - cy * ax, w = ax * by - ay * bx, whole = u + v + w;
        if (whole === 0 || u / whole < 0 || v / whole < 0 || w / whole < 0) continue;
        const depth = (u * at[i + 2] + v * at[j + 2] + w * at[k + 2]) / whole;
        nearest = Math.max(nearest, depth);
      }
      if (nearest > -Infinity) found.push({ group, face, depth: nearest });
    }
  }
  return found.sort((a, b) => b.depth - a.depth);
}

const labelOf = ({ group, face }) => face.label || group.name;

// Each once, what is seen through the first of these faces.
function seenThrough(faces) {
  const labels = new Set();
  for (const [k, { group }] of faces.entries()) {
    if (k > 0) labels.add(labelOf(faces[k]).replaceAll("\n", ", "));
    if (group.opacity >= kOpaque) break;
  }
  if (faces.length > 0) labels.delete(labelOf(faces[0]).replaceAll("\n", ", "));
  return [...labels];
}

// How far a place is from a segment on the canvas, and how near to the eye that is.
function toSegment(x, y, a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / square)) : 0;
  return { away: Math.hypot(x - a[0] - t * dx, y - a[1] - t * dy), depth: a[2] + t * (b[2] - a[2]) };
}

// The nearest curve or mark: marks first, then lines that no face hides.
function itemAt(x, y, front) {
  let best = null;
  for (const layer of layers.filter((l) => l.shown))
    for (const item of layer.items) {
      let last = null;
      for (let i = 0; i < item.line.length; i += 3) {
        const here = place([item.line[i], item.line[i + 1], item.line[i + 2]]);
        const { away, depth } = toSegment(x, y, last ?? here, here);
        last = here;
        if (away > kReach) continue;
        const hidden = !layer.isMark && depth < front - 0.01 * data.size;
        const cost = away + (hidden ? kReach : 0) + (layer.isMark ? -kReach : 0) +
                     (layer.style === "hatch" || layer.style === "net" ? 2 : 0);
        if (!best || cost < best.cost) best = { layer, item, cost };
        if (layer.isMark) break;
      }
    }
  return best;
}

function pick(x, y) {
  const faces = facesAt(x, y), item = itemAt(x, y, faces.length > 0 ? faces[0].depth : -Infinity);
  picked = item ?? faces[0];
  const label = item ? item.item.label || item.layer.name : picked ? labelOf(picked) : "";
  const behind = item ? [] : seenThrough(faces);
  element("picked").textContent = label || "Nothing there.";
  element("behind").textContent = behind.length > 0 ? "seen through it: " + behind.join("; ") : "";
  document.body.dataset.picked = label;
  redraw();
}

// ---- the panel --------------------------------------------------------------------------------

function addSwitch(thing, kind) {
  if (!thing.name) return;
  const label = document.createElement("label"), box = document.createElement("input");
  const swatch = document.createElement("span");
  box.type = "checkbox";
  box.checked = true;
  box.addEventListener("change", () => {
    const all = kind ? layers : groups;  // a layer's nameless neighbours of one colour belong to it
    for (const other of all)
      if (other === thing || (!other.name && String(other.colour) === String(thing.colour)))
        other.shown = box.checked;
    redraw();
  });
  swatch.className = "swatch " + (kind ? (thing.isMark ? "mark" : "line") : "");
  const [r, g, b] = thing.colour.map((c) => Math.round(255 * c));
  swatch.style.background = `rgb(${r} ${g} ${b} / ${kind ? 1 : thing.opacity})`;
  label.append(box, swatch, thing.name);
  element("switches").append(label);
}

function fillPanel() {
  document.title = data.title || "Blossom";
  element("title").textContent = data.title;
  element("subtitle").textContent = data.subtitle;
  groups.forEach((group) => addSwitch(group, false));
  layers.forEach((layer) => addSwitch(layer, true));
  for (const fact of data.facts) {
    const line = document.createElement("li");
    line.textContent = fact;
    element("facts").append(line);
  }
  element("certificate").hidden = data.facts.length === 0;
  element("outlines").addEventListener("change", redraw);
  const views = { Iso: [1, -1, 1], Front: [0, -1, 0], Right: [1, 0, 0], Top: [0, 0, 1] };
  for (const [name, eye] of Object.entries(views)) {
    const button = document.createElement("button");
    button.textContent = name;
    button.addEventListener("click", () => { show(eye); });
    element("views").append(button);
  }
}

function show(eye) {
  lookFrom(eye);
  fit();
  redraw();
}

// ---- the mouse --------------------------------------------------------------------------------

function listen() {
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = { x: event.offsetX, y: event.offsetY, moved: 0, slides: event.button !== 0 || event.shiftKey };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    const dx = event.offsetX - held.x, dy = event.offsetY - held.y;
    held.moved += Math.abs(dx) + Math.abs(dy);
    [held.x, held.y] = [event.offsetX, event.offsetY];
    if (held.slides) {
      const [right, up] = axes(), scale = pixelScale();
      camera.target = camera.target.map((t, k) => t - (dx * right[k] - dy * up[k]) / scale);
      camera.whole = false;
    } else {
      camera.azimuth -= dx * 0.008;
      camera.elevation = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, camera.elevation + dy * 0.008));
    }
    redraw();
  });
  canvas.addEventListener("pointerup", (event) => {
    if (held && held.moved < 4) pick(event.offsetX, event.offsetY);
    held = null;
  });
  canvas.addEventListener("pointercancel", () => { held = null; });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => show(data.eye));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const x = event.offsetX - canvas.clientWidth / 2, y = event.offsetY - canvas.clientHeight / 2;
    const before = pixelScale();
    camera.whole = false;
    camera.zoom = Math.min(1e5, Math.max(0.05, camera.zoom * Math.exp(-0.0015 * event.deltaY)));
    const [right, up] = axes(), gain = 1 / before - 1 / pixelScale();  // what is below the mouse stays
    camera.target = camera.target.map((t, k) => t + gain * (x * right[k] - y * up[k]));
    redraw();
  }, { passive: false });
  new ResizeObserver(() => {
    if (camera.whole) fit();
    redraw();
  }).observe(canvas);
}

fillPanel();
if (gl) {
  upload();
  show(data.eye);
  listen();
  const triangles = groups.reduce((sum, group) => sum + group.corners.length / 3, 0);
  document.body.dataset.triangles = triangles;
  // For scripts and tests: where a point of an item is on the canvas; share 0 is its first point, 1 the last.
  window.blossomPage = {
    placeOf: (layer, item, share) => {
      const line = layers[layer].items[item].line, at = 3 * Math.round(share * (line.length / 3 - 1));
      return place([...line.subarray(at, at + 3)]);
    },
    layers: layers.map((layer) => layer.name),
  };
} else {
  element("picked").textContent = "This browser has no WebGL 2, which the view needs.";
}
