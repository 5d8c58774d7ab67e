// Draws a walk with vtk.js: the model, the boxes that a ray has come to, and the step of now.
// A walk is what the visualizer's --export file.json writes (visualizer/json_files.h).
"use strict";

// book.css has the colours, of a light page and of a dark one, by these names.
const colorNames = ["model", "structure", "ray", "before", "now", "left-out", "tested", "hit", "background"];

function colorsOf(element) {
  const style = getComputedStyle(element);
  return Object.fromEntries(colorNames.map((name) => {
    const hex = style.getPropertyValue(`--walk-${name}`).trim().slice(1);
    return [name, [0, 2, 4].map((place) => parseInt(hex.slice(place, place + 2), 16) / 255)];
  }));
}

// The twelve edges of a box, as pairs of corners: bit 0 of a corner is its x, bit 1 y, bit 2 z.
const boxEdges = [
  [0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7],
];

function polyDataOf(points, lines, polygons) {
  const data = vtk.Common.DataModel.vtkPolyData.newInstance();
  data.getPoints().setData(Float32Array.from(points), 3);
  data.getLines().setData(Uint32Array.from(lines));
  data.getPolys().setData(Uint32Array.from(polygons));
  return data;
}

function boxLines(boxes) {
  const points = [];
  const lines = [];
  boxes.forEach((box) => {
    const first = points.length / 3;
    for (let corner = 0; corner < 8; corner += 1) {
      points.push(box[corner & 1][0], box[(corner >> 1) & 1][1], box[(corner >> 2) & 1][2]);
    }
    boxEdges.forEach(([a, b]) => lines.push(2, first + a, first + b));
  });
  return polyDataOf(points, lines, []);
}

function trianglesOf(walk, numbers) {
  const points = [];
  const polygons = [];
  numbers.forEach((number) => {
    polygons.push(3);
    for (let corner = 0; corner < 3; corner += 1) {
      const place = 3 * walk.triangles[3 * number + corner];
      polygons.push(points.length / 3);
      points.push(...walk.points.slice(place, place + 3));
    }
  });
  return polyDataOf(points, [], polygons);
}

function modelOf(walk) {
  const polygons = [];
  for (let first = 0; first < walk.triangles.length; first += 3) {
    polygons.push(3, ...walk.triangles.slice(first, first + 3));
  }
  return polyDataOf(walk.points, [], polygons);
}

function rayOf(walk) {
  const [origin, end] = walk.line;
  return polyDataOf([...origin, ...end], [2, 0, 1], []);
}

// Something drawn, whose shape can be changed: {show(data), actor}.
function addShape(renderer, data, settings) {
  const mapper = vtk.Rendering.Core.vtkMapper.newInstance();
  const actor = vtk.Rendering.Core.vtkActor.newInstance();
  mapper.setInputData(data);
  actor.setMapper(mapper);
  actor.getProperty().set(settings);
  renderer.addActor(actor);
  return { show: (changed) => mapper.setInputData(changed), actor };
}

// Of the model and the boxes, as vtk.js wants it: least x, greatest x, least y ...
function boundsOf(walk) {
  const bounds = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
  const include = (value, axis) => {
    bounds[2 * axis] = Math.min(bounds[2 * axis], value);
    bounds[2 * axis + 1] = Math.max(bounds[2 * axis + 1], value);
  };
  walk.points.forEach((value, place) => include(value, place % 3));
  walk.boxes.forEach((box) => box.forEach((corner) => corner.forEach(include)));
  return bounds;
}

// From the side and a little from above, so that the ray crosses the picture.
function aimCamera(renderer, walk) {
  const bounds = boundsOf(walk);
  const [origin, end] = walk.line;
  const along = origin.map((value, axis) => value - end[axis]);
  const aside = [along[2] + 0.35 * along[0], 0.45 * Math.hypot(...along),
    -along[0] + 0.35 * along[2]];
  const camera = renderer.getActiveCamera();
  const middle = [0, 1, 2].map((axis) => 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]));
  camera.setFocalPoint(...middle);
  camera.setPosition(...middle.map((value, axis) => value + aside[axis]));
  camera.setViewUp(0, 1, 0);
  renderer.resetCamera(bounds);
  camera.zoom(1.1);
  renderer.resetCameraClippingRange();
}

// The triangles that the last step which hit any has hit, up to that step.
function lastHit(walk, number) {
  const steps = walk.steps.slice(0, number + 1).filter((step) => step.hits.length > 0);
  return steps.length > 0 ? steps[steps.length - 1].hits : [];
}

// Draws the walk into the element. Returns {show(step), redraw(), turn(x, y), recolor()}: the first draws
// the step of that number, or of -1 the whole structure; a turn is by pixels.
function makeWalkScene(element, walk) {
  const view = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({ listenWindowResize: true });
  view.setContainer(element);
  view.resize();
  const renderer = view.getRenderer();
  const nothing = polyDataOf([], [], []);
  const add = (data, settings) => addShape(renderer, data, settings);
  const shapes = {
    model: add(modelOf(walk), { opacity: 0.35 }),
    structure: add(boxLines(walk.boxes), { lineWidth: 1, lighting: false }),
    ray: add(rayOf(walk), { lineWidth: 3, lighting: false }),
    before: add(nothing, { lineWidth: 1, lighting: false }),
    now: add(nothing, { lineWidth: 4, lighting: false }),
    tested: add(nothing, { lighting: false }),
    hit: add(nothing, { lighting: false }),
  };
  let step = -1;
  aimCamera(renderer, walk);

  function redraw() {
    view.getRenderWindow().render();
  }
  function isLeftOut() {
    return step >= 0 && ["missed", "behind", "touched"].includes(walk.steps[step].outcome);
  }
  function recolor() {
    const colors = colorsOf(element);
    view.setBackground(...colors.background);
    Object.entries(shapes).forEach(([name, shape]) => shape.actor.getProperty().setColor(...colors[name]));
    shapes.now.actor.getProperty().setColor(...colors[isLeftOut() ? "left-out" : "now"]);
    redraw();
  }
  function show(number) {
    step = number;
    const seen = walk.steps.slice(0, Math.max(0, step)).map((one) => one.box).filter((box) => box);
    const { box, tested, hits } = step < 0 ? { box: null, tested: [], hits: [] } : walk.steps[step];
    const missed = tested.filter((triangle) => !hits.includes(triangle));
    shapes.structure.actor.getProperty().setOpacity(step < 0 ? 1 : 0.12);
    shapes.before.show(boxLines(seen));
    shapes.now.show(boxLines(box ? [box] : []));
    shapes.tested.show(trianglesOf(walk, missed));
    shapes.hit.show(trianglesOf(walk, lastHit(walk, step)));
    renderer.resetCameraClippingRange();
    recolor();
  }
  function turn(x, y) {
    const camera = renderer.getActiveCamera();
    camera.azimuth(-0.5 * x);
    camera.elevation(0.5 * y);
    camera.orthogonalizeViewUp();
    renderer.resetCameraClippingRange();
    redraw();
  }
  return { show, redraw, turn, recolor };
}
