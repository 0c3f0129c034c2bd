// SPDX-License-Identifier: LGPL-2.1-or-later
// The scene of a page, decoded, and the camera that looks at it; viewer.js follows in the same script.
// The scene is the JSON of page.cpp in the element "data".
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const canvas = element("view");
const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });

// ---- the scene, decoded -----------------------------------------------------------------------

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const floats = (text) => new Float32Array(bytes(text).buffer);
const indices = (text, wide) =>
  wide ? new Uint32Array(bytes(text).buffer) : new Uint16Array(bytes(text).buffer);

// Points of a face, from 16 bits a coordinate to lengths from the middle of the scene.
function pointsOf(face) {
  const fine = new Uint16Array(bytes(face.points).buffer);
  return Float32Array.from(fine, (q, i) => data.low[i % 3] + (q * data.extent[i % 3]) / 65535);
}

function decodeGroup(group) {
  const points = [], normals = [], corners = [], segments = [];
  let count = 0, drawn = 0;
  for (const face of group.faces) {
    const wide = face.wide, own = pointsOf(face), triangles = indices(face.triangles, wide);
    points.push(own);
    normals.push(new Int8Array(bytes(face.normals).buffer));
    corners.push(Uint32Array.from(triangles, (i) => i + count));
    for (const k of indices(face.border, wide)) segments.push(...own.subarray(3 * k, 3 * k + 3));
    face.first = drawn;
    face.count = triangles.length;
    drawn += triangles.length;
    count += own.length / 3;
  }
  const joined = (Type, parts) => {
    const all = new Type(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) { all.set(part, at); at += part.length; }
    return all;
  };
  return { ...group, shown: true, points: joined(Float32Array, points),
           normals: joined(Int8Array, normals), corners: joined(Uint32Array, corners),
           segments: new Float32Array(segments) };
}

function decodeLayer(layer) {
  const isMark = ["dot", "ring", "square"].includes(layer.style), segments = [], owners = [];
  layer.items.forEach((item, k) => {
    const line = floats(item.points);
    item.line = line;
    if (isMark) { segments.push(...line.subarray(0, 3)); return; }
    item.first = owners.length;
    for (let i = 3; i < line.length; i += 3) {
      for (let j = i - 3; j < i + 3; ++j) segments.push(line[j]);
      owners.push(k);
    }
    item.count = owners.length - item.first;
  });
  return { ...layer, isMark, shown: true, owners, segments: new Float32Array(segments) };
}

const groups = data.groups.map(decodeGroup), layers = data.layers.map(decodeLayer);

// ---- the camera: parallel, z upwards ----------------------------------------------------------

// `whole` as long as nobody has zoomed or slid: all that there is then stays in the canvas.
const camera = { azimuth: 0, elevation: 0, target: [0, 0, 0], zoom: 1, whole: true };
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function lookFrom(eye) {
  const flat = Math.hypot(eye[0], eye[1]);
  camera.azimuth = flat > 1e-9 ? Math.atan2(eye[1], eye[0]) : -Math.PI / 2;
  camera.elevation = Math.atan2(eye[2], flat);
}

// Unit vectors to the right, upwards and to the eye.
function axes() {
  const [ca, sa] = [Math.cos(camera.azimuth), Math.sin(camera.azimuth)];
  const [ce, se] = [Math.cos(camera.elevation), Math.sin(camera.elevation)];
  return [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
}

// CSS pixels per model unit.
const pixelScale = () =>
  camera.zoom * Math.min(canvas.clientWidth, canvas.clientHeight) / data.size;

// Puts all that there is into the canvas, as it is turned.
function fit() {
  const [right, up] = axes(), low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const points of [...groups.map((g) => g.points), ...layers.map((l) => l.segments)])
    for (let i = 0; i < points.length; i += 3)
      [right, up].forEach((axis, k) => {
        const at = points[i] * axis[0] + points[i + 1] * axis[1] + points[i + 2] * axis[2];
        low[k] = Math.min(low[k], at);
        high[k] = Math.max(high[k], at);
      });
  if (low[0] > high[0]) return;
  const [x, y] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  camera.target = [0, 1, 2].map((k) => x * right[k] + y * up[k]);
  camera.zoom = 1;
  camera.whole = true;
  const scale = pixelScale(), least = 1e-9 * data.size;
  camera.zoom = 0.92 * Math.min(canvas.clientWidth / (scale * Math.max(high[0] - low[0], least)),
                                canvas.clientHeight / (scale * Math.max(high[1] - low[1], least)));
}

// CSS pixels from the left, from the top, and depth (larger is nearer), of a point of the scene.
function place(point) {
  const [right, up, back] = axes(), scale = pixelScale();
  const p = point.map((x, k) => x - camera.target[k]);
  return [canvas.clientWidth / 2 + scale * dot(p, right),
          canvas.clientHeight / 2 - scale * dot(p, up), dot(p, back)];
}
