// Draws a walk with vtk.js: the model, the boxes that a ray has come to, and the step of now.
// A walk is what the visualizer's --export file.json writes (visualizer/json_files.h).
"use strict";

const walkColors = {
  model: [0.62, 0.66, 0.72],
  ray: [0.0, 0.45, 0.7],
  before: [0.45, 0.5, 0.65],
  now: [0.9, 0.62, 0.0],
  leftOut: [0.55, 0.55, 0.55],
  tested: [0.34, 0.71, 0.91],
  hit: [0.84, 0.37, 0.0],
};

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
  const [origin, end] = walk.ray;
  return polyDataOf([...origin, ...end], [2, 0, 1], []);
}

// Something drawn, whose shape can be changed: {show(data)}.
function addShape(renderer, data, color, settings) {
  const mapper = vtk.Rendering.Core.vtkMapper.newInstance();
  const actor = vtk.Rendering.Core.vtkActor.newInstance();
  mapper.setInputData(data);
  actor.setMapper(mapper);
  actor.getProperty().setColor(...color);
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
  walk.steps.filter((step) => step.box).forEach(
    (step) => step.box.forEach((corner) => corner.forEach(include)));
  return bounds;
}

// From the side and a little from above, so that the ray crosses the picture.
function aimCamera(renderer, walk) {
  const bounds = boundsOf(walk);
  const [origin, end] = walk.ray;
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
  const steps = walk.steps.slice(0, number + 1).filter((step) => step.hit.length > 0);
  return steps.length > 0 ? steps[steps.length - 1].hit : [];
}

// Draws the walk into the element. Returns {show(step), redraw()}: the first draws the step of that
// number.
function makeWalkScene(element, walk) {
  const view = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({
    background: [0.97, 0.97, 0.96], listenWindowResize: true,
  });
  view.setContainer(element);
  view.resize();
  const renderer = view.getRenderer();
  const nothing = polyDataOf([], [], []);
  addShape(renderer, modelOf(walk), walkColors.model, { opacity: 0.35 });
  addShape(renderer, rayOf(walk), walkColors.ray, { lineWidth: 3, lighting: false });
  const before = addShape(renderer, nothing, walkColors.before, { lineWidth: 1, lighting: false });
  const now = addShape(renderer, nothing, walkColors.now, { lineWidth: 4, lighting: false });
  const tested = addShape(renderer, nothing, walkColors.tested, { lighting: false });
  const hit = addShape(renderer, nothing, walkColors.hit, { lighting: false });
  aimCamera(renderer, walk);

  function redraw() {
    view.getRenderWindow().render();
  }
  function show(number) {
    const step = walk.steps[number];
    const isLeftOut = ["missed", "behind", "touched"].includes(step.outcome);
    before.show(boxLines(walk.steps.slice(0, number).map((s) => s.box).filter((box) => box)));
    now.show(boxLines(step.box ? [step.box] : []));
    now.actor.getProperty().setColor(...(isLeftOut ? walkColors.leftOut : walkColors.now));
    tested.show(trianglesOf(walk, step.tested));
    hit.show(trianglesOf(walk, lastHit(walk, number)));
    renderer.resetCameraClippingRange();
    redraw();
  }
  return { show, redraw };
}
