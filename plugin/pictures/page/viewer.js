// SPDX-License-Identifier: LGPL-2.1-or-later
// Shows the scene of a page: turns, zooms, switches groups and layers, and tells what is clicked.
// It goes on where scene.js ends.
const kReach = 8;  // CSS pixels; how near a click has to be to a curve or a mark
const kAway = 100;  // of the camera from what it looks at, in sizes of the scene; the view is parallel

// ---- the camera: parallel, z upwards; its zoom is CSS pixels per model unit -----------------------

const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
camera.up.set(0, 0, 1);
const lamp = new THREE.DirectionalLight(0xffffff, 0.43);
lamp.position.set(-0.35, 0.45, 0.8);
camera.add(lamp, lamp.target);
scene.add(camera, new THREE.AmbientLight(0xffffff, 0.62));
const controls = new THREE.OrbitControls(camera, canvas);
controls.screenSpacePanning = true;
// As fit() has left them: as long as nobody has zoomed or slid, all stays in the canvas.
const fitted = { zoom: 1, target: new THREE.Vector3() };

const axisOf = (k) => new THREE.Vector3().setComponent(k, 1).applyQuaternion(camera.quaternion);

// Moves camera and target, by a vector of model units.
function slide(by) {
  camera.position.add(by);
  controls.target.add(by);
}

// Puts all that there is into the canvas, as it is turned.
function fit() {
  const back = camera.quaternion.clone().conjugate(), box = new THREE.Box3(), p = new THREE.Vector3();
  for (const { points } of [...groups, ...layers])
    for (let i = 0; i < points.length; i += 3)
      box.expandByPoint(p.fromArray(points, i).applyQuaternion(back));
  if (box.isEmpty()) return;
  slide(box.getCenter(new THREE.Vector3()).applyQuaternion(camera.quaternion).sub(controls.target));
  const size = box.getSize(new THREE.Vector3()).clampScalar(1e-9 * data.size, Infinity);
  camera.zoom = 0.92 * Math.min(canvas.clientWidth / size.x, canvas.clientHeight / size.y);
  fitted.zoom = camera.zoom;
  fitted.target.copy(controls.target);
}

function look(eye) {
  const way = new THREE.Vector3(...eye).setLength(kAway * data.size);
  camera.position.copy(controls.target).add(way);
  controls.update();
  fit();
  redraw();
}

// What follows from where the camera is and how large the canvas is.
function settle() {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight], back = axisOf(2);
  const depth = camera.position.dot(back);
  Object.assign(camera, { left: -width / 2, right: width / 2, top: height / 2, bottom: -height / 2,
                          near: depth - data.size, far: depth + data.size });
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  resolution.value.set(width, height);
  scene.traverse((object) => {
    const { lift } = object.userData;
    if (lift) object.position.copy(back).multiplyScalar(lift * data.size);
  });
}

// CSS pixels from the left and from the top, of a point of the scene.
function place(point) {
  settle();
  const { x, y } = new THREE.Vector3(...point).project(camera);
  return [(1 + x) / 2 * canvas.clientWidth, (1 - y) / 2 * canvas.clientHeight];
}

let renderer = null, waiting = false;
function redraw() {
  if (waiting || !renderer) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    settle();
    renderer.render(scene, camera);
  });
}

// ---- what is clicked --------------------------------------------------------------------------

const raycaster = new THREE.Raycaster();
const pickedLines = new THREE.Group();

// The faces that the ray meets, each once, the nearest first.
function facesHit() {
  const found = new Map(), shown = groups.filter((group) => group.object.visible);
  for (const hit of raycaster.intersectObjects(shown.map((group) => group.mesh))) {
    const group = shown.find((g) => g.mesh === hit.object);
    const face = group.faces.find((f) => 3 * hit.faceIndex < f.first + f.count);
    if (!found.has(face)) found.set(face, { group, face, distance: hit.distance });
  }
  return [...found.values()];
}

