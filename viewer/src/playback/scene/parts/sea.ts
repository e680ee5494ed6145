// SPDX-License-Identifier: Apache-2.0
// The surface, lifted by every wave of the run's sea; clearest where one looks straight down through it.
import { DoubleSide, Group, Mesh, PlaneGeometry, ShaderMaterial, Vector4 } from 'three';
import type { Scene, Wave } from '../../model';
import type { Extent } from '../extent';
import { order, type Now, type Part } from '../part';

/** Along each side: at most, and for each length of the shortest wave. */
const most_cells = 160;
const cells_per_wave = 8;
/** What a shader's uniforms hold for certain; of more waves the greatest are drawn. */
const most_waves = 48;

const vertex = `
uniform vec4 waves[WAVES];   // amplitude, wave number north and east, frequency
uniform float phases[WAVES];
uniform float time;
varying vec3 v_normal;
varying vec3 v_view;
varying vec2 v_edge;
void main() {
  vec4 at = modelMatrix * vec4(position.x, 0.0, position.z, 1.0);
  float up = 0.0;
  vec2 slope = vec2(0.0);
  for (int i = 0; i < WAVES; ++i) {
    float angle = -waves[i].y * at.z + waves[i].z * at.x - waves[i].w * time + phases[i];
    up += waves[i].x * cos(angle);
    slope -= waves[i].x * sin(angle) * vec2(waves[i].z, -waves[i].y);
  }
  at.y += up;
  vec4 seen = viewMatrix * at;
  // Light and shade as of a sea three times as steep, or gentle waves would not be seen.
  v_normal = normalize((viewMatrix * vec4(-3.0 * slope.x, 1.0, -3.0 * slope.y, 0.0)).xyz);
  v_view = isOrthographic ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  v_edge = 2.0 * abs(uv - 0.5);
  gl_Position = projectionMatrix * seen;
}`;

const fragment = `
uniform vec3 colour;
uniform float strength;
varying vec3 v_normal;
varying vec3 v_view;
varying vec2 v_edge;
void main() {
  vec3 view = normalize(v_view);
  vec3 normal = normalize(v_normal);
  float facing = abs(dot(normal, view));
  vec3 sun = normalize((viewMatrix * vec4(0.45, 0.8, 0.35, 0.0)).xyz);
  float light = dot(normal, sun);
  float glint = pow(max(0.0, dot(reflect(-sun, normal), view)), 24.0);
  float edge = 1.0 - smoothstep(0.9, 1.0, max(v_edge.x, v_edge.y));
  float alpha = strength * (0.55 + 0.9 * pow(1.0 - facing, 2.0));
  // From the side, crest stands behind crest: each may hide little.
  if (isOrthographic) alpha *= mix(0.3, 1.0, facing);
  gl_FragColor = vec4(colour * (0.25 + 0.95 * light) + 0.5 * glint, (alpha + 0.35 * glint) * edge);
  #include <colorspace_fragment>
}`;

export class Sea implements Part {
  readonly object = new Group();
  private mesh: Mesh<PlaneGeometry, ShaderMaterial> | null = null;

  constructor(private readonly scene: Scene) {}

  restyle(colours: Now['colours'], extent: Extent): void {
    this.mesh?.geometry.dispose();
    this.mesh?.material.dispose();
    this.object.clear();
    this.mesh = null;
    if (!extent.surface) return;
    const { min, max } = extent.frame;
    const side = Math.max(max.x - min.x, max.z - min.z);
    const size = [max.x - min.x + 0.16 * side, max.z - min.z + 0.16 * side] as const;
    const waves = this.visible_waves(Math.max(...size) / most_cells);
    const waves_along = (Math.max(0, ...waves.map((w) => w.number_radpm)) * Math.max(...size)) / (2 * Math.PI);
    const many = waves.length > 0 ? Math.ceil(Math.min(most_cells, Math.max(32, cells_per_wave * waves_along))) : 1;
    this.mesh = new Mesh(new PlaneGeometry(size[0], size[1], many, many).rotateX(-Math.PI / 2), this.material(waves, colours, extent));
    this.mesh.position.set((min.x + max.x) / 2, 0, (min.z + max.z) / 2);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order.surface;
    this.object.add(this.mesh);
  }

  /** Those that the mesh can carry without aliases. */
  private visible_waves(cell: number): Wave[] {
    const short = (2 * Math.PI) / (3 * cell);
    return this.scene.waves.filter((w) => w.number_radpm < short).sort((a, b) => b.amplitude_m - a.amplitude_m).slice(0, most_waves);
  }

  private material(waves: Wave[], colours: Now['colours'], extent: Extent): ShaderMaterial {
    const drawn = waves.length > 0 ? waves : [{ amplitude_m: 0, frequency_radps: 0, number_radpm: 0, phase_rad: 0, direction: [1, 0] as const }];
    return new ShaderMaterial({
      vertexShader: vertex, fragmentShader: fragment, transparent: true, depthWrite: false, side: DoubleSide,
      defines: { WAVES: drawn.length },
      uniforms: {
        waves: { value: drawn.map((w) => new Vector4(w.amplitude_m, w.number_radpm * w.direction[0], w.number_radpm * w.direction[1], w.frequency_radps)) },
        phases: { value: drawn.map((w) => w.phase_rad) },
        time: { value: 0 },
        colour: { value: colours.water },
        strength: { value: extent.afloat ? 0.4 : waves.length > 0 ? 0.2 : 0.14 },
      },
    });
  }

  show(now: Now): void {
    if (this.mesh) this.mesh.material.uniforms['time']!.value = now.moment.time;
  }
}
