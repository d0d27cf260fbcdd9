// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Renderer, camera, stereo pair, and what is under the pointer.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Pace } from "./pace.js";

const reach = 9; // pixels of the window in which an element is looked for; odd
/** the distance of the eyes, of the distance that the eye has from what it looks at. */
const eyes = 0.055;

export class Stage {
  /** \param parts  of the scene, each with `object` and `uniforms`, and `reduce(share)` if less of it can be drawn, all if without a share */
  constructor(canvas, data, parts) {
    this.canvas = canvas;
    this.parts = parts;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.fineness = Math.min(window.devicePixelRatio, 2); // pixels of the picture in a pixel of CSS
    this.renderer.info.autoReset = false;
    this.scene = new THREE.Scene();
    for (const part of parts) this.scene.add(part.object);
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.01, 100);
    this.camera.up.fromArray(data.up);
    this.home = { view: new THREE.Vector3().fromArray(data.view).normalize(), radius: data.radius || 1 };
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, { enableDamping: true, dampingFactor: 0.12, zoomToCursor: true, rotateSpeed: 0.9 });
    this.controls.addEventListener("change", () => {
      this.pace.move();
      this.draw();
    });
    this.pace = new Pace(() => this.draw());
    this.stereo = "off"; // or "parallel", "crossed"
    this.pickTarget = new THREE.WebGLRenderTarget(reach, reach);
    this.wanted = this.pending = false;
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
    this.reset();
  }

  /** back to where the picture begins: all in sight. */
  reset() {
    const { view, radius } = this.home;
    const aspect = Math.min(1, this.aspect());
    const distance = (1.02 * radius) / Math.sin(((this.camera.fov / 2) * Math.PI) / 180) / aspect;
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(view).multiplyScalar(-distance);
    this.controls.minDistance = 0.02 * radius;
    this.controls.maxDistance = 12 * distance;
    this.controls.update();
    this.draw();
  }

  aspect() {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement;
    return (this.stereo === "off" ? w : w / 2) / Math.max(1, h);
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement;
    this.renderer.setSize(w, h);
    this.draw();
  }

  setStereo(mode) {
    this.stereo = mode;
    this.draw();
  }

  /** a picture with the next frame, or with that after the one that is being drawn. */
  draw() {
    this.wanted = true;
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      const { reduced } = this.pace, start = performance.now();
      this.controls.enableDamping = !this.pace.slow; // it takes a number of frames, which would be seconds
      this.controls.update();
      this.render(reduced ? this.pace.share : undefined);
      this.whenDrawn(() => {
        this.pace.took(performance.now() - start, reduced);
        this.pending = false;
        if (this.wanted) this.draw();
      });
    });
  }

  atRest() {
    return !this.pace.moving && !this.pending;
  }

  /** calls back when the graphics processor has done what it was told: frames do not pile up where it is slow. */
  whenDrawn(then) {
    const gl = this.renderer.getContext();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED) return void setTimeout(look, 1);
      gl.deleteSync(fence);
      then();
    };
    setTimeout(look, 0);
  }

  /** what is seen of the canvas by which eye: rectangles in device pixels from the lower left. */
  views() {
    const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance / 500, distance - 3 * this.home.radius);
    this.camera.far = distance + 3 * this.home.radius;
    this.camera.aspect = this.aspect();
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    if (this.stereo === "off") return [{ camera: this.camera, x: 0, y: 0, width: size.x, height: size.y }];
    const pair = new THREE.StereoCamera();
    pair.aspect = 1;
    pair.eyeSep = eyes * distance;
    this.camera.focus = distance;
    pair.update(this.camera);
    const half = Math.floor(size.x / 2);
    const [left, right] = this.stereo === "crossed" ? [pair.cameraR, pair.cameraL] : [pair.cameraL, pair.cameraR];
    return [
      { camera: left, x: 0, y: 0, width: half, height: size.y },
      { camera: right, x: half, y: 0, width: half, height: size.y },
    ];
  }

  set(name, value) {
    for (const { uniforms } of this.parts) if (uniforms[name]) uniforms[name].value = value;
  }

  /** a picture now, without waiting for the next frame; with a share, of that many lines only, coarser, in coarser pixels. */
  render(share) {
    const { renderer } = this, ratio = share === undefined ? this.fineness : this.fineness / 2;
    if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
    for (const part of this.parts) part.reduce?.(share);
    renderer.info.reset();
    renderer.setScissorTest(true);
    this.set("pixel", ratio);
    for (const view of this.views()) {
      this.set("viewport", new THREE.Vector2(view.width, view.height));
      const box = [view.x, view.y, view.width, view.height].map((n) => n / ratio);
      renderer.setViewport(...box);
      renderer.setScissor(...box);
      renderer.render(this.scene, view.camera);
    }
  }

  /** \return {kind: "cell" | "edge" | "vertex", id} of what is at a place of the canvas, in CSS pixels; null if nothing is */
  pick(x, y) {
    const { renderer } = this, ratio = renderer.getPixelRatio();
    const height = renderer.getDrawingBufferSize(new THREE.Vector2()).y;
    const px = x * ratio, py = height - y * ratio;
    const view = this.views().find((v) => px >= v.x && px < v.x + v.width && py >= v.y && py < v.y + v.height);
    if (!view) return null;
    // the window of `reach` × `reach` pixels around the place becomes the whole picture
    const sx = view.width / reach, sy = view.height / reach;
    const nx = (2 * (px - view.x)) / view.width - 1, ny = (2 * (py - view.y)) / view.height - 1;
    const eye = new THREE.Camera();
    eye.matrixAutoUpdate = eye.matrixWorldAutoUpdate = false;
    eye.matrixWorld.copy(view.camera.matrixWorld);
    eye.matrixWorldInverse.copy(view.camera.matrixWorld).invert();
    eye.projectionMatrix
      .set(sx, 0, 0, -sx * nx, 0, sy, 0, -sy * ny, 0, 0, 1, 0, 0, 0, 0, 1)
      .multiply(view.camera.projectionMatrix);
    eye.projectionMatrixInverse.copy(eye.projectionMatrix).invert();
    for (const part of this.parts) part.reduce?.();
    this.set("viewport", new THREE.Vector2(reach, reach));
    this.set("picking", true);
    renderer.setScissorTest(false);
    renderer.setRenderTarget(this.pickTarget);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.render(this.scene, eye);
    const pixels = new Uint8Array(4 * reach * reach);
    renderer.readRenderTargetPixels(this.pickTarget, 0, 0, reach, reach, pixels);
    renderer.setRenderTarget(null);
    this.set("picking", false);
    // a vertex before an edge before a cell; of the same kind the nearest to the pointer. Cells count at the pointer only.
    let best = null, least = Infinity;
    const middle = (reach - 1) / 2;
    for (let i = 0; i < reach * reach; ++i) {
      const kind = pixels[4 * i + 3];
      const d = Math.hypot((i % reach) - middle, Math.floor(i / reach) - middle);
      if (kind === 0 || (kind === 1 && d > 0)) continue;
      const order = d + 100 * (3 - kind);
      if (order < least) {
        least = order;
        best = { kind: ["cell", "edge", "vertex"][kind - 1], id: pixels[4 * i] | (pixels[4 * i + 1] << 8) | (pixels[4 * i + 2] << 16) };
      }
    }
    return best;
  }

  /** where a point is seen, in CSS pixels of the canvas, by the first eye. */
  project(point) {
    const ratio = this.renderer.getPixelRatio(), [view] = this.views();
    const p = new THREE.Vector3().fromArray(point).project(view.camera);
    const height = this.renderer.getDrawingBufferSize(new THREE.Vector2()).y;
    return [(view.x + (view.width * (p.x + 1)) / 2) / ratio, (height - (view.y + (view.height * (p.y + 1)) / 2)) / ratio];
  }
}
