// Scenes as other programs may write them, and what the page shows of them. Writes them, and prints their names:
//   node scenes_of_others.js FOLDER
// Each is a box of two primitives, the sides and the ends, with two morph targets and a node that mirrors.
'use strict';
const fs = require('fs'), path = require('path');

// Two rows of two pixels: red, green; blue, yellow.
const image = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAFElEQVR42mP4z8DAAMIM////ZwAAHu8E/HMcU8wAAA'
  + 'AASUVORK5CYII=', 'base64');
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);
const sides = [[4, 5, 7, 6], [5, 1, 3, 7], [1, 0, 2, 3], [0, 4, 6, 2]], ends = [[6, 7, 3, 2], [0, 1, 5, 4]];

class Glb {
  constructor() {
    this.bytes = [];
    this.length = 0;
    this.json = { asset: { version: '2.0' }, bufferViews: [], accessors: [] };
  }

  view(bytes) {
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length });
    this.bytes.push(bytes, Buffer.alloc(-bytes.length & 3));
    this.length += bytes.length + (-bytes.length & 3);
    return this.json.bufferViews.length - 1;
  }

  numbers(rows, Type = Float32Array) {
    const columns = rows[0].length ?? 1, numbers = rows.flat();
    const bufferView = this.view(Buffer.from(Type.from(numbers).buffer));
    this.json.accessors.push({ bufferView, componentType: Type == Float32Array ? 5126 : 5123, count: rows.length,
      type: columns == 1 ? 'SCALAR' : 'VEC' + columns, ...columns == 3 && {
        min: [0, 1, 2].map(k => Math.min(...rows.map(row => row[k]))),
        max: [0, 1, 2].map(k => Math.max(...rows.map(row => row[k]))) } });
    return this.json.accessors.length - 1;
  }

  file() {
    this.json.buffers = [{ byteLength: this.length }];
    const text = Buffer.from(JSON.stringify(this.json));
    const chunks = [[0x4e4f534a, Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')])],
      [0x004e4942, Buffer.concat(this.bytes)]];
    const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
    const body = Buffer.concat(chunks.flatMap(([type, bytes]) => [words(bytes.length, type), bytes]));
    return Buffer.concat([words(0x46546c67, 2, 12 + body.length), body]);
  }
}

// What belongs to the vertices of these faces, four each.
function vertices(glb, faces, { hasColors, hasLabels }) {
  const points = faces.flat().map(i => corners[i]), texture = [[0, 1], [1, 1], [1, 0], [0, 0]];
  return {
    attributes: {
      POSITION: glb.numbers(points),
      TEXCOORD_0: glb.numbers(faces.flatMap(() => texture)),
      _SPEED: glb.numbers(faces.flat().map(i => [NaN, -1, Infinity, 1e30, 0, 1, 2, 3][i])),
      ...hasColors && { COLOR_0: glb.numbers(points.map(() => [1, 0, 1])) },
      ...hasLabels && { _LABEL: glb.numbers(points.map(() => faces.length == 4 ? 0 : 1)),
        _VERTEX: glb.numbers(faces.flat()) }
    },
    targets: [
      { POSITION: glb.numbers(points.map(([, y]) => [0, y > 0 ? 1 : 0, 0])) },
      { POSITION: glb.numbers(points.map(([, y]) => [0.5 * y, 0, 0])) }
    ]
  };
}

function triangles(glb, numberOfFaces, first) {
  return glb.numbers(Array.from({ length: numberOfFaces }, (_, f) => [0, 1, 2, 0, 2, 3].map(i => first + 4 * f + i)).flat(),
    Uint16Array);
}

