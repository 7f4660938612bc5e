// The shapes of scenes: loads, colors, moves and saves them. Files of other programs may contain anything.

import { BufferAttribute, Color, DoubleSide, Group, MeshStandardMaterial, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

export const VIRIDIS
  = ['#440154', '#472d7b', '#3b528b', '#2c718e', '#21918c', '#27ad81', '#5dc963', '#aadc32', '#fde725'];
const GRAY = '#808080';
const PLAIN = '#c3b59b';
const WHITE = '#ffffff';

// ---- points ----------------------------------------------------------------------------------------

function setWeights(meshes, weights) {
  for (const { mesh } of meshes)
    mesh.morphTargetInfluences?.forEach((_, i, influences) => influences[i] = weights[i]);
}

// In the coordinates of the file, as they are shown.
function forEachPoint({ mesh, frame }, visit) {
  const point = new Vector3();
  for (let i = 0; i < mesh.geometry.attributes.position.count; ++i)
    visit(mesh.getVertexPosition(i, point).applyMatrix4(frame), i);
}

// The center and the radius of the input and of each other shape.
function extents(meshes, numberOfOthers) {
  return Array.from({ length: numberOfOthers + 1 }, (_, shape) => {
    setWeights(meshes, Array.from({ length: numberOfOthers }, (_, i) => i + 1 == shape ? 1 : 0));
    const low = new Vector3().setScalar(Infinity), high = new Vector3().setScalar(-Infinity);
    meshes.forEach(part => forEachPoint(part, point => { low.min(point); high.max(point); }));
    const center = low.add(high).multiplyScalar(0.5);
    let radius = 0;
    meshes.forEach(part => forEachPoint(part, point => radius = Math.max(radius, point.distanceTo(center))));
    return { center, radius };
  });
}

// Between two stops, points are interpolated, and so is the center.
export function setPosition(shape, position) {
  const { root, meshes, extents, radius } = shape;
  const stop = Math.min(Math.floor(position), Math.max(extents.length - 2, 0)), share = position - stop;
  const weights = extents.map((_, i) => i == stop ? 1 - share : i == stop + 1 ? share : 0);
  setWeights(meshes, weights.slice(1));
  root.position.set(0, 0, 0);
  weights.forEach((weight, i) => root.position.addScaledVector(extents[i].center, -weight / radius));
  root.scale.setScalar(1 / radius);
  shape.position = position;
}

// ---- colors ----------------------------------------------------------------------------------------

// The colorings of meshes: name, for each mesh an attribute of colors or nothing, and the range of the legend, if any.
function colorings(meshes, legend, hasVariant) {
  const attributesOf = key => meshes.map(({ attributes }) => attributes[key]);
  const colors = attributesOf('color');
  const name = legend?.name || (attributesOf('_label').some(Boolean) ? 'parts' : 'colors');
  const result = colors.some(Boolean) ? [{ ...legend, name, colors }] : [];
  const hasTexture = meshes.some(({ material }) => material.map);
  if (hasTexture || meshes.some(({ material }) => material.color && !material.color.equals(new Color(WHITE)))) {
    const coloring = { name: hasTexture ? 'texture' : 'materials', colors, hasMaterials: true };
    if (hasTexture && !hasVariant && name == 'colors') // they belong to the texture
      result.unshift(coloring);
    else
      result.push(coloring);
  }
  const keys = new Set(meshes.flatMap(({ attributes }) => Object.keys(attributes).filter(
    key => key.startsWith('_') && key != '_vertex' && key != '_label' && attributes[key].itemSize == 1)));
  for (const key of keys)
    if (!result.some(({ name }) => name == key.slice(1)))
      result.push(coloringByValues(key.slice(1), attributesOf(key)));
  return [...result, { name: 'none' }];
}

function valuesOf(attribute) {
  return Array.from({ length: attribute?.count || 0 }, (_, i) => attribute.getX(i));
}

// Negative values are unknown.
function coloringByValues(name, attributes) {
  const isKnown = value => value >= 0 && value < Infinity;
  let maximum = 0;
  for (const attribute of attributes)
    maximum = valuesOf(attribute).filter(isKnown).reduce((a, b) => Math.max(a, b), maximum);
  const stops = VIRIDIS.map(stop => new Color(stop)), gray = new Color(GRAY), mixed = new Color();
  const colors = attributes.map(attribute => attribute && new BufferAttribute(new Float32Array(
    valuesOf(attribute).flatMap(value => {
      const position = maximum > 0 ? value / maximum * (stops.length - 1) : 0;
      const stop = Math.min(Math.floor(position), stops.length - 2);
      return (isKnown(value) ? mixed.lerpColors(stops[stop], stops[stop + 1], position - stop) : gray).toArray();
    })), 3));
  return { name, colors, minimum: 0, maximum };
}

export function setColoring(shape, number) {
  const { colors, hasMaterials } = shape.colorings[number];
  shape.meshes.forEach(({ mesh, plain, material }, i) => {
    const color = colors?.[i];
    if (color)
      mesh.geometry.setAttribute('color', color);
    plain.vertexColors = Boolean(color);
    plain.color.set(color ? WHITE : PLAIN);
    plain.needsUpdate = true;
    mesh.material = hasMaterials ? material : plain;
  });
  shape.coloring = number;
}

// ---- files -----------------------------------------------------------------------------------------

function legendOf({ legend }) {
  return typeof legend?.attribute == 'string' && [legend.minimum, legend.maximum].every(Number.isFinite)
    && { name: legend.attribute.replace(/^_/, '').toLowerCase(), minimum: legend.minimum, maximum: legend.maximum };
}

function figuresOf({ figures }) {
  const isObject = typeof figures == 'object' && !Array.isArray(figures);
  const result = Object.entries(isObject && figures || {}).filter(
    ([, value]) => typeof value == 'string' || Number.isFinite(value));
  return result.length > 0 && result;
}

function stanceOf({ stance }) {
  return typeof stance == 'string' && stance;
}

function targetNamesOf({ targetNames }) {
  return Array.isArray(targetNames) && targetNames.every(name => typeof name == 'string') && targetNames;
}

// Its default material, or that of the variant that shows the texture.
async function materialOf(mesh, parser, variant) {
  const mapping = mesh.userData.gltfExtensions?.KHR_materials_variants?.mappings?.find(
    ({ variants }) => variants.includes(variant));
  if (mapping) {
    mesh.material = await parser.getDependency('material', mapping.material);
    parser.assignFinalMaterial(mesh);
  }
  const material = mesh.material.clone();
  material.vertexColors &&= variant < 0; // else they are another coloring
  material.side = DoubleSide;
  material.metalness = 0; // metals have nothing to reflect here
  return material;
}

export async function load(name, bytes) {
  const loader = new GLTFLoader();
  let extras;
  loader.register(parser => { // without extras, which could mislead three.js
    extras = (parser.json.meshes || []).map(mesh => mesh.extras || {});
    parser.json = JSON.parse(JSON.stringify(parser.json, (key, value) => key == 'extras' ? undefined : value));
    return { name: 'extras' };
  });
  const { scene, parser } = await loader.parseAsync(bytes, '');
  const root = new Group();
  if (scene)
    root.add(scene);
  root.updateMatrixWorld(true);

  const variants = parser.json.extensions?.KHR_materials_variants?.variants || [];
  const variant = variants.findIndex(({ name }) => name == 'texture');
  const objects = [], meshes = [];
  root.traverse(object => {
    if (object.isMesh && object.geometry.attributes.position?.count > 0)
      objects.push(object);
    else
      object.layers.disableAll(); // lights, lines and points are not shown
  });
  for (const mesh of objects) {
    const plain = new MeshStandardMaterial(
      { side: DoubleSide, roughness: 0.75, flatShading: !mesh.geometry.attributes.normal });
    mesh.frustumCulled = false; // three.js does not know how far shapes reach
    meshes.push({ mesh, plain, material: await materialOf(mesh, parser, variant), frame: mesh.matrixWorld.clone(),
      attributes: { ...mesh.geometry.attributes } });
  }
  if (meshes.length == 0)
    throw new Error('it has no surface');

  const numberOfOthers = Math.max(...meshes.map(({ mesh }) => mesh.morphTargetInfluences?.length || 0));
  const names = extras.map(targetNamesOf).find(names => names && names.length == numberOfOthers) || [];
  const stops = ['input', ...Array.from({ length: numberOfOthers }, (_, i) => names[i] || 'shape ' + (i + 1))];
  const shape = { name, root, meshes, stops, extents: extents(meshes, numberOfOthers),
    colorings: colorings(meshes, extras.map(legendOf).find(Boolean), variant >= 0),
    figures: extras.map(figuresOf).find(Boolean) || [], stance: extras.map(stanceOf).find(Boolean) };
  shape.radius = Math.max(...shape.extents.map(({ radius }) => radius)) || 1;
  if (!shape.extents.every(({ radius }) => Number.isFinite(radius)))
    throw new Error('its coordinates are not finite');
  setColoring(shape, 0);
  setPosition(shape, stops.length - 1);
  return shape;
}

// Whether two scenes show the same input in different stances. Their numbers may be rounded.
export function isSameInput(a, b) {
  const sizesOf = ({ meshes }) => String(meshes.flatMap(
    ({ mesh: { geometry: { attributes, index } } }) => [attributes.position.count, index?.count]));
  const [first, second] = [a.extents[0], b.extents[0]], tolerance = 1e-3 * first.radius;
  return a.stance && b.stance && a.stance != b.stance && sizesOf(a) == sizesOf(b)
    && Math.abs(first.radius - second.radius) < tolerance && first.center.distanceTo(second.center) < tolerance;
}

// The vertices as lines of a file, by their keys; nothing if vertices with the same key have different positions.
function linesByKey(meshes, keyOf) {
  const lines = new Map();
  let isUnique = true;
  meshes.forEach((part, k) => forEachPoint(part, ({ x, y, z }, i) => {
    const key = keyOf(k, i), line = `v ${x} ${y} ${z}`;
    isUnique &&= (lines.get(key) ?? line) == line;
    lines.set(key, line);
  }));
  return isUnique && lines;
}

// The shape as it is shown, as an .obj file in the coordinates of its file. Vertices are those of the input, in its
// order, if the file has their indices; else those of the file, once where meshes share them.
export function objText({ meshes }) {
  const starts = [];
  let end = 0;
  for (const { attributes, frame } of meshes) {
    const sharing = meshes.findIndex(
      other => other.attributes.position == attributes.position && other.frame.equals(frame));
    starts.push(starts[sharing] ?? end);
    end = Math.max(end, starts.at(-1) + attributes.position.count);
  }
  let keyOf = (k, i) => meshes[k].attributes._vertex.getX(i);
  let lines = meshes.every(({ attributes }) => attributes._vertex) && linesByKey(meshes, keyOf);
  if (!lines) {
    keyOf = (k, i) => starts[k] + i;
    lines = linesByKey(meshes, keyOf);
  }

  const keys = [...lines.keys()].sort((a, b) => a - b);
  const indices = new Map(keys.map((key, i) => [key, i + 1]));
  const faces = meshes.flatMap(({ mesh, attributes, frame }, k) => {
    const { index } = mesh.geometry;
    const corners = index ? valuesOf(index) : valuesOf(attributes.position).map((_, i) => i);
    const isMirrored = frame.determinant() < 0;
    return Array.from({ length: Math.floor(corners.length / 3) }, (_, f) => {
      const face = corners.slice(3 * f, 3 * f + 3).map(i => indices.get(keyOf(k, i)));
      return 'f ' + (isMirrored ? face.reverse() : face).join(' ');
    });
  });
  return [...keys.map(key => lines.get(key)), ...faces, ''].join('\n');
}
