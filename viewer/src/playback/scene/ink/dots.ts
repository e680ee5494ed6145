// SPDX-License-Identifier: Apache-2.0
// Marks of constant size in pixels: discs, rings and targets, all of them in one draw call.
import { BufferAttribute, BufferGeometry, type Color, type Vector3 } from 'three';
import { Instances } from './instances';

const dot_kinds = { disc: 0, ring: 1, target: 2 } as const;
export type DotKind = keyof typeof dot_kinds;

function square(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

const vertex = `
attribute vec3 centre;
attribute vec4 mark;  // diameter [px], kind, a length [m], and how long that may look [px] before the mark fades
attribute vec4 tint;
uniform vec2 size;
uniform float ratio;
varying vec2 v_corner;
varying vec4 v_tint;
varying vec2 v_mark;
void main() {
  vec4 clip = projectionMatrix * modelViewMatrix * vec4(centre, 1.0);
  float pixels_per_metre = projectionMatrix[1][1] * 0.5 * size.y / ratio / clip.w;
  float shown = mark.z > 0.0 ? 1.0 - smoothstep(0.8 * mark.w, 1.6 * mark.w, mark.z * pixels_per_metre) : 1.0;
  v_corner = position.xy;
  v_mark = vec2(mark.x * ratio, mark.y);
  v_tint = vec4(tint.rgb * tint.rgb, tint.a * shown);
  clip.xy += position.xy * mark.x * ratio / size * clip.w;
  gl_Position = clip;
}`;

const fragment = `
varying vec2 v_corner;
varying vec4 v_tint;
varying vec2 v_mark;
void main() {
  float away = length(v_corner);
  float soft = 2.0 / v_mark.x;
  float inside = 1.0 - smoothstep(1.0 - soft, 1.0, away);
  float line = 3.4 / v_mark.x;
  float alpha = inside;
  if (v_mark.y > 0.5) alpha *= smoothstep(1.0 - soft - line, 1.0 - line, away);
  if (v_mark.y > 1.5) {
    float cross = 1.0 - smoothstep(line * 0.5, line * 0.5 + soft * 0.5, min(abs(v_corner.x), abs(v_corner.y)));
    alpha = max(alpha, cross * (1.0 - smoothstep(0.45, 0.45 + soft, away)));
  }
  if (alpha * v_tint.a < 0.01) discard;
  gl_FragColor = vec4(v_tint.rgb, v_tint.a * alpha);
  #include <colorspace_fragment>
}`;

/** `through`: seen through everything else. */
export class Dots extends Instances {
  constructor(render_order: number, through = false) {
    super(square(), [['centre', 3], ['mark', 4]], render_order,
      { vertexShader: vertex, fragmentShader: fragment, depthTest: !through }, 32);
  }

  /** `gone_px`: fades out where `metres` of the picture are longer than that. */
  add(centre: Vector3, kind: DotKind, diameter_px: number, colour: Color, alpha = 1, metres = 0, gone_px = 0): void {
    this.put([...centre, diameter_px, dot_kinds[kind], metres, gone_px], colour, alpha);
  }
}