// The extras are everywhere.
function box({ extras, hasColors = true, hasLabels = true, hasTexture = true, hasVariant = true, hasImage = true }) {
  const glb = new Glb(), { json } = glb;
  const shared = !hasLabels && vertices(glb, [...sides, ...ends], { hasColors });
  const primitives = [sides, ends].map((faces, i) => ({
    ...shared || vertices(glb, faces, { hasColors, hasLabels }),
    indices: triangles(glb, faces.length, shared && i == 1 ? 4 * sides.length : 0),
    material: hasVariant ? 0 : 1, extras,
    ...hasVariant && { extensions: { KHR_materials_variants: { mappings: [{ material: 1, variants: [1] }] } } }
  }));
  Object.assign(json, {
    scene: 0, scenes: [{ nodes: [0], extras }],
    nodes: [{ mesh: 0, translation: [100, 20, 3], scale: [-1, 2, 1], extras }],
    meshes: [{ primitives, extras }],
    materials: [{ extras }, { extras, pbrMetallicRoughness: hasTexture ? { baseColorTexture: { index: 0 } }
      : { baseColorFactor: [0.8, 0.1, 0.1, 1] } }]
  });
  if (hasVariant)
    Object.assign(json, { extensionsUsed: ['KHR_materials_variants'],
      extensions: { KHR_materials_variants: { variants: [{ name: 'other' }, { name: 'texture' }] } } });
  if (hasTexture)
    Object.assign(json, { textures: [{ source: 0, sampler: 0, extras }], samplers: [{ magFilter: 9728, minFilter: 9728 }],
      images: [hasImage ? { bufferView: glb.view(image), mimeType: 'image/png', extras } : {}] });
  return glb.file();
}

const numbered = ['input', 'shape 1', 'shape 2'], all = ['parts', 'texture', 'speed', 'none'];

const scenes = [
  { name: 'textured', parameters: { extras: { targetNames: ['long', 'sheared'] } },
    stops: ['input', 'long', 'sheared'], colors: all },
  { name: 'own_colors', parameters: { hasLabels: false, hasVariant: false }, colors: ['texture', 'colors', 'speed', 'none'] },
  { name: 'materials', parameters: { hasColors: false, hasTexture: false, hasVariant: false },
    colors: ['materials', 'speed', 'none'] },
  { name: 'legend', parameters: { extras: { legend: { attribute: '_SPEED', minimum: 0, maximum: 2 } } },
    colors: ['speed', 'texture', 'none'] },
  ...[
    null, 'text', 7, [1, [2]], { gltfExtensions: 'text', name: {}, isMesh: false },
    { targetNames: 'two', legend: 'viridis', figures: 'many' },
    { targetNames: ['one'], legend: { minimum: 0, maximum: 1 }, figures: [1, 2] },
    { targetNames: [1, null], legend: { attribute: {}, minimum: 0, maximum: 1 }, figures: 7 },
    { targetNames: { length: 2 }, legend: { attribute: '_SPEED', minimum: '0', maximum: null }, figures: null },
    { targetNames: ['', { deep: [] }], legend: [], figures: { stress: {}, energy: [1], faces: null, inverted: true } }
  ].map((extras, i) => ({ name: 'extras_' + i, parameters: { extras } })),
  { name: 'figures', parameters: { extras: { figures: { stress: 'very <i>large</i>', vertices: 1e300, faces: {} } } },
    figures: ['stress', 'very <i>large</i>', 'vertices', '1.00e+300'] }
].map(scene => ({ stops: numbered, colors: all, figures: [], ...scene, bytes: box(scene.parameters) }));

// Files that the program reads, or would read, but that three.js cannot show.
const withoutSurface = new Glb();
Object.assign(withoutSurface.json, { scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ mode: 0, attributes: { POSITION: withoutSurface.numbers(corners) } }] }] });
const unshown = [
  { name: 'without_image', bytes: box({ hasImage: false }) },
  { name: 'without_surface', bytes: withoutSurface.file() },
  { name: 'words', bytes: Buffer.from('words') }
];

module.exports = { scenes, unshown };

if (require.main == module) {
  const files = scenes.map(({ name }) => path.join(process.argv[2], name + '.glb'));
  scenes.forEach(({ bytes }, i) => fs.writeFileSync(files[i], bytes));
  process.stdout.write(files.join(';')); // a list of CMake
}
