// Shows the scenes that canonical-pose has put into this page.

import {
  BufferAttribute, Color, DirectionalLight, DoubleSide, HemisphereLight, Mesh, MeshStandardMaterial, PerspectiveCamera,
  Scene, SRGBColorSpace, Vector3, WebGLRenderer
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const VIRIDIS = ['#440154', '#472d7b', '#3b528b', '#2c718e', '#21918c', '#27ad81', '#5dc963', '#aadc32', '#fde725'];
const GRAY = '#808080';
const PLAIN = '#c3b59b';
const SECONDS_PER_STOP = 1.5;

const element = id => document.getElementById(id);

// ---- shapes ----------------------------------------------------------------------------------------

// The center and the radius of the input and of each other shape.
function extents(geometry) {
  const position = geometry.attributes.position;
  const point = new Vector3(), offset = new Vector3();
  return [null, ...(geometry.morphAttributes.position || [])].map(difference => {
    const forEachPoint = visit => {
      for (let i = 0; i < position.count; ++i) {
        point.fromBufferAttribute(position, i);
        if (difference)
          point.add(offset.fromBufferAttribute(difference, i));
        visit();
      }
    };
    const low = new Vector3().setScalar(Infinity), high = new Vector3().setScalar(-Infinity);
    forEachPoint(() => { low.min(point); high.max(point); });
    const center = low.add(high).multiplyScalar(0.5);
    let radius = 0;
    forEachPoint(() => radius = Math.max(radius, point.distanceTo(center)));
    return { center, radius };
  });
}

// The colorings of a mesh: name, attribute of colors, and the range of the legend, if any.
function colorings(geometry, { legend }) {
  const result = [];
  const { color, _label } = geometry.attributes;
  if (color)
    result.push({ name: legend ? legend.attribute.slice(1).toLowerCase() : _label ? 'parts' : 'colors', color,
      minimum: legend?.minimum, maximum: legend?.maximum });
  for (const [key, attribute] of Object.entries(geometry.attributes)) {
    const name = key.slice(1);
    if (key.startsWith('_') && key != '_vertex' && key != '_label' && !result.some(coloring => coloring.name == name))
      result.push(coloringByValues(name, attribute));
  }
  return [...result, { name: 'none' }];
}

// Negative values are unknown.
function coloringByValues(name, attribute) {
  let maximum = 0;
  for (let i = 0; i < attribute.count; ++i)
    maximum = Math.max(maximum, attribute.getX(i));
  const stops = VIRIDIS.map(stop => new Color(stop)), gray = new Color(GRAY), mixed = new Color();
  const color = new BufferAttribute(new Float32Array(3 * attribute.count), 3);
  for (let i = 0; i < attribute.count; ++i) {
    const value = attribute.getX(i);
    const position = maximum > 0 ? value / maximum * (stops.length - 1) : 0;
    const stop = Math.min(Math.floor(Math.max(position, 0)), stops.length - 2);
    const { r, g, b } = value < 0 ? gray : mixed.lerpColors(stops[stop], stops[stop + 1], position - stop);
    color.setXYZ(i, r, g, b);
  }
  return { name, color, minimum: 0, maximum };
}

function decoded(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}

async function load(source) {
  const name = source.dataset.name;
  const { scene } = await new GLTFLoader().parseAsync(decoded(source.textContent), '');
  source.remove(); // a third of the memory
  let loaded = null;
  scene.traverse(object => loaded = loaded || (object.isMesh && object));
  if (!loaded)
    throw new Error(name + ' has no surface');
  const { geometry, userData } = loaded;
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ side: DoubleSide, roughness: 0.75 }));
  mesh.material.flatShading = !geometry.attributes.normal;
  mesh.frustumCulled = false; // three.js does not know how far shapes reach
  const stops = ['input', ...(userData.targetNames || [])];
  const shape = { name, mesh, stops, extents: extents(geometry), colorings: colorings(geometry, userData),
    figures: userData.figures || {} };
  shape.radius = Math.max(...shape.extents.map(extent => extent.radius)) || 1;
  setColoring(shape, 0);
  setPosition(shape, stops.length - 1);
  return shape;
}

