// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vertices: sprites of a shape per class, so that they can be told apart without colours.
import * as THREE from "three";

const vertexShader = `
  attribute float kind;
  attribute float vertex;
  attribute float lastLevel; // of the simplification at which it is there
  uniform float visible[16];
  uniform vec3 colours[16];
  uniform float level;
  uniform float picked;
  uniform float pixel;
  uniform float scale;
  uniform bool closed;
  varying vec3 vColour;
  varying float vKind;
  varying float vId;
  varying float vPicked;
  void main() {
    int k = int(kind + 0.5);
    vec4 p = modelViewMatrix * vec4(position, 1.0);
    bool isPicked = abs(vertex - picked) < 0.5;
    vColour = colours[k];
    vKind = kind;
    vId = vertex;
    vPicked = isPicked ? 1.0 : 0.0;
    bool hidden = (visible[k] < 0.5 || lastLevel < level) && !isPicked;
    if (hidden || closed && dot(normalMatrix * normal, -p.xyz) < 0.0) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      gl_PointSize = 1.0;
      return;
    }
    gl_Position = projectionMatrix * p;
    gl_Position.z -= 0.002 * gl_Position.w;
    gl_PointSize = pixel * scale * (k == 0 || k >= 6 ? 9.0 : 14.0) * (isPicked ? 1.8 : 1.0);
  }`;

const fragmentShader = `
  uniform bool picking;
  varying vec3 vColour;
  varying float vKind;
  varying float vId;
  varying float vPicked;
  // less than 1 within: a disk, a drop, a triangle, a star with three points, a square
  float shape(vec2 p, int kind) {
    float angle = atan(p.x, p.y), r = length(p);
    const float third = 2.0943951;
    if (kind == 1) return max(r * 1.15, 0.0) + 0.30 * max(0.0, -p.y) * abs(p.x);
    float a = mod(angle + third / 2.0, third) - third / 2.0;
    if (kind == 2) return 1.75 * r * cos(mod(angle, third) - third / 2.0);
    if (kind == 3) return r / (0.36 + 0.64 * pow(max(0.0, 1.0 - abs(a) / (third / 2.0)), 1.4));
    if (kind == 5) return 1.25 * max(abs(p.x), abs(p.y));
    return r * 1.05;
  }
  void main() {
    vec2 p = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
    int kind = int(vKind + 0.5);
    float d = shape(p, kind);
    if (d > 1.0) discard;
    if (picking) {
      int id = int(vId + 0.5);
      gl_FragColor = vec4(vec3(id & 255, (id >> 8) & 255, id >> 16) / 255.0, 3.0 / 255.0);
      return;
    }
    vec3 colour = d > 0.74 ? (vPicked > 0.5 ? vec3(1.0, 0.80, 0.22) : vec3(1.0)) : vColour;
    gl_FragColor = vec4(colour, 1.0);
  }`;

/** the vertices, those at the strongest edges first. */
function strongestFirst({ vertices, edges }) {
  const strength = new Float32Array(vertices.class.length);
  edges.strength.forEach((s, e) => {
    for (const v of [edges.source[e], edges.target[e]]) strength[v] = Math.max(strength[v], s);
  });
  return Uint32Array.from(strength, (_, v) => v).sort((v, w) => strength[w] - strength[v] || v - w);
}

/** makes the vertices. `count` counts those that are not switched off. */
export function makePoints({ vertices, edges, vertex_classes, levels, closed, center }) {
  const order = strongestFirst({ vertices, edges }), count = order.length;
  const position = new Float32Array(3 * count), normal = new Int16Array(3 * count);
  order.forEach((v, i) => {
    position.set(vertices.point[v].map((x, a) => x - center[a]), 3 * i);
    normal.set(vertices.normals.subarray(3 * v, 3 * v + 3), 3 * i);
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3, true));
  const add = (name, value) => geometry.setAttribute(name, new THREE.BufferAttribute(Float32Array.from(order, value), 1));
  add("kind", (v) => vertices.class[v]);
  add("vertex", (v) => v);
  add("lastLevel", (v) => levels?.of_vertex[v] ?? 0);
  geometry.setDrawRange(0, count);
  const classes = Array.from({ length: 16 }, (_, k) => vertex_classes[k]);
  const material = new THREE.ShaderMaterial({
    vertexShader, fragmentShader,
    uniforms: {
      visible: { value: classes.map(() => 1) },
      colours: { value: classes.map((c) => new THREE.Vector3(...(c?.colour ?? [0, 0, 0]).map((x) => x / 255))) },
      level: { value: 0 }, picked: { value: -1 }, pixel: { value: 1 }, picking: { value: false },
      closed: { value: closed }, scale: { value: count > 1500 ? 0.72 : 1 },
    },
  });
  const object = new THREE.Points(geometry, material);
  object.frustumCulled = false;
  return {
    object,
    uniforms: material.uniforms,
    /** draws this share only, those at the strongest edges; all if there is no share. */
    reduce(share) {
      geometry.setDrawRange(0, Math.ceil((share ?? 1) * count));
    },
    drawn: () => geometry.drawRange.count,
    count() {
      const { visible, level } = material.uniforms, { kind, lastLevel } = geometry.attributes;
      let seen = 0;
      for (let i = 0; i < count; ++i) seen += visible.value[kind.array[i]] > 0 && lastLevel.array[i] >= level.value;
      return seen;
    },
  };
}
