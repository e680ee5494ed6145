// SPDX-License-Identifier: Apache-2.0
// The picture in three dimensions: its parts, cameras and labels, drawn only when something has changed.
import { AmbientLight, DirectionalLight, HemisphereLight, Scene as World, SRGBColorSpace, WebGLRenderer, type Vector3 } from 'three';
import type { Film, Moment } from '../film';
import type { Scene, Vec3 } from '../model';
import { place_of } from './axes';
import { Cameras } from './cameras';
import { read_colours, type Colours } from './colours';
import { extent_of, type Extent } from './extent';
import { viewport } from './ink/instances';
import { StageKey } from './key';
import { Labels, project, type Label } from './labels';
import type { Part } from './part';
import { fit_parts, make_parts, type Parts } from './parts/all';
import { Vehicles } from './parts/vehicles';
import { picture_of } from './picture';
import { vehicle_at, watch_pointer } from './picker';
import { Poses, steady_heading } from './poses';
import { point_under } from './under';
import { layers, type CameraKind, type Layer, type MakeStage, type StageView } from './stage_view';
import './stage.css';

const heading_window_s = 2;
/** Who has nothing to draw for this long does not play. */
const pause_ms = 150;

/** Whether the processor draws, for want of a graphics card. */
function is_drawn_by_processor(renderer: WebGLRenderer): boolean {
  const gl = renderer.getContext();
  const unmasked = gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(gl.getParameter(unmasked)));
}

function make_renderer(): WebGLRenderer {
  try {
    const plain = new WebGLRenderer({ powerPreference: 'high-performance' });
    if (is_drawn_by_processor(plain)) return plain;
    // Smooth edges would halve the pace of a processor; a graphics card has them for nothing.
    plain.dispose();
    return new WebGLRenderer({ antialias: true, powerPreference: 'high-performance' });
  } catch {
    throw new Error('This browser shows no WebGL, which the picture in three dimensions needs');
  }
}

class Stage implements StageView {
  frames_per_second = 0;
  private readonly renderer = make_renderer();
  private readonly canvas = this.renderer.domElement;
  private readonly world = new World();
  private readonly lights = [new HemisphereLight(), new DirectionalLight(), new AmbientLight()] as const;
  private readonly labels = new Labels();
  private readonly key = new StageKey();
  private readonly cameras: Cameras;
  private readonly poses: Poses;
  private readonly vehicles: Vehicles;
  private readonly parts: Parts;
  /** The same, for what is done to each. */
  private readonly by_layer: Record<Layer, Part>;
  private colours: Colours;
  private extent: Extent;
  private moment: Moment = { time: 0, index: 0, part: 0 };
  private chosen: ReadonlySet<number> = new Set();
  private followed = 0;
  private picked: ((vehicle: number | null, adding: boolean) => void) | null = null;
  private drawn: () => void = () => {};
  /** Whether what is shown has changed since the last picture, besides the camera. */
  private stale = true;
  private requested = 0;
  private last_picture_ms = 0;
  private mean_ms = 0;
  /** When the last picture was done, and whether the next one came long after it. */
  private drawn_ms = 0;
  private paused = true;
  private size = '';
  /** Of the film, when the extent was last measured. */
  private measured = { count: -1, generation: -1 };