// Between two stops, points are interpolated, and so is the center.
function setPosition(shape, position) {
  const { mesh, extents, radius } = shape;
  const stop = Math.min(Math.floor(position), Math.max(extents.length - 2, 0)), share = position - stop;
  const weights = extents.map((_, i) => i == stop ? 1 - share : i == stop + 1 ? share : 0);
  weights.slice(1).forEach((weight, i) => mesh.morphTargetInfluences[i] = weight);
  mesh.position.set(0, 0, 0);
  weights.forEach((weight, i) => mesh.position.addScaledVector(extents[i].center, -weight / radius));
  mesh.scale.setScalar(1 / radius);
  shape.position = position;
}

function setColoring(shape, number) {
  const { color } = shape.colorings[number];
  const { geometry, material } = shape.mesh;
  if (color)
    geometry.setAttribute('color', color);
  material.vertexColors = Boolean(color);
  material.color.set(color ? '#ffffff' : PLAIN);
  material.needsUpdate = true;
  shape.coloring = number;
}

// ---- view ------------------------------------------------------------------------------------------

class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 0.1, 100);
    this.camera.position.set(0.85, 0.55, 3.8);
    const light = new DirectionalLight('#ffffff', 2);
    light.position.set(1, 2, 3);
    this.camera.add(light);
    this.scene.add(this.camera, new HemisphereLight('#ffffff', '#777788', 1.5));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.minDistance = 1;
    this.controls.maxDistance = 20;
    this.controls.addEventListener('change', () => this.update());
    canvas.addEventListener('keydown', event => this.turnByKey(event));
    new ResizeObserver(() => this.update()).observe(canvas);
    this.onFrame = () => false; // whether there is another frame to draw
  }

  show(shape) {
    if (this.shape)
      this.scene.remove(this.shape.mesh);
    this.shape = shape;
    this.scene.add(shape.mesh);
    this.update();
  }

  draw(width, height, pixelRatio) {
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.fov = width < height ? 30 * height / width : 30;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }

  // Draws the next frame, once.
  update() {
    if (this.isWaiting)
      return;
    this.isWaiting = true;
    requestAnimationFrame(time => {
      this.isWaiting = false;
      const goesOn = this.onFrame(time);
      this.controls.update();
      if (this.canvas.clientWidth > 0 && this.canvas.clientHeight > 0)
        this.draw(this.canvas.clientWidth, this.canvas.clientHeight, Math.min(devicePixelRatio, 2));
      if (goesOn)
        this.update();
    });
  }

  picture(shape) {
    this.show(shape);
    this.draw(240, 180, 1);
    return this.canvas.toDataURL();
  }

  turnByKey(event) {
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    const zooms = { '+': 0.9, '=': 0.9, '-': 1 / 0.9 };
    const { position } = this.camera;
    if (event.key in turns) {
      const [around, down] = turns[event.key];
      const sideways = new Vector3(0, 1, 0).cross(position).normalize();
      const turned = position.clone().applyAxisAngle(sideways, down);
      if (Math.abs(turned.y) < 0.99 * turned.length())
        position.copy(turned);
      position.applyAxisAngle(new Vector3(0, 1, 0), around);
    } else if (event.key in zooms)
      position.multiplyScalar(zooms[event.key]);
    else
      return;
    event.preventDefault();
    this.update();
  }
}

// ---- controls --------------------------------------------------------------------------------------

function nameOfPosition(stops, position) {
  const stop = Math.floor(position);
  return position == stop ? stops[stop] : 'between ' + stops[stop] + ' and ' + stops[stop + 1];
}

function shown(number) {
  return Number.isInteger(number) ? number.toLocaleString('en-US') : number.toPrecision(3);
}

