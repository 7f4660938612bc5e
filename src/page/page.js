// Shows the scenes that canonical-pose has put into this page.

import {
  DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { VIRIDIS, isSameInput, load, objText, setColoring, setPosition } from './shapes.js';

const SECONDS_PER_STOP = 1.5;

const STANCES = { canonical: 'canonical', t: 'T', a: 'A', vitruvian: 'Vitruvian', stand: 'standing' };

const element = id => document.getElementById(id);

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
      this.scene.remove(this.shape.root);
    this.shape = shape;
    this.scene.add(shape.root);
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

function shown(figure) {
  if (typeof figure == 'string')
    return figure;
  return Number.isSafeInteger(figure) ? figure.toLocaleString('en-US') : figure.toPrecision(3);
}

function decoded(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}

function download(name, text) {
  const link = document.createElement('a');
  link.download = name;
  link.href = URL.createObjectURL(new Blob([text]));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000); // Safari asks before it reads
}

class Page {
  constructor(view, shapes) {
    this.view = view;
    this.groups = []; // scenes of the same input are one shape, in several stances
    for (const shape of shapes) {
      shape.group = this.groups.find(group => group.every(other => isSameInput(other, shape))) ?? [];
      if (shape.group.push(shape) == 1)
        this.groups.push(shape.group);
    }
    for (const group of this.groups) { // of one size
      const radius = Math.max(...group.map(shape => shape.radius));
      group.forEach(shape => shape.radius = radius);
    }
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    element('bar').style.background = 'linear-gradient(to right, ' + VIRIDIS.join() + ')';
    element('position').addEventListener('input', () => this.moveTo(Number(element('position').value)));
    element('play').addEventListener('click', () => this.play(!this.isPlaying));
    element('stance').addEventListener('change', () => this.chooseStance(element('stance').selectedIndex));
    element('colors').addEventListener('change', () => this.color(element('colors').selectedIndex));
    element('turn').addEventListener('change', () => this.turn(element('turn').checked));
    element('save').addEventListener('click', () => this.save());
    this.groups.forEach(group => this.addToGallery(group));
    element('gallery').hidden = this.groups.length == 1;
    element('shape').hidden = false;
    view.onFrame = time => this.advance(time);
    this.choose(shapes[0]);
    this.turn(!isStill);
  }

  addToGallery(group) {
    const [shape] = group;
    const button = document.createElement('button');
    button.type = 'button';
    const picture = document.createElement('img');
    picture.src = shape.picture;
    picture.alt = '';
    button.append(picture, shape.name);
    button.addEventListener('click', () => this.choose(shape));
    element('gallery').append(button);
    group.button = button;
  }

  // Position and colors stay.
  chooseStance(number) {
    const { group, position, coloring } = this.shape;
    setPosition(group[number], position);
    setColoring(group[number], coloring);
    this.choose(group[number]);
  }

  choose(shape) {
    this.play(false);
    this.shape = shape;
    this.groups.forEach(group => group.button.setAttribute('aria-pressed', group == shape.group));
    element('choice').hidden = shape.group.length == 1;
    element('stance').replaceChildren(...shape.group.map(({ stance }) => new Option(STANCES[stance] ?? stance)));
    element('stance').selectedIndex = shape.group.indexOf(shape);
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
    element('figures').replaceChildren(...shape.figures.map(([name, figure]) => {
      const row = document.createElement('tr');
      row.append(document.createElement('th'), document.createElement('td'));
      row.firstChild.textContent = name.replaceAll('_', ' ');
      row.firstChild.scope = 'row';
      row.lastChild.textContent = shown(figure);
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

  save() {
    const { name, stops, position } = this.shape;
    const pose = stops.length > 1 ? '_' + nameOfPosition(stops, position).replaceAll(' ', '_') : '';
    download(name + pose + '.obj', objText(this.shape));
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
  element('message').append(message + '\n');
  element('message').hidden = false;
}

async function main() {
  let view;
  try {
    view = new View(element('view'));
  } catch {
    return complain('This page requires WebGL 2, which this browser does not offer.');
  }
  const shapes = [];
  for (const source of document.querySelectorAll('script.scene')) {
    const { name } = source.dataset;
    try {
      const bytes = decoded(source.textContent);
      source.remove(); // a third of the memory
      const shape = await load(name, bytes);
      shape.picture = view.picture(shape);
      shapes.push(shape);
    } catch (error) {
      complain(name + ' cannot be shown: ' + String(error.message ?? error).replace('THREE.GLTFLoader: ', ''));
    }
  }
  if (shapes.length > 0)
    new Page(view, shapes);
}

main().catch(error => complain(error.message)).finally(() => document.querySelector('main').setAttribute('aria-busy', 'false'));
