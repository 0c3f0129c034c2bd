// SPDX-License-Identifier: LGPL-2.1-or-later
// The scene of a page as objects of three.js; viewer.js follows in the same script.
// The scene is the JSON of page.cpp in the element "data".
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const canvas = element("view");

const kLineWidth = { curve: 4, net: 1.3, hatch: 1.4 };  // CSS pixels
const kOutlineColour = [0.22, 0.26, 0.32], kPickedColour = [1.0, 0.78, 0.0];
const kOpaque = 0.9;   // groups from this opacity on hide what is behind them
const kMarkSize = 15;  // CSS pixels
const kShine = 0.3;    // opacity of lines that faces hide
// What comes later is drawn over what comes earlier and coincides with it.
const kOrder = { faces: 0, picked: 1, lines: 2, pickedLines: 3, translucent: 4, pickedTranslucent: 5,
                 hidden: 6, marks: 7 };
// How much nearer to the eye things are drawn than they are, in sizes of the scene: lines lie before
// the faces they are on, translucent faces behind opaque ones that coincide with them.
const kLift = { line: 3e-3, translucent: -1.5e-3 };

const scene = new THREE.Scene();
const resolution = { value: new THREE.Vector2(1, 1) };  // of all lines, CSS pixels
const colourOf = (rgb) => new THREE.Color(...rgb);

// ---- the data, decoded ------------------------------------------------------------------------

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const floats = (text) => new Float32Array(bytes(text).buffer);
const indices = (text, wide) =>
  wide ? new Uint32Array(bytes(text).buffer) : new Uint16Array(bytes(text).buffer);

// Points of a face, from 16 bits a coordinate to lengths from the middle of the scene.
function pointsOf(face) {
  const fine = new Uint16Array(bytes(face.points).buffer);
  return Float32Array.from(fine, (q, i) => data.low[i % 3] + (q * data.extent[i % 3]) / 65535);
}

function joined(Type, parts) {
  const all = new Type(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) { all.set(part, at); at += part.length; }
  return all;
}

// From the points of a polyline to its segments, two points each.
function segmentsOf(line) {
  const segments = [];
  for (let i = 3; i < line.length; i += 3) segments.push(...line.subarray(i - 3, i + 3));
  return segments;
}

// ---- objects ----------------------------------------------------------------------------------

function add(parent, object, order, lift) {
  object.renderOrder = order;
  object.userData.lift = lift;
  parent.add(object);
  return object;
}

function lineMaterial(colour, width, options = {}) {
  const made = new THREE.LineMaterial({ color: colourOf(colour), linewidth: width, ...options });
  made.uniforms.resolution = resolution;
  return made;
}

// Where faces hide them they shine through.
function addLines(parent, segments, colour, width, order) {
  const geometry = new THREE.LineSegmentsGeometry().setPositions(Float32Array.from(segments));
  add(parent, new THREE.LineSegments2(geometry, lineMaterial(colour, width)), order, kLift.line);
  const material = lineMaterial(colour, width, { depthFunc: THREE.GreaterDepth, depthWrite: false,
                                                 transparent: true });
  material.uniforms.opacity.value = kShine;
  add(parent, new THREE.LineSegments2(geometry, material), kOrder.hidden, kLift.line);
}

function faceMaterial(colour, opacity) {
  const solid = opacity >= kOpaque;
  return new THREE.MeshPhongMaterial({ color: colourOf(colour), side: THREE.DoubleSide, shininess: 40,
                                       transparent: !solid, opacity: solid ? 1 : opacity,
                                       depthWrite: solid });
}

