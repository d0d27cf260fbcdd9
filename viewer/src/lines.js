// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All lines: one instanced geometry, a quadrilateral per segment that the shader makes as wide as it should be on the
// screen. Which types are seen, from which strength on, is decided by the shader too: nothing is copied when that changes.
// The strongest come first, so that less is drawn by drawing fewer.
import * as THREE from "three";

const vertexShader = `
  attribute vec3 from;
  attribute vec3 to;
  attribute vec3 up;       // normal of the surface
  attribute float type;
  attribute float edge;
  attribute float strength;
  attribute float lastLevel; // of the simplification at which a line is here
  uniform vec2 viewport;   // pixels
  uniform float pixel;     // device pixels in a pixel
  uniform vec4 visible;    // by type
  uniform float leastStrength;
  uniform float level;
  uniform float picked;
  uniform bool picking;
  uniform float scale;
  uniform float lift;      // towards the eye
  uniform vec3 colours[4];
  varying vec3 vColour;
  varying vec2 vAt;        // along and across, in half widths
  varying float vLength;
  varying float vId;
  varying float vFacing;
  void main() {
    int t = int(type + 0.5);
    vec4 a = modelViewMatrix * vec4(from, 1.0), b = modelViewMatrix * vec4(to, 1.0);
    bool isPicked = abs(edge - picked) < 0.5;
    vId = edge;
    vColour = colours[t];
    vFacing = dot(normalMatrix * up, -a.xyz);
    vec4 ca = projectionMatrix * a, cb = projectionMatrix * b;
    if ((visible[t] < 0.5 || strength < leastStrength || lastLevel < level) && !isPicked || ca.w <= 0.0 || cb.w <= 0.0) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    float half_width = 0.5 * pixel * scale * (t == 0 ? 3.4 : t == 1 ? 2.6 : 2.1);
    if (isPicked) half_width *= 2.0;
    if (picking) half_width = max(half_width, 2.5 * pixel);
    vec2 sa = ca.xy / ca.w * viewport * 0.5, sb = cb.xy / cb.w * viewport * 0.5;
    float len = distance(sa, sb);
    vec2 along = len > 1e-6 ? (sb - sa) / len : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float side = position.x; // -1 at from, 1 at to
    vec2 offset = half_width * (side * along + position.y * across);
    vLength = len / half_width;
    vAt = vec2(side < 0.0 ? -1.0 : vLength + 1.0, position.y);
    vec4 at = side < 0.0 ? ca : cb;
    at.xy += offset / viewport * 2.0 * at.w;
    at.z -= (isPicked ? 2.0 : 1.0) * lift * at.w; // in front of the surface that it lies on
    gl_Position = at;
  }`;

const fragmentShader = `
  uniform bool picking;
  uniform bool fade;       // what is on the far side, if no surface hides it
  varying vec3 vColour;
  varying vec2 vAt;
  varying float vLength;
  varying float vId;
  varying float vFacing;
  void main() {
    float d = length(vec2(vAt.x - clamp(vAt.x, 0.0, vLength), vAt.y));
    if (d > 1.0) discard;
    if (picking) {
      int id = int(vId + 0.5);
      gl_FragColor = vec4(vec3(id & 255, (id >> 8) & 255, id >> 16) / 255.0, 2.0 / 255.0);
      return;
    }
    vec3 colour = vColour * (1.0 - 0.28 * smoothstep(0.45, 1.0, d));
    if (fade && vFacing < 0.0) colour = mix(colour, vec3(0.93, 0.93, 0.92), 0.72);
    gl_FragColor = vec4(colour, 1.0);
  }`;

const lift = 0.0008; // of the depth

/** where the points and the segments of each edge begin, the strongest edge first. */
function strongestFirst(edges) {
  let point = 0, segment = 0;
  const order = Array.from(edges.points, (points, e) => {
    const at = { e, point, segment };
    point += points;
    segment += points - 1;
    return at;
  });
  return order.sort((a, b) => edges.strength[b.e] - edges.strength[a.e]);
}

/** makes the lines. `segments` counts those that are seen. */
export function makeLines({ lines, edges, line_types, levels, closed }, hasSurface) {
  const count = lines.types.length;
  const from = new Float32Array(3 * count), to = new Float32Array(3 * count), up = new Int16Array(3 * count);
  const type = new Float32Array(count), edge = new Float32Array(count), strength = new Float32Array(count);
  const lastLevel = new Float32Array(count);
  let s = 0;
  for (const { e, point, segment } of strongestFirst(edges)) {
    for (let i = 0; i + 1 < edges.points[e]; ++i, ++s) {
      const p = 3 * (point + i);
      from.set(lines.points.subarray(p, p + 3), 3 * s);
      to.set(lines.points.subarray(p + 3, p + 6), 3 * s);
      up.set(lines.normals.subarray(p, p + 3), 3 * s);
      type[s] = lines.types[segment + i];
      edge[s] = e;
      strength[s] = edges.strength[e];
      if (levels) lastLevel[s] = levels.of_segment[segment + i];
    }
  }
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const add = (name, array, size, normalized = false) =>
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(array, size, normalized));
  add("from", from, 3);
  add("to", to, 3);
  add("up", up, 3, true);
  add("type", type, 1);
  add("edge", edge, 1);
  add("strength", strength, 1);
  add("lastLevel", lastLevel, 1);
  geometry.instanceCount = count;
  const material = new THREE.ShaderMaterial({
    vertexShader, fragmentShader, side: THREE.DoubleSide,
    uniforms: {
      viewport: { value: new THREE.Vector2() }, pixel: { value: 1 }, visible: { value: new THREE.Vector4(1, 1, 1, 1) },
      leastStrength: { value: 0 }, level: { value: 0 }, picked: { value: -1 }, picking: { value: false }, fade: { value: closed && !hasSurface },
      scale: { value: count > 40000 ? 0.75 : 1 }, lift: { value: lift },
      colours: { value: line_types.map((type) => new THREE.Vector3(...type.colour.map((c) => c / 255))) },
    },
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return {
    object: mesh,
    uniforms: material.uniforms,
    /** draws this share only, the strongest, and above the chords of a coarser surface; all if there is no share. */
    reduce(share) {
      geometry.instanceCount = Math.ceil((share ?? 1) * count);
      material.uniforms.lift.value = share === undefined ? lift : 4 * lift;
    },
    drawn: () => geometry.instanceCount,
    segments() {
      const visible = material.uniforms.visible.value.toArray(), least = material.uniforms.leastStrength.value;
      const level = material.uniforms.level.value;
      let seen = 0;
      for (let i = 0; i < count; ++i) seen += visible[type[i]] > 0 && strength[i] >= least && lastLevel[i] >= level;
      return seen;
    },
  };
}
