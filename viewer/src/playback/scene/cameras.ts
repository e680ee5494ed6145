// SPDX-License-Identifier: Apache-2.0
// The four ways of looking: around, behind a vehicle, from above with north up, and from the south.
import { Box3, OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { CameraKind } from './stage_view';

const field_deg = 38;
/** In which a camera let go of loses most of its speed. */
const damping_ms = 80;
/** From the west of south, some way above: where one looks from at first; from higher up in an upright window. */
function first_look(aspect: number): Vector3 {
  return (aspect < 0.8 ? new Vector3(-0.2, 1.2, 0.85) : new Vector3(-0.55, 0.52, 0.85)).normalize();
}
/** Left free on both sides for what is written there. */
const margin_px = 44;
const upward = new Vector3(0, 1, 0);
const north = new Vector3(0, 0, -1);

const right = new Vector3();
const above = new Vector3();
const corner = new Vector3();
const centre = new Vector3();
const shift = new Vector3();

function corners_of(box: Box3): Vector3[] {
  return Array.from({ length: 8 }, (_, k) => new Vector3(k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z));
}

/** Where to look at from `direction`, and from how far, for the box to fill this part of the picture and be in its middle. */
function view_of(box: Box3, direction: Vector3, aspect: number, room: number): { target: Vector3; distance: number } {
  const tan = Math.tan((field_deg * Math.PI) / 360);
  right.crossVectors(upward, direction).normalize();
  above.crossVectors(direction, right);
  const target = box.getCenter(new Vector3());
  const corners = corners_of(box);
  let distance = 0;
  // What is nearer looks larger, so that the box' centre is not in the middle: a few rounds find what is.
  for (let round = 0; round < 6; ++round) {
    const seen = corners.map((p) => [corner.subVectors(p, target).dot(right), corner.dot(above), corner.dot(direction)] as const);
    distance = Math.max(...seen.map(([x, y, z]) => z + Math.max(Math.abs(x) / (tan * aspect * room), Math.abs(y) / (0.95 * tan))));
    const middle = (k: 0 | 1): number => {
      const slopes = seen.map((p) => p[k] / (distance - p[2]));
      return (distance * (Math.min(...slopes) + Math.max(...slopes))) / 2;
    };
    target.addScaledVector(right, 0.8 * middle(0)).addScaledVector(above, 0.8 * middle(1));
  }
  return { target, distance };
}

export class Cameras {
  kind: CameraKind = 'orbit';
  /** Whether the reader has moved it since the last fit. */
  moved = false;
  private readonly perspective = new PerspectiveCamera(field_deg, 1, 0.1, 1000);
  private readonly flat = { top: new OrthographicCamera(), side: new OrthographicCamera() };
  private readonly around: OrbitControls;
  private readonly across: { top: OrbitControls; side: OrbitControls };
  private readonly box = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  private radius = 1;
  private width = 1;
  private updated_ms = 0;
  private aspect = 1;
  /** Of the vehicle that `follow` keeps to, at the last picture. */
  private kept_heading: number | null = null;
  private orbit_place: { position: Vector3; target: Vector3 } | null = null;

  constructor(canvas: HTMLElement, changed: () => void) {
    this.around = new OrbitControls(this.perspective, canvas);
    this.around.enableDamping = true;
    this.across = { top: this.flat_controls('top', canvas), side: this.flat_controls('side', canvas) };
    for (const controls of [this.around, this.across.top, this.across.side]) {
      controls.zoomToCursor = true;
      controls.addEventListener('change', changed);
      controls.addEventListener('start', () => (this.moved = true));
    }
    this.enable();
  }

  private flat_controls(kind: 'top' | 'side', canvas: HTMLElement): OrbitControls {
    // Which way is up has to be settled before the controls are made.
    this.flat[kind].up.copy(kind === 'top' ? north : upward);
    const controls = new OrbitControls(this.flat[kind], canvas);
    controls.enableRotate = false;
    controls.screenSpacePanning = true;
    // Without rotation, one finger or the first button moves the chart.
    controls.mouseButtons.LEFT = 2;
    controls.touches.ONE = 1;
    return controls;
  }

  get camera(): Camera {
    return this.kind === 'top' || this.kind === 'side' ? this.flat[this.kind] : this.perspective;
  }

  private get controls(): OrbitControls {
    return this.kind === 'top' || this.kind === 'side' ? this.across[this.kind] : this.around;
  }

  private enable(): void {
    for (const controls of [this.around, this.across.top, this.across.side]) controls.enabled = controls === this.controls;
  }

  /** `follow` comes to the vehicle with the next `keep_to`; `orbit` returns to where it was. */
  set(kind: CameraKind): void {
    if (kind === this.kind) return;
    if (this.kind === 'orbit') this.orbit_place = { position: this.perspective.position.clone(), target: this.around.target.clone() };
    this.kind = kind;
    this.kept_heading = null;
    if (kind === 'orbit' && this.orbit_place) {
      this.perspective.position.copy(this.orbit_place.position);
      this.around.target.copy(this.orbit_place.target);
    }
    this.around.zoomToCursor = kind === 'orbit';
    this.around.enablePan = kind !== 'follow';
    this.enable();
    this.controls.update();
  }

  resize(width: number, height: number): void {
    this.aspect = width / Math.max(1, height);
    this.width = width;
    this.perspective.aspect = this.aspect;
    this.perspective.updateProjectionMatrix();
    for (const kind of ['top', 'side'] as const) this.span(kind, this.flat[kind].top);
  }

  private span(kind: 'top' | 'side', half: number): void {
    const camera = this.flat[kind];
    camera.top = half;
    camera.bottom = -half;
    camera.right = half * this.aspect;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
  }

  /** All of them look at the whole box again. */
  fit(box: Box3): void {
    this.moved = false;
    this.box.copy(box);
    this.radius = box.getSize(corner).length() / 2;
    box.getCenter(centre);
    const middle = centre.clone();
    const look = first_look(this.aspect);
    const room = Math.max(0.5, 1 - (2 * margin_px) / this.width);
    const { target, distance } = view_of(box, look, this.aspect, room);
    this.orbit_place = { position: target.clone().addScaledVector(look, distance), target };
    if (this.kind !== 'follow') {
      this.perspective.position.copy(this.orbit_place.position);
      this.around.target.copy(target);
    }
    this.kept_heading = null;
    const half = box.getSize(corner).multiplyScalar(0.5);
    this.look_flat('top', middle, upward, Math.max(1.12 * half.z, half.x / this.aspect / room));
    this.look_flat('side', middle, shift.copy(north).negate(), Math.max(1.4 * half.y, half.x / this.aspect / room));
    for (const controls of [this.around, this.across.top, this.across.side]) {
      controls.maxDistance = 12 * this.radius;
      controls.minDistance = 0.5;
      controls.update();
    }
  }

  private look_flat(kind: 'top' | 'side', middle: Vector3, from: Vector3, half: number): void {
    const camera = this.flat[kind];
    camera.position.copy(middle).addScaledVector(from, 4 * this.radius);
    camera.near = 0;
    camera.far = 8 * this.radius;
    camera.zoom = 1;
    this.across[kind].target.copy(middle);
    this.span(kind, half);
  }

  /** In `follow`, moves on with the vehicle and turns with its heading; what the reader has turned or zoomed stays. */
  keep_to(at: Vector3, heading: number, length: number): void {
    if (this.kind !== 'follow') return;
    if (this.kept_heading === null) {
      const back = Math.max(6 * length, 4);
      this.around.target.copy(at);
      this.perspective.position.copy(at).add(corner.set(-Math.sin(heading), 0.42, Math.cos(heading)).multiplyScalar(back));
    } else {
      shift.subVectors(this.perspective.position, this.around.target).applyAxisAngle(upward, this.kept_heading - heading);
      this.around.target.copy(at);
      this.perspective.position.copy(at).add(shift);
    }
    this.kept_heading = heading;
  }

  /** Another vehicle is followed from now on. */
  release(): void {
    this.kept_heading = null;
  }

  /** Before each picture: lets what the reader has pushed run out, and puts the planes about the scene. */
  update(): void {
    // By the clock, so that where pictures are slow the camera does not drift on for as many of them.
    const now_ms = performance.now();
    this.around.dampingFactor = Math.max(0.02, 1 - Math.exp((this.updated_ms - now_ms) / damping_ms));
    this.updated_ms = now_ms;
    this.controls.update();
    const away = this.perspective.position.distanceTo(this.box.getCenter(centre));
    this.perspective.near = Math.max(0.1, 0.002 * this.perspective.position.distanceTo(this.around.target));
    this.perspective.far = away + 4 * this.radius + 100;
    this.perspective.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }
}