class Page {
  constructor(view, shapes) {
    this.view = view;
    this.shapes = shapes;
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    element('bar').style.background = 'linear-gradient(to right, ' + VIRIDIS.join() + ')';
    element('position').addEventListener('input', () => this.moveTo(Number(element('position').value)));
    element('play').addEventListener('click', () => this.play(!this.isPlaying));
    element('colors').addEventListener('change', () => this.color(element('colors').selectedIndex));
    element('turn').addEventListener('change', () => this.turn(element('turn').checked));
    shapes.forEach(shape => this.addToGallery(shape));
    element('gallery').hidden = shapes.length == 1;
    element('shape').hidden = false;
    view.onFrame = time => this.advance(time);
    this.choose(shapes[0]);
    this.turn(!isStill);
  }

  addToGallery(shape) {
    const button = document.createElement('button');
    button.type = 'button';
    const picture = document.createElement('img');
    picture.src = this.view.picture(shape);
    picture.alt = '';
    button.append(picture, shape.name);
    button.addEventListener('click', () => this.choose(shape));
    element('gallery').append(button);
    shape.button = button;
  }

  choose(shape) {
    this.play(false);
    this.shape = shape;
    this.shapes.forEach(other => other.button.setAttribute('aria-pressed', other == shape));
    element('name').textContent = shape.name;
    element('morph').hidden = shape.stops.length == 1;
    element('position').max = shape.stops.length - 1;
    element('stops').replaceChildren(...shape.stops.map((name, i) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.addEventListener('click', () => this.moveTo(i));
      return button;
    }));
    element('colors').replaceChildren(...shape.colorings.map(({ name }) => new Option(name)));
    element('figures').replaceChildren(...Object.entries(shape.figures).map(([name, number]) => {
      const row = document.createElement('tr');
      row.append(document.createElement('th'), document.createElement('td'));
      row.firstChild.textContent = name.replaceAll('_', ' ');
      row.firstChild.scope = 'row';
      row.lastChild.textContent = shown(number);
      return row;
    }));
    this.color(shape.coloring);
    this.moveTo(shape.position);
    this.view.show(shape);
  }

  moveTo(position) {
    const slider = element('position');
    slider.value = position;
    slider.setAttribute('aria-valuetext', nameOfPosition(this.shape.stops, position));
    setPosition(this.shape, position);
    this.view.update();
  }

  color(number) {
    setColoring(this.shape, number);
    const { minimum, maximum } = this.shape.colorings[number];
    element('colors').selectedIndex = number;
    element('legend').hidden = maximum === undefined;
    if (maximum !== undefined) {
      element('minimum').textContent = shown(minimum);
      element('maximum').textContent = shown(maximum);
    }
    this.view.update();
  }

  turn(isTurning) {
    element('turn').checked = isTurning;
    this.view.controls.autoRotate = isTurning;
    this.view.update();
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    this.start = undefined;
    element('play').textContent = isPlaying ? 'Pause' : 'Play';
    element('play').setAttribute('aria-pressed', isPlaying);
    this.view.update();
  }

  // To the last shape and back.
  advance(time) {
    if (this.isPlaying) {
      const last = this.shape.stops.length - 1;
      this.start = this.start ?? time - 1000 * SECONDS_PER_STOP * (this.shape.position == last ? last : this.shape.position);
      const position = (time - this.start) / 1000 / SECONDS_PER_STOP % (2 * last);
      this.moveTo(Math.round(100 * Math.min(position, 2 * last - position)) / 100);
    }
    return this.isPlaying || this.view.controls.autoRotate;
  }
}

function complain(message) {
  element('message').textContent = message;
  element('message').hidden = false;
}

async function main() {
  const shapes = [];
  for (const source of document.querySelectorAll('script.scene'))
    shapes.push(await load(source));
  let view;
  try {
    view = new View(element('view'));
  } catch {
    return complain('This page requires WebGL 2, which this browser does not offer.');
  }
  new Page(view, shapes);
}

main().catch(error => complain(error.message)).finally(() => document.querySelector('main').setAttribute('aria-busy', 'false'));
