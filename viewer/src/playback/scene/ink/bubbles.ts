// SPDX-License-Identifier: Apache-2.0
// Translucent spheres with an equator and two meridians, all of them in one draw call.
import { DoubleSide, SphereGeometry, type Color, type Vector3 } from 'three';
import { Instances } from './instances';

const vertex = `
attribute vec3 centre;
attribute float radius;
attribute vec4 tint;
varying vec3 v_point;
varying vec3 v_normal;
varying vec3 v_view;
varying vec4 v_tint;
void main() {
  v_point = position;
  v_normal = normalMatrix * position;
  vec4 seen = modelViewMatrix * vec4(centre + radius * position, 1.0);
  v_view = isOrthographic ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  v_tint = vec4(tint.rgb * tint.rgb, tint.a);
  gl_Position = projectionMatrix * seen;
}`;

const fragment = `
uniform float fill;
uniform float rim;
uniform float circles;
uniform float hatch;
uniform float ratio;
varying vec3 v_point;
varying vec3 v_normal;
varying vec3 v_view;
varying vec4 v_tint;
float near_circle(float height) {
  return 1.0 - smoothstep(0.5, 1.3, abs(height) / max(fwidth(height), 1e-6));
}
void main() {
  float facing = abs(dot(normalize(v_normal), normalize(v_view)));
  float circle = max(near_circle(v_point.y), max(near_circle(v_point.x), near_circle(v_point.z)));
  float alpha = gl_FrontFacing ? fill + rim * pow(1.0 - facing, 3.0) : 0.0;
  alpha = max(alpha, circle * circles * (gl_FrontFacing ? 1.0 : 0.45));
  if (hatch > 0.0 && fract((gl_FragCoord.x + gl_FragCoord.y) / (hatch * ratio)) > 0.5) alpha *= 0.3;
  gl_FragColor = vec4(v_tint.rgb * (0.8 + 0.2 * facing), v_tint.a * alpha);
  #include <colorspace_fragment>
}`;

/** Opacities: of the whole face, of the silhouette on top, of the circles. `hatch`: width of a stripe and its gap [px], 0 for none. */
export interface BubbleStyle {
  fill: number;
  rim: number;
  circles: number;
  hatch?: number;
}

/** Of a `crowd`, each is drawn with fewer faces. */
export class Bubbles extends Instances {
  constructor({ fill, rim, circles, hatch = 0 }: BubbleStyle, render_order: number, crowd = 1) {
    super(crowd > 16 ? new SphereGeometry(1, 32, 20) : new SphereGeometry(1, 60, 36), [['centre', 3], ['radius', 1]], render_order, {
      vertexShader: vertex, fragmentShader: fragment, side: DoubleSide,
      uniforms: { fill: { value: fill }, rim: { value: rim }, circles: { value: circles }, hatch: { value: hatch } },
    }, 16);
  }

  add(centre: Vector3, radius: number, colour: Color, alpha = 1): void {
    this.put([...centre, radius], colour, alpha);
  }
}
