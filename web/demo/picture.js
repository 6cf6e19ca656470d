// Draws two bodies and what is between them, by WebGL 2.

const BODY_VERTEX = `#version 300 es
uniform mat4 matrix;
in vec3 corner;
out vec3 seen;
void main() {
  gl_Position = matrix * vec4(corner, 1.0);
  seen = gl_Position.xyw;
}`;

// The normal is that of the triangle on the screen: meshes need none of their own.
const BODY_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 color;
in vec3 seen;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  pixel = vec4(color * (0.35 + 0.65 * abs(dot(normal, normalize(vec3(0.3, 0.5, 0.8))))), 1.0);
}`;

// One segment an instance, as a strip of two triangles, so many pixels wide.
const LINE_VERTEX = `#version 300 es
uniform mat4 matrix;
uniform vec2 size;
uniform float width;
in vec3 from;
in vec3 to;
void main() {
  vec4 a = matrix * vec4(from, 1.0);
  vec4 b = matrix * vec4(to, 1.0);
  vec2 way = (b.xy / b.w - a.xy / a.w) * size;
  vec2 along = length(way) > 1e-6 ? normalize(way) : vec2(1.0, 0.0);
  bool first = (gl_VertexID & 1) == 0;
  vec2 off = vec2(-along.y, along.x) * ((gl_VertexID & 2) == 0 ? 1.0 : -1.0) + (first ? -along : along);
  gl_Position = first ? a : b;
  gl_Position.xy += off * width / size * gl_Position.w;
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 color;
out vec4 pixel;
void main() { pixel = color; }`;

const STILL = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

export class Picture {
  #gl;
  #bodies = new Map();
  #colors = {};

  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext('webgl2', { antialias: true });
    if (gl === null) {
      throw new Error('This browser draws no WebGL 2, which this page needs.');
    }
    this.#gl = gl;
    this.solid = this.#program(BODY_VERTEX, BODY_FRAGMENT, ['corner']);
    this.lines = this.#program(LINE_VERTEX, LINE_FRAGMENT, ['from', 'to']);
    this.ends = { buffer: gl.createBuffer(), array: gl.createVertexArray(), count: 0 };
    gl.bindVertexArray(this.ends.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ends.buffer);
    for (const place of [0, 1]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 12 * place);
      gl.vertexAttribDivisor(place, 1);
    }
  }

  #program(vertex, fragment, inputs) {
    const gl = this.#gl;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    inputs.forEach((name, place) => gl.bindAttribLocation(program, place, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      throw new Error(gl.getProgramInfoLog(program));
    }
    return { program, at: (name) => gl.getUniformLocation(program, name) };
  }

  /** Colors by what they are for: sky, rim, contact, gap, and the names of bodies; three numbers to 1 each. */
  paint(colors) {
    this.#colors = colors;
  }

  /** Takes a body's triangles. They are kept about `center`: floats are finest there. */
  put(name, { vertices, triangles }, center) {
    const gl = this.#gl;
    const old = this.#bodies.get(name);
    if (old) {
      gl.deleteBuffer(old.corners);
      gl.deleteBuffer(old.indices);
      gl.deleteVertexArray(old.array);
    }
    const body = { array: gl.createVertexArray(), corners: gl.createBuffer(), indices: gl.createBuffer(),
                   count: triangles.length, center };
    gl.bindVertexArray(body.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, body.corners);
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(vertices, (x, k) => x - center[k % 3]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, body.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    this.#bodies.set(name, body);
  }

  /** Segments to draw: 6 numbers each, in the world; `color` is the name of one. */
  putSegments(ends, color) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ends.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, ends, gl.DYNAMIC_DRAW);
    Object.assign(this.ends, { count: ends.length / 6, color });
  }

  /** What was drawn just now: its width, its height, and four bytes a pixel, the lowest row first. */
  pixels() {
    const { width, height } = this.canvas;
    const bytes = new Uint8Array(4 * width * height);
    this.#gl.readPixels(0, 0, width, height, this.#gl.RGBA, this.#gl.UNSIGNED_BYTE, bytes);
    return { width, height, bytes };
  }

  aspect() {
    return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
  }

  /** `poses`: by the name of the body; who is not there stands still. */
  draw(camera, poses) {
    const gl = this.#gl;
    const { canvas, ends } = this;
    const sharp = Math.min(2, window.devicePixelRatio);
    const [width, height] = [canvas.clientWidth * sharp | 0, canvas.clientHeight * sharp | 0];
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
    }
    gl.viewport(0, 0, width, height);
    gl.clearColor(...this.#colors.sky, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.POLYGON_OFFSET_FILL);  // lines on a surface lie before it
    gl.polygonOffset(4, 16);
    gl.useProgram(this.solid.program);
    for (const [name, body] of this.#bodies) {
      gl.uniformMatrix4fv(this.solid.at('matrix'), false, camera.matrix(poses[name] ?? STILL, body.center, this.aspect()));
      gl.uniform3fv(this.solid.at('color'), this.#colors[name]);
      gl.bindVertexArray(body.array);
      gl.drawElements(gl.TRIANGLES, body.count, gl.UNSIGNED_INT, 0);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (ends.count > 0) {
      gl.useProgram(this.lines.program);
      gl.uniformMatrix4fv(this.lines.at('matrix'), false, camera.matrix(STILL, [0, 0, 0], this.aspect()));
      gl.uniform2f(this.lines.at('size'), width, height);
      gl.bindVertexArray(ends.array);
      gl.depthMask(false);
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthFunc(gl.GREATER);  // pale where surfaces hide it
      this.#lines(ends, sharp, 0.35, 2.5);
      gl.depthFunc(gl.LEQUAL);
      this.#lines({ ...ends, color: 'rim' }, sharp, 1, 6);
      this.#lines(ends, sharp, 1, 3.5);
      gl.disable(gl.BLEND);
      gl.depthMask(true);
      gl.depthFunc(gl.LESS);
    }
  }

  #lines({ count, color }, sharp, opaque, width) {
    const gl = this.#gl;
    gl.uniform1f(this.lines.at('width'), width * sharp);
    gl.uniform4f(this.lines.at('color'), ...this.#colors[color], opaque);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }
}
