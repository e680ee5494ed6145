// SPDX-License-Identifier: Apache-2.0
// Straight lines some pixels wide, all of them in one draw call.
import { BufferAttribute, BufferGeometry, type Color, type Vector3 } from 'three';
import { Instances, plain_fragment } from './instances';

function quad(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([1, 0, 0, -1, 0, 0, -1, 1, 0, 1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

const vertex = `
attribute vec3 from;
attribute vec3 to;
attribute vec2 span;
attribute vec4 tint;
uniform vec2 size;
uniform float ratio;
uniform float width;
uniform float now;
uniform float fade_s;
uniform float ahead;
varying vec4 v_tint;
void main() {
  vec4 a = modelViewMatrix * vec4(from, 1.0);
  vec4 b = modelViewMatrix * vec4(to, 1.0);
  // A line that comes from behind a perspective camera is cut in front of it.
  if (projectionMatrix[2][3] == -1.0) {
    float near = 0.9 * projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
    if (a.z > -near && b.z < -near) a.xyz = mix(a.xyz, b.xyz, (-near - a.z) / (b.z - a.z));
    else if (b.z > -near && a.z < -near) b.xyz = mix(b.xyz, a.xyz, (-near - b.z) / (a.z - b.z));
  }
  vec4 clip_a = projectionMatrix * a;
  vec4 clip_b = projectionMatrix * b;
  vec2 along = (clip_b.xy / clip_b.w - clip_a.xy / clip_a.w) * size;
  float length_px = length(along);
  along = length_px < 1e-6 ? vec2(1.0, 0.0) : along / length_px;
  vec4 clip = position.y < 0.5 ? clip_a : clip_b;
  float thick = width;
  v_tint = vec4(tint.rgb * tint.rgb, tint.a);
  #ifdef TIMED
    if (span.x >= now) {
      v_tint.a *= ahead;
      thick *= 0.6;
    } else if (span.y > now) {
      v_tint.a = 0.0;
    } else {
      float fresh = exp((span.y - now) / fade_s);
      v_tint.a *= mix(0.30, 1.0, fresh);
      thick *= mix(0.6, 1.0, fresh);
    }
  #endif
  clip.xy += vec2(-along.y, along.x) * position.x * thick * ratio / size * clip.w;
  gl_Position = v_tint.a == 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) : clip;
}`;

/** `timed`: each line has a span of time, and is drawn fresh, faded or ahead of the uniform `now`. */
export class Lines extends Instances {
  constructor(width_px: number, render_order: number, { timed = false, capacity = 64 } = {}) {
    super(quad(), timed ? [['from', 3], ['to', 3], ['span', 2]] : [['from', 3], ['to', 3]], render_order, {
      vertexShader: timed ? vertex : vertex.replace('attribute vec2 span;', ''), fragmentShader: plain_fragment,
      defines: timed ? { TIMED: '' } : {},
      uniforms: { width: { value: width_px }, now: { value: 0 }, fade_s: { value: 30 }, ahead: { value: 0.2 } },
    }, capacity);
  }

  add(a: Vector3, b: Vector3, colour: Color, alpha = 1): void {
    this.put([a.x, a.y, a.z, b.x, b.y, b.z], colour, alpha);
  }
  add_timed(a: Vector3, b: Vector3, from_s: number, to_s: number, colour: Color, alpha = 1): void {
    this.put([a.x, a.y, a.z, b.x, b.y, b.z, from_s, to_s], colour, alpha);
  }
  uniform(name: 'now' | 'fade_s' | 'ahead', value: number): void {
    this.object.material.uniforms[name]!.value = value;
  }
}
