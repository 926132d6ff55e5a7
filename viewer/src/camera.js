// SPDX-License-Identifier: Apache-2.0
// Camera with central or parallel projection. Both show the same size at the target of the camera.
import { PerspectiveCamera } from "three";

export class Camera extends PerspectiveCamera {
  /** Distance of the target, which determines the size in parallel projection [m]. */
  distance = 1;

  get parallel() {
    return this.isPerspectiveCamera === false;
  }

  /** @param {boolean} on */
  set parallel(on) {
    this.isPerspectiveCamera = !on;
    this.isOrthographicCamera = on;
    this.updateProjectionMatrix();
  }

  updateProjectionMatrix() {
    if (!this.parallel) {
      super.updateProjectionMatrix();
      return;
    }
    let top = (this.distance * Math.tan((this.fov * Math.PI) / 360)) / this.zoom;
    let height = 2 * top;
    let width = this.aspect * height;
    let left = -width / 2;
    const { view } = this;
    if (view?.enabled) {
      left += (view.offsetX * width) / view.fullWidth;
      top -= (view.offsetY * height) / view.fullHeight;
      width *= view.width / view.fullWidth;
      height *= view.height / view.fullHeight;
    }
    this.projectionMatrix.makeOrthographic(
      left,
      left + width,
      top,
      top - height,
      this.near,
      this.far,
      this.coordinateSystem,
      this.reversedDepth,
    );
    this.projectionMatrixInverse.copy(this.projectionMatrix).invert();
  }
}