  constructor(private readonly host: HTMLElement, private readonly scene: Scene, private readonly film: Film) {
    host.classList.add('stage');
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.poses = new Poses(film);
    this.vehicles = new Vehicles(scene);
    this.parts = make_parts(scene, film);
    this.by_layer = this.parts;
    this.world.add(...this.lights, this.vehicles.object, ...layers.map((layer) => this.parts[layer].object));
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'The run in three dimensions');
    host.append(this.canvas, this.labels.element, this.key.element);
    this.cameras = new Cameras(this.canvas, () => this.request());
    this.colours = read_colours(host);
    this.extent = extent_of(scene, film);
    this.restyle();
    this.resize();
    this.fit();
    this.listen();
    this.renderer.compile(this.world, this.cameras.camera);
  }

  private listen(): void {
    new ResizeObserver(() => this.resize()).observe(this.host);
    this.canvas.addEventListener('webglcontextrestored', () => this.refresh());
    watch_pointer(this.canvas, (x, y, adding) => this.picked?.(this.vehicle_at(x, y), adding), (x, y) => this.point_at(x, y));
  }

  show(moment: Moment): void {
    this.moment = moment;
    this.refresh();
  }

  choose(vehicles: ReadonlySet<number>): void {
    this.chosen = new Set(vehicles);
    this.refresh();
  }

  follow(vehicle: number): void {
    if (vehicle !== this.followed) this.cameras.release();
    this.followed = vehicle;
    this.parts.names.followed = vehicle;
    this.refresh();
  }

  set_camera(kind: CameraKind): void {
    this.cameras.set(kind);
    this.refresh();
  }

  set_layer(layer: Layer, shown: boolean): void {
    this.parts[layer].object.visible = shown;
    this.refresh();
  }

  fit(): void {
    this.measure();
    this.cameras.fit(this.extent.view);
    this.refresh();
  }

  restyle(): void {
    this.colours = read_colours(this.host);
    this.renderer.setClearColor(this.colours.deep);
    this.light();
    this.vehicles.restyle(this.colours);
    fit_parts(this.parts, this.colours, this.extent);
    this.refresh();
  }

  place_of(vehicle: number): { x: number; y: number } | null {
    const at = this.poses.positions[vehicle];
    if (at === undefined) return null;
    this.settle();
    return this.seen(at);
  }

  point_of(place: Vec3): { x: number; y: number } | null {
    return this.seen(place_of(place));
  }

  place_under(x: number, y: number, at: Vec3, depth: boolean): Vec3 | null {
    const found = point_under((2 * x) / this.host.clientWidth - 1, 1 - (2 * y) / this.host.clientHeight, this.cameras.camera, place_of(at), depth);
    return found && [-found.z, found.x, -found.y];
  }

  private seen(at: Vector3): { x: number; y: number } | null {
    const point = project(at, this.cameras.camera, this.host.clientWidth, this.host.clientHeight);
    return point && { x: point.x, y: point.y };
  }

  on_draw(listener: () => void): void {
    this.drawn = listener;
  }

  on_pick(listener: (vehicle: number | null, adding: boolean) => void): void {
    this.picked = listener;
  }

  picture(): Promise<Blob> {
    // The buffer is only certain to hold the picture until the browser has shown it.
    this.draw();
    return picture_of(this.canvas, this.labels.placed, this.colours.deep.getStyle());
  }

  private light(): void {
    const [sky, sun, around] = this.lights;
    const { dark } = this.colours;
    sky.color.set('#ffffff');
    sky.groundColor.set(dark ? '#5d7486' : '#8aa0ae');
    sky.intensity = dark ? 1.5 : 1.7;
    sun.position.set(-0.5, 1, 0.4);
    sun.intensity = dark ? 1.7 : 1.6;
    around.intensity = dark ? 0.5 : 0.4;
  }

  /** How far the film reaches now. */
  private measure(): void {
    this.measured = { count: this.film.count, generation: this.film.generation };
    this.extent = extent_of(this.scene, this.film);
    fit_parts(this.parts, this.colours, this.extent);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    const ratio = Math.min(devicePixelRatio, 2);
    const size = `${width} x ${height} at ${ratio}`;
    if (width === 0 || height === 0 || size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.cameras.resize(width, height);
    if (!this.cameras.moved) this.cameras.fit(this.extent.view);
    // A canvas of another size is empty until it is drawn on, so that waiting would show as a flicker.
    if (this.drawn_ms > 0) this.draw();
  }

  private refresh(): void {
    this.stale = true;
    this.request();
  }

  private request(): void {
    if (this.requested !== 0) return;
    this.paused = performance.now() - this.drawn_ms > pause_ms;
    this.requested = requestAnimationFrame((now) => this.on_frame(now));
  }

  private on_frame(now_ms: number): void {
    this.requested = 0;
    this.count_frame(now_ms);
    this.draw();
  }

  /** The mean over about a second of playing, from one picture's beginning to the next one's. */
  private count_frame(now_ms: number): void {
    const taken_ms = now_ms - this.last_picture_ms;
    this.last_picture_ms = now_ms;
    if (this.paused || taken_ms <= 0) return;
    this.mean_ms += Math.min(1, taken_ms / 1000) * (taken_ms - this.mean_ms);
    this.frames_per_second = 1000 / this.mean_ms;
  }

  private draw(): void {
    if (this.renderer.getContext().isContextLost()) return;
    this.settle();
    this.renderer.getDrawingBufferSize(viewport.size.value);
    viewport.ratio.value = this.renderer.getPixelRatio();
    const { camera } = this.cameras;
    this.parts.grid.face(camera);
    this.renderer.render(this.world, camera);
    this.labels.place(this.written(), camera, this.host.clientWidth, this.host.clientHeight);
    this.drawn();
    this.drawn_ms = performance.now();
  }

  /** Brings everything to the moment and the camera to its place. */
  private settle(): void {
    if (this.stale) {
      this.stale = false;
      this.grow();
      this.show_parts();
    }
    this.cameras.update();
  }

  /** A live film reaches further and further: where it has doubled, the frame follows, and a camera that nobody has moved. */
  private grow(): void {
    const { count, generation } = this.measured;
    if (this.film.generation === generation && this.film.count >= count && this.film.count < 2 * count) return;
    if (this.film.count === count) return;
    this.measure();
    if (!this.cameras.moved) this.cameras.fit(this.extent.view);
  }

  private show_parts(): void {
    if (this.film.count > 0) this.poses.update(this.moment);
    const now = {
      moment: this.moment, poses: this.poses, chosen: this.chosen, colours: this.colours,
      thinkers: this.chosen.size > 0 ? [...this.chosen] : [this.followed],
    };
    this.vehicles.show(now);
    for (const part of this.shown_parts()) part.show(now);
    this.key.show(this.shown_parts().flatMap((part) => part.key?.() ?? []));
    const spec = this.scene.vehicles[this.followed];
    if (this.cameras.kind === 'follow' && spec && this.film.count > 0) {
      this.cameras.keep_to(this.poses.positions[this.followed]!, steady_heading(this.film, this.moment, this.followed, heading_window_s), spec.length_m);
    }
  }

  private shown_parts(): Part[] {
    return layers.map((layer) => this.by_layer[layer]).filter((part) => part.object.visible);
  }

  private written(): Label[] {
    const beside = this.shown_parts().flatMap((part) => part.labels?.() ?? []);
    return [...beside, ...this.parts.names.labels_from(this.cameras.camera)];
  }

  private vehicle_at(x: number, y: number): number | null {
    this.settle();
    return vehicle_at(x, y, {
      camera: this.cameras.camera, positions: this.poses.positions, radii: this.scene.vehicles.map((v) => v.length_m / 2),
      width: this.host.clientWidth, height: this.host.clientHeight,
    });
  }

  private point_at(x: number, y: number): void {
    const vehicle = Number.isNaN(x) ? null : this.vehicle_at(x, y);
    if (vehicle === this.vehicles.hovered) return;
    this.vehicles.hovered = vehicle;
    this.parts.names.hovered = vehicle;
    this.canvas.classList.toggle('over-vehicle', vehicle !== null);
    this.refresh();
  }
}

export const make_stage: MakeStage = (host, scene, film) => new Stage(host, scene, film);