// The nearest curve or mark: marks first, then lines that no face hides.
function itemHit(front) {
  let best = null;
  for (const layer of layers.filter((l) => l.object.visible))
    for (const item of layer.items)
      for (const hit of raycaster.intersectObject(item.target)) {
        const away = camera.zoom * (hit.distanceToRay ?? raycaster.ray.distanceToPoint(hit.point));
        const hidden = !layer.isMark && hit.distance > front + 0.01 * data.size;
        const cost = away + (hidden ? kReach : 0) + (layer.isMark ? -kReach : 0) +
                     (layer.style === "hatch" || layer.style === "net" ? 2 : 0);
        if (!best || cost < best.cost) best = { layer, item, cost };
      }
  return best;
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

// In another colour: a face, or all items of a layer that tell the same.
function highlight({ group, face, layer, item } = {}) {
  for (const other of groups) other.picked.visible = other === group;
  if (face) group.picked.geometry.setDrawRange(face.first, face.count);
  for (const old of pickedLines.children) old.geometry.dispose();
  pickedLines.remove(...pickedLines.children);
  if (!layer || layer.isMark) return;
  const same = layer.items.filter((other) => other.label === item.label);
  addLines(pickedLines, same.flatMap((other) => segmentsOf(other.line)), kPickedColour,
           1.4 * kLineWidth[layer.style], kOrder.pickedLines);
  layer.object.add(pickedLines);
}

function pick(x, y) {
  settle();
  raycaster.setFromCamera({ x: 2 * x / canvas.clientWidth - 1, y: 1 - 2 * y / canvas.clientHeight }, camera);
  raycaster.linePrecision = raycaster.params.Points.threshold = kReach / camera.zoom;
  const faces = facesHit(), item = itemHit(faces.length > 0 ? faces[0].distance : Infinity);
  highlight(item ?? faces[0]);
  const label = item ? item.item.label || item.layer.name : faces.length > 0 ? labelOf(faces[0]) : "";
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
        other.object.visible = box.checked;
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
  element("outlines").addEventListener("change", (event) => {
    for (const { outline } of groups) outline.visible = event.target.checked;
    redraw();
  });
  const views = { Iso: [1, -1, 1], Front: [0, -1, 0], Right: [1, 0, 0], Top: [0, 0, 1] };
  for (const [name, eye] of Object.entries(views)) {
    const button = document.createElement("button");
    button.textContent = name;
    button.addEventListener("click", () => look(eye));
    element("views").append(button);
  }
}

// ---- the mouse --------------------------------------------------------------------------------

// What is below the mouse stays there, which the wheel of OrbitControls does not see to.
function zoomAt(event) {
  event.preventDefault();
  event.stopPropagation();
  const x = event.offsetX - canvas.clientWidth / 2, y = canvas.clientHeight / 2 - event.offsetY;
  const wanted = camera.zoom * Math.exp(-0.0015 * event.deltaY);
  const zoom = Math.min(1e5 * fitted.zoom, Math.max(0.05 * fitted.zoom, wanted));
  const gain = 1 / camera.zoom - 1 / zoom;
  slide(axisOf(0).multiplyScalar(gain * x).addScaledVector(axisOf(1), gain * y));
  camera.zoom = zoom;
  redraw();
}

function listen() {
  let down = null;
  canvas.addEventListener("pointerdown", ({ offsetX, offsetY }) => { down = [offsetX, offsetY]; });
  canvas.addEventListener("pointerup", ({ offsetX, offsetY }) => {
    if (down && Math.hypot(offsetX - down[0], offsetY - down[1]) < 4) pick(offsetX, offsetY);
    down = null;
  });
  // The events of OrbitControls leave out moves that are short in model units.
  document.addEventListener("pointermove", (event) => { if (event.buttons !== 0) redraw(); });
  canvas.addEventListener("keydown", redraw);
  canvas.addEventListener("dblclick", () => look(data.eye));
  element("stage").addEventListener("wheel", zoomAt, { capture: true, passive: false });
  new ResizeObserver(() => {
    const whole = camera.zoom === fitted.zoom && controls.target.equals(fitted.target);
    if (whole) fit();
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
    redraw();
  }).observe(canvas);
}

fillPanel();
const context = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
if (context) {
  renderer = new THREE.WebGLRenderer({ canvas, context });
  renderer.setClearAlpha(0);
  listen();
  look(data.eye);
  document.body.dataset.triangles = groups.reduce((sum, group) => sum + group.triangles, 0);
  // For scripts and tests: where a point of an item is on the canvas; share 0 is its first point, 1 the last.
  window.blossomPage = {
    placeOf: (layer, item, share) => {
      const line = layers[layer].items[item].line, at = 3 * Math.round(share * (line.length / 3 - 1));
      return place(line.subarray(at, at + 3));
    },
    layers: layers.map((layer) => layer.name),
  };
} else {
  element("picked").textContent = "This browser has no WebGL 2, which the view needs.";
}
