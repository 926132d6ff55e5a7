// SPDX-License-Identifier: Apache-2.0
// Draws hundreds of solids in one draw call: one mesh holds all vertices, and the shader reads the pose of
// each solid from a texture.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  FloatType,
  Matrix4,
  Mesh,
  RGBAFormat,
} from "three";

const WIDTH = 1024; // texels per row, a multiple of the four texels of a pose

export class Batch extends Mesh {
  /** @param {any[]} parts of Solids @param {import("three").MeshLambertMaterial} material */
  constructor(parts, material) {
    const sum = (count) => parts.reduce((total, part) => total + count(part.geometry), 0);
    const points = sum((geometry) => geometry.attributes.position.count);
    const position = new Float32Array(3 * points);
    const normal = new Float32Array(3 * points);
    const colour = new Uint8Array(3 * points);
    const member = new Float32Array(points);
    const index = new Uint32Array(sum((geometry) => geometry.index.count));
    const paint = new Color();
    let point = 0;
    let corner = 0;
    parts.forEach(({ geometry, colour: name }, k) => {
      const { array } = geometry.attributes.position;
      position.set(array, 3 * point);
      normal.set(geometry.attributes.normal.array, 3 * point);
      paint.set(name);
      const bytes = [paint.r, paint.g, paint.b].map((x) => Math.round(255 * x));
      for (let p = point; p < point + array.length / 3; p++) {
        member[p] = k;
        colour.set(bytes, 3 * p);
      }
      for (const each of geometry.index.array) index[corner++] = point + each;
      point += array.length / 3;
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(position, 3));
    geometry.setAttribute("normal", new BufferAttribute(normal, 3));
    geometry.setAttribute("color", new BufferAttribute(colour, 3, true));
    geometry.setAttribute("member", new BufferAttribute(member, 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    super(geometry, material);
    this.parts = parts;
    this.first = [];
    parts.reduce((at, { geometry: { attributes } }) => (this.first.push(at), at + attributes.position.array.length), 0);
    const rows = Math.ceil((4 * parts.length) / WIDTH);
    this.places = new DataTexture(new Float32Array(4 * WIDTH * rows), WIDTH, rows, RGBAFormat, FloatType);
    // The solids move, so that a bounding sphere would have to be updated in every frame.
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
    material.vertexColors = true;
    this.#adapt(material);
  }

  /** Shader that reads the poses. @param {import("three").Material} material */
  #adapt(material) {
    material.onBeforeCompile = (shader) => {
      shader.uniforms.places = { value: this.places };
      shader.vertexShader = `attribute float member;
        uniform highp sampler2D places;
        mat4 placeOf() {
          int at = 4 * int(member + 0.5);
          ivec2 t = ivec2(at % ${WIDTH}, at / ${WIDTH});
          return mat4(texelFetch(places, t, 0), texelFetch(places, t + ivec2(1, 0), 0),
            texelFetch(places, t + ivec2(2, 0), 0), texelFetch(places, t + ivec2(3, 0), 0));
        }
        ${shader.vertexShader}`
        .replace(
          "#include <beginnormal_vertex>",
          "#include <beginnormal_vertex>\nobjectNormal = mat3(placeOf()) * objectNormal;",
        )
        .replace("#include <begin_vertex>", "vec3 transformed = (placeOf() * vec4(position, 1.0)).xyz;");
    };
    material.customProgramCacheKey = () => "batch";
  }

  /** Another material, with the poses of this batch. @param {import("three").Material} material */
  adapted(material) {
    this.others ??= new Map();
    if (!this.others.has(material)) {
      const own = material.clone();
      this.#adapt(own);
      this.others.set(material, own);
    }
    const own = this.others.get(material);
    own.clippingPlanes = material.clippingPlanes;
    return own;
  }

  /** @param {number} member @param {Matrix4} matrix */
  place(member, matrix) {
    this.places.image.data.set(matrix.elements, 16 * member);
    this.places.needsUpdate = true;
  }

  /** Copy the vertices of a deformed solid into the batch. @param {number} member */
  bend(member) {
    const { attributes } = this.parts[member].geometry;
    for (const name of ["position", "normal"]) {
      const { array } = attributes[name];
      const all = this.geometry.attributes[name];
      all.array.set(array, this.first[member]);
      all.addUpdateRange(this.first[member], array.length);
      all.needsUpdate = true;
    }
  }

  /**
   * Intersect each solid as if it were a separate mesh.
   * @param {import("three").Raycaster} ray
   * @param {any[]} hits
   */
  raycast(ray, hits) {
    this.parts.forEach((part, k) => {
      ONE.geometry = part.geometry;
      ONE.material = this.material;
      ONE.matrixWorld.fromArray(this.places.image.data, 16 * k).premultiply(this.matrixWorld);
      const found = [];
      ONE.raycast(ray, found);
      for (const hit of found) hits.push({ ...hit, object: this, member: k });
    });
  }
}

const ONE = new Mesh();
