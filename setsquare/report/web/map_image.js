// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The map's picture: its shades mean occupied (0), unknown (128), free (255); the theme colours it.

/** Half as wide and high. A wall stays a wall however small the map is drawn: of four shades the
    darkest counts where one is occupied, else their mean. */
function halved({ width, height, shades }) {
  const half = { width: Math.ceil(width / 2), height: Math.ceil(height / 2) };
  half.shades = new Uint8Array(half.width * half.height);
  for (let row = 0; row < half.height; ++row) {
    // An odd number of rows or columns: the last counts twice.
    const upper = 2 * row * width;
    const lower = Math.min(2 * row + 1, height - 1) * width;
    for (let column = 0; column < half.width; ++column) {
      const left = 2 * column;
      const right = Math.min(left + 1, width - 1);
      const a = shades[upper + left];
      const b = shades[upper + right];
      const c = shades[lower + left];
      const d = shades[lower + right];
      const darkest = Math.min(a, b, c, d);
      half.shades[row * half.width + column] = darkest < 128 ? darkest : (a + b + c + d + 2) >> 2;
    }
  }
  return half;
}

class MapImage {
  /** `map` as map_report_json has it, or null where nothing is known. */
  constructor(map, onChange) {
    this.map = map;
    this.isReady = map === null;
    if (!map) return;
    const picture = new Image();
    picture.onload = () => {
      this.levels = [this.shadesOf(picture)];  // Each half the one before; made when needed.
      this.isReady = true;
      onChange();
    };
    picture.src = "data:image/png;base64," + map.png;
    kDark.addEventListener("change", () => this.levels?.forEach((level) => delete level.canvas));
  }

  shadesOf(picture) {
    const canvas = document.createElement("canvas");
    const width = (canvas.width = picture.naturalWidth);
    const height = (canvas.height = picture.naturalHeight);
    const context = canvas.getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const shades = new Uint8Array(width * height);
    for (let k = 0; k < shades.length; ++k) shades[k] = data[4 * k];
    return { width, height, shades };
  }

  /** A level as a canvas in the theme's colours, made once. */
  toned(level) {
    if (level.canvas) return level.canvas;
    const [wall, unknown, free] = ["wall", "unknown", "free"].map((name) => channels(themeColor(name)));
    const tones = new Uint32Array(256);
    const bytes = new Uint8Array(tones.buffer);
    for (let shade = 0; shade < 256; ++shade) {
      const end = shade < 128 ? wall : free;
      const share = shade < 128 ? (128 - shade) / 128 : (shade - 128) / 127;
      for (let k = 0; k < 3; ++k) {
        bytes[4 * shade + k] = Math.round(unknown[k] + (end[k] - unknown[k]) * share);
      }
      bytes[4 * shade + 3] = 255;
    }
    const pixels = new ImageData(level.width, level.height);
    const words = new Uint32Array(pixels.data.buffer);
    for (let k = 0; k < words.length; ++k) words[k] = tones[level.shades[k]];
    level.canvas = document.createElement("canvas");
    level.canvas.width = level.width;
    level.canvas.height = level.height;
    level.canvas.getContext("2d").putImageData(pixels, 0, 0);
    return level.canvas;
  }

  draw(context, view) {
    if (!this.map || !this.isReady) return;
    const { left, bottom } = this.map;
    let pixel = this.map.pixel;
    let number = 0;
    for (; pixel * view.scale < 1; pixel *= 2) {
      ++number;
      if (!this.levels[number]) this.levels[number] = halved(this.levels[number - 1]);
    }
    const canvas = this.toned(this.levels[number]);
    // Rows are halved from the top, so the top is what all levels share.
    const top = bottom + this.levels[0].height * this.map.pixel;
    context.imageSmoothingEnabled = pixel * view.scale < 2;
    context.imageSmoothingQuality = "high";
    context.drawImage(canvas, view.column(left), view.row(top), canvas.width * pixel * view.scale,
                      canvas.height * pixel * view.scale);
  }
}
