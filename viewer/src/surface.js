// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface: one mesh. What colour a cell has stands in a texture with one texel per cell, so that cells are lit up
// without touching the mesh. A coarser one of the same points is there for where all of it would take too long.
import * as THREE from "three";

const width = 1024; // of the texture

/**
 * the mean curvature at each point, from how the normals of triangles' corners diverge, where 1 is 2.5 times its mean
 * over the surface.
 */
function meanCurvature({ points, normals, triangles }) {
  const sum = new Float64Array(points.length / 3), weight = new Float64Array(points.length / 3);
  const corner = [0, 1, 2].map(() => new THREE.Vector3());
  const normal = [0, 1, 2].map(() => new THREE.Vector3());
  const across = new THREE.Vector3(), a = new THREE.Vector3(), b = new THREE.Vector3();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let j = 0; j < 3; ++j) {
      corner[j].fromArray(points, 3 * triangles[t + j]);
      normal[j].fromArray(normals, 3 * triangles[t + j]).normalize();
    }
    across.crossVectors(a.subVectors(corner[1], corner[0]), b.subVectors(corner[2], corner[0]));
    const area = across.length(); // twice that of the triangle
    if (area === 0) continue;
    across.divideScalar(area);
    let divergence = 0; // × area: Σ n_j · (across × opposite edge)
    for (let j = 0; j < 3; ++j) {
      a.subVectors(corner[(j + 2) % 3], corner[(j + 1) % 3]);
      divergence += normal[j].dot(b.crossVectors(across, a));
    }
    for (let j = 0; j < 3; ++j) {
      sum[triangles[t + j]] += divergence / 2;
      weight[triangles[t + j]] += area;
    }
  }
  let bent = 0, area = 0;
  sum.forEach((s, i) => {
    bent += Math.abs(s);
    area += weight[i];
  });
  const usual = bent > 0 ? (2.5 * bent) / area : 1;
  return Float32Array.from(sum, (s, i) => (weight[i] > 0 ? s / weight[i] / usual : 0));
}

const vertexShader = `
  attribute float cell;
  attribute float curvature;
  flat varying float vCell; // a triangle of the coarser surface may have corners in several cells
  varying float vCurvature;
  varying vec3 vNormal;
  varying vec3 vEye;
  void main() {
    vec4 p = modelViewMatrix * vec4(position, 1.0);
    vCell = cell;
    vCurvature = curvature;
    vNormal = normalMatrix * normal;
    vEye = -p.xyz;
    gl_Position = projectionMatrix * p;
  }`;

const fragmentShader = `
  uniform highp sampler2D cells;
  uniform int tint; // 0: by cell, 1: by curvature, 2: plain
  uniform bool picking;
  flat varying float vCell;
  varying float vCurvature;
  varying vec3 vNormal;
  varying vec3 vEye;
  void main() {
    int id = int(vCell + 0.5);
    if (picking) {
      gl_FragColor = vec4(vec3(id & 255, (id >> 8) & 255, id >> 16) / 255.0, 1.0 / 255.0);
      return;
    }
    vec4 texel = texelFetch(cells, ivec2(id % ${width}, id / ${width}), 0);
    vec3 colour = texel.rgb;
    if (tint == 1) {
      float t = clamp(vCurvature, -1.0, 1.0);
      colour = t > 0.0 ? mix(vec3(0.95, 0.94, 0.92), vec3(0.80, 0.45, 0.30), t)
                       : mix(vec3(0.95, 0.94, 0.92), vec3(0.25, 0.50, 0.68), -t);
    } else if (tint == 2) {
      colour = vec3(0.90, 0.89, 0.86);
    }
    if (texel.a < 0.75) colour = mix(colour, vec3(1.0, 0.83, 0.25), 0.72); // lit up
    vec3 eye = normalize(vEye);
    vec3 n = normalize(vNormal);
    bool back = dot(n, eye) < 0.0;
    if (back) { n = -n; colour *= 0.72; }
    float key = max(0.0, dot(n, normalize(vec3(-0.45, 0.65, 0.75))));
    float fill = max(0.0, dot(n, normalize(vec3(0.7, -0.1, 0.55))));
    float head = max(0.0, dot(n, eye));
    float rim = pow(1.0 - head, 3.0);
    vec3 light = vec3(0.47, 0.48, 0.50) + key * vec3(0.45, 0.43, 0.40) + fill * vec3(0.12, 0.13, 0.16) + 0.14 * head;
    float gloss = pow(max(0.0, dot(n, normalize(eye + vec3(-0.45, 0.65, 0.75)))), 40.0);
    gl_FragColor = vec4(colour * light * (1.0 - 0.25 * rim) + 0.07 * gloss, 1.0);
  }`;

