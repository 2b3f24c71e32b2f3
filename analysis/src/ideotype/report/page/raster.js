// SPDX-License-Identifier: Apache-2.0
// Triangles on a canvas with a depth buffer: each pixel shows the nearest one.
// It needs no graphics driver and works wherever the page opens.
class Raster {
  constructor(width, height) {
    [this.width, this.height] = [width, height];
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.depth = new Float32Array(width * height);
  }

  clear() {
    this.pixels.fill(0xffffffff);
    this.depth.fill(Infinity);
  }

  // Corners are [x, y, depth] in pixels, moved by `shift`; only columns from
  // the first of two up to the second are painted. A small depth is near.
  fill(corners, shift, color, columns) {
    const [r, g, b] = color;
    // little-endian, as all machines with browsers are
    const paint = 0xff000000 | (b << 16) | (g << 8) | r;
    const moved = corners.map((corner) => [
      corner[0] + shift[0], corner[1] + shift[1], corner[2] + shift[2]]);
    for (let i = 2; i < moved.length; ++i)
      this.triangle(moved[0], moved[i - 1], moved[i], paint, columns);
  }

  triangle(a, b, c, paint, [left, right]) {
    const bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
    const cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
    const area = bx * cy - cx * by;
    if (Math.abs(area) < 1e-9) return;
    // how depth grows from pixel to pixel
    const across = (bz * cy - cz * by) / area;
    const down = (cz * bx - bz * cx) / area;
    const low = Math.min(a[1], b[1], c[1]);
    const high = Math.max(a[1], b[1], c[1]);
    const first = Math.max(0, Math.ceil(low - 0.5));
    const last = Math.min(this.height - 1, Math.ceil(high - 0.5) - 1);
    for (let row = first; row <= last; ++row) {
      const y = row + 0.5;
      // two of the edges meet the row
      const ab = meet(a, b, y), bc = meet(b, c, y), ca = meet(c, a, y);
      const from = Math.min(ab, bc, ca);
      const to = Math.max(
        ab === Infinity ? from : ab, bc === Infinity ? from : bc,
        ca === Infinity ? from : ca);
      const start = Math.max(left, Math.ceil(from - 0.5));
      const end = Math.min(right, Math.ceil(to - 0.5));
      let depth = a[2] + across * (start + 0.5 - a[0]) + down * (y - a[1]);
      const begin = row * this.width;
      for (let i = begin + start; i < begin + end; ++i, depth += across) {
        if (depth >= this.depth[i]) continue;
        this.depth[i] = depth;
        this.pixels[i] = paint;
      }
    }
  }
}

// Where an edge crosses a height; Infinity if it does not.
function meet(p, q, y) {
  if (p[1] <= y === q[1] <= y) return Infinity;
  return p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
}