// The faces of a group as one mesh, that of them which is picked as another one, and their edges.
function groupOf(group) {
  const points = [], normals = [], corners = [], segments = [];
  let count = 0, drawn = 0;
  for (const face of group.faces) {
    const own = pointsOf(face), triangles = indices(face.triangles, face.wide);
    points.push(own);
    normals.push(new Int8Array(bytes(face.normals).buffer));
    corners.push(Uint32Array.from(triangles, (i) => i + count));
    for (const k of indices(face.border, face.wide)) segments.push(...own.subarray(3 * k, 3 * k + 3));
    face.first = drawn;
    face.count = triangles.length;
    drawn += triangles.length;
    count += own.length / 3;
  }
  const made = { ...group, object: new THREE.Group(), outline: new THREE.Group(),
                 points: joined(Float32Array, points), triangles: drawn / 3 };
  const position = new THREE.BufferAttribute(made.points, 3);
  const normal = new THREE.BufferAttribute(joined(Int8Array, normals), 3, true);
  const index = new THREE.BufferAttribute(joined(Uint32Array, corners), 1);
  const addMesh = (colour, opacity, order) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", position).setAttribute("normal", normal).setIndex(index);
    return add(made.object, new THREE.Mesh(geometry, faceMaterial(colour, opacity)), order,
               opacity >= kOpaque ? 0 : kLift.translucent);
  };
  const solid = group.opacity >= kOpaque;
  made.mesh = addMesh(group.colour, group.opacity, solid ? kOrder.faces : kOrder.translucent);
  made.picked = addMesh(kPickedColour, solid ? 1 : 0.6, solid ? kOrder.picked : kOrder.pickedTranslucent);
  made.picked.visible = false;
  if (segments.length > 0)
    add(made.outline, new THREE.LineSegments(pointGeometry(Float32Array.from(segments)),
                                             new THREE.LineBasicMaterial({ color: colourOf(kOutlineColour) })),
        kOrder.lines, kLift.line);  // thin, of which models have very many
  scene.add(made.object.add(made.outline));
  return made;
}

// A dot, ring or square with a white border, as large as a mark is.
function markTexture(style, colour) {
  const picture = document.createElement("canvas"), pen = picture.getContext("2d");
  picture.width = picture.height = 64;
  const path = (r) => {
    pen.beginPath();
    if (style === "square") pen.rect(32 - r, 32 - r, 2 * r, 2 * r);
    else pen.arc(32, 32, r, 0, 2 * Math.PI);
  };
  const strokes = style === "dot" ? [["white", 16, 32], [colour.getStyle(), 12, 24]]
                                  : [["white", 23, 18], [colour.getStyle(), 24, 9]];
  for (const [ink, radius, width] of strokes) {
    path(radius);
    pen.strokeStyle = ink;
    pen.lineWidth = width;
    pen.stroke();
  }
  const texture = new THREE.CanvasTexture(picture);
  texture.premultiplyAlpha = true;  // as blended below: coarser levels keep the colour of its edge
  return texture;
}

function pointGeometry(points) {
  return new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(points, 3));
}

// A layer as one object; its items beside it, not drawn, for what is clicked.
function layerOf(layer) {
  const isMark = ["dot", "ring", "square"].includes(layer.style);
  for (const item of layer.items) {
    item.line = floats(item.points);
    if (isMark) item.line = item.line.subarray(0, 3);
    item.target = new (isMark ? THREE.Points : THREE.Line)(pointGeometry(item.line));
  }
  const made = { ...layer, isMark, object: new THREE.Group(),
                 points: joined(Float32Array, layer.items.map((item) => item.line)) };
  const segments = isMark ? [] : layer.items.flatMap((item) => segmentsOf(item.line));
  if (segments.length > 0)
    addLines(made.object, segments, layer.colour, kLineWidth[layer.style], kOrder.lines);
  if (isMark)
    add(made.object, new THREE.Points(pointGeometry(made.points), new THREE.PointsMaterial({
      size: kMarkSize, sizeAttenuation: false, map: markTexture(layer.style, colourOf(layer.colour)),
      transparent: true, depthTest: false, depthWrite: false, blending: THREE.CustomBlending,
      blendSrc: THREE.OneFactor, blendDst: THREE.OneMinusSrcAlphaFactor })), kOrder.marks, 0);
  scene.add(made.object);
  return made;
}

const groups = data.groups.map(groupOf), layers = data.layers.map(layerOf);
