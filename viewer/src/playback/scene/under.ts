// SPDX-License-Identifier: Apache-2.0
// Where in the scene a place of the picture is, for what is moved with the pointer.
import { Plane, Raycaster, Vector2, Vector3, type Camera } from 'three';

/** Rays flatter than this meet a level plane too far away to mean a place of it. */
const flattest = 0.05;
const up = new Vector3(0, 1, 0);
const caster = new Raycaster();
const plane = new Plane();
const facing = new Vector3();

/**
 * The point under `x`, `y` (both from -1 to 1) that is at the depth of `at`; where one looks along that level, the one that is as far
 * away as `at`. With `depth`, the point above or below `at`, null where one looks straight down.
 */
export function point_under(x: number, y: number, camera: Camera, at: Vector3, depth: boolean): Vector3 | null {
  caster.setFromCamera(new Vector2(x, y), camera);
  const { ray } = caster;
  if (!depth && Math.abs(ray.direction.y) > flattest) return ray.intersectPlane(plane.setFromNormalAndCoplanarPoint(up, at), new Vector3());
  facing.copy(ray.direction).setY(0);
  if (facing.length() < flattest) return null;
  const met = ray.intersectPlane(plane.setFromNormalAndCoplanarPoint(facing.normalize(), at), new Vector3());
  return met !== null && depth ? met.set(at.x, met.y, at.z) : met;
}
