// SPDX-License-Identifier: Apache-2.0
// The hulls: two draw calls for all vehicles that look alike, and marks that keep them findable from afar.
import { DynamicDrawUsage, Group, InstancedMesh, Matrix4, MeshLambertMaterial, Vector3 } from 'three';
import type { Scene } from '../../model';
import { hull_key, hull_of } from '../hulls/hull';
import { Dots } from '../ink/dots';
import { order, type Now, type Part } from '../part';

interface Fleet {
  vehicles: number[];
  meshes: InstancedMesh[];
  accent: InstancedMesh;
}

const matrix = new Matrix4();
const unscaled = new Vector3(1, 1, 1);

export class Vehicles implements Part {
  readonly object = new Group();
  hovered: number | null = null;
  private readonly fleets: Fleet[];
  private readonly marks = new Dots(order.dots, true);

  constructor(private readonly scene: Scene) {
    const alike = new Map<string, number[]>();
    scene.vehicles.forEach((spec, v) => {
      const key = hull_key(spec);
      alike.set(key, [...(alike.get(key) ?? []), v]);
    });
    const painted = new MeshLambertMaterial({ vertexColors: true });
    const accent = new MeshLambertMaterial();
    this.fleets = [...alike.values()].map((vehicles) => {
      const hull = hull_of(scene.vehicles[vehicles[0]!]!);
      const meshes = [new InstancedMesh(hull.painted, painted, vehicles.length), new InstancedMesh(hull.accent, accent, vehicles.length)];
      for (const mesh of meshes) {
        mesh.frustumCulled = false;
        mesh.instanceMatrix.setUsage(DynamicDrawUsage);
        this.object.add(mesh);
      }
      return { vehicles, meshes, accent: meshes[1]! };
    });
    this.object.add(this.marks.object);
  }

  restyle(colours: Now['colours']): void {
    for (const { vehicles, accent } of this.fleets) {
      vehicles.forEach((v, k) => accent.setColorAt(k, colours.vehicle(v)));
      accent.instanceColor!.needsUpdate = true;
    }
  }

  show(now: Now): void {
    for (const { vehicles, meshes } of this.fleets) {
      for (const mesh of meshes) {
        vehicles.forEach((v, k) => mesh.setMatrixAt(k, matrix.compose(now.poses.positions[v]!, now.poses.attitudes[v]!, unscaled)));
        mesh.instanceMatrix.needsUpdate = true;
      }
    }
    this.mark(now);
  }

  private mark(now: Now): void {
    const { ink } = now.colours;
    this.marks.clear();
    this.scene.vehicles.forEach((spec, v) => {
      const at = now.poses.positions[v]!;
      const colour = now.colours.vehicle(v);
      const chosen = now.chosen.has(v);
      this.marks.add(at, 'disc', 8, colour, now.chosen.size > 0 && !chosen ? 0.6 : 1, spec.length_m, 13);
      if (chosen || this.hovered === v) this.marks.add(at, 'ring', chosen ? 30 : 26, chosen ? ink : colour, chosen ? 0.9 : 0.7, spec.length_m, 60);
    });
    this.marks.commit();
  }
}