/**
 * the triangles of a coarser surface, of which there are about `wanted`: points that share a box of a lattice become the
 * first of them, and what is no triangle any more is left out. Null if there are not twice as many to begin with.
 */
function coarser({ points, triangles }, wanted) {
  if (triangles.length < 6 * wanted) return null;
  let area = 0;
  const corner = [0, 1, 2].map(() => new THREE.Vector3());
  for (let t = 0; t < triangles.length; t += 3) {
    for (let j = 0; j < 3; ++j) corner[j].fromArray(points, 3 * triangles[t + j]);
    area += corner[1].sub(corner[0]).cross(corner[2].sub(corner[0])).length() / 2;
  }
  const width = Math.sqrt((3 * area) / wanted) || 1; // a surface meets about 1.5 boxes per area of a face
  const first = new Map(), of = new Uint32Array(points.length / 3);
  for (let i = 0; i < of.length; ++i) {
    const [x, y, z] = [0, 1, 2].map((a) => Math.floor(points[3 * i + a] / width) + 0x8000);
    const box = (x * 0x10000 + y) * 0x10000 + z;
    if (!first.has(box)) first.set(box, i);
    of[i] = first.get(box);
  }
  const left = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((j) => of[triangles[t + j]]);
    if (a !== b && b !== c && c !== a) left.push(a, b, c);
  }
  return new Uint32Array(left);
}

/** makes the surface. `light(cells)` lights these cells up, and no others; `paint(colours)` gives each cell another colour. */
export function makeSurface({ surface, cells }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(surface.points, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(surface.normals, 3, true));
  geometry.setAttribute("cell", new THREE.BufferAttribute(Float32Array.from(surface.cells), 1));
  geometry.setAttribute("curvature", new THREE.BufferAttribute(meanCurvature(surface), 1));
  const whole = new THREE.BufferAttribute(surface.triangles, 1);
  const few = coarser(surface, 25000);
  const coarse = few && new THREE.BufferAttribute(few, 1);
  geometry.setIndex(whole);

  const count = cells.sign.length;
  const texels = new Uint8Array(4 * width * Math.max(1, Math.ceil(count / width)));
  for (let c = 0; c < count; ++c) {
    texels.set(cells.colours.subarray(3 * c, 3 * c + 3), 4 * c);
    texels[4 * c + 3] = 255;
  }
  const texture = new THREE.DataTexture(texels, width, texels.length / (4 * width));
  texture.needsUpdate = true;
  const material = new THREE.ShaderMaterial({
    vertexShader, fragmentShader, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    uniforms: { cells: { value: texture }, tint: { value: 0 }, picking: { value: false } },
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return {
    object: mesh,
    uniforms: material.uniforms,
    /** draws the coarser surface with a share of the lines; all if there is no share. */
    reduce(share) {
      geometry.setIndex(share !== undefined && coarse ? coarse : whole);
    },
    drawn: () => geometry.index.count / 3,
    paint(colours) {
      for (let c = 0; c < count; ++c) texels.set(colours.subarray(3 * c, 3 * c + 3), 4 * c);
      texture.needsUpdate = true;
    },
    light(lit) {
      for (let c = 0; c < count; ++c) texels[4 * c + 3] = 255;
      for (const c of lit) texels[4 * c + 3] = 128;
      texture.needsUpdate = true;
    },
  };
}
