// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The map's picture: its shades tell occupied (0), unknown (128), free (255); the theme colours it.

class MapImage {
  /** `map` as map_report_json has it, or null where nothing is known. */
  constructor(map, onChange) {
    this.map = map;
    this.canvas = null;
    this.isReady = map === null;
    if (!map) return;
    this.picture = new Image();
    this.picture.onload = () => {
      this.isReady = true;
      onChange();
    };
    this.picture.src = "data:image/png;base64," + map.png;
    kDark.addEventListener("change", () => (this.canvas = null));
  }

  /** The picture in the theme's colours, made once. */
  toned() {
    const canvas = document.createElement("canvas");
    canvas.width = this.picture.naturalWidth;
    canvas.height = this.picture.naturalHeight;
    const context = canvas.getContext("2d");
    context.drawImage(this.picture, 0, 0);
    const pixels = context.getImageData(0, 0, canvas.width, canvas.height);
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
    const words = new Uint32Array(pixels.data.buffer);
    for (let k = 0; k < words.length; ++k) words[k] = tones[pixels.data[4 * k]];
    context.putImageData(pixels, 0, 0);
    return canvas;
  }

  draw(context, view) {
    if (!this.map || !this.isReady) return;
    this.canvas = this.canvas || this.toned();
    const { left, bottom, pixel } = this.map;
    context.imageSmoothingEnabled = pixel * view.scale < 2;
    context.imageSmoothingQuality = "high";
    context.drawImage(this.canvas, view.column(left), view.row(bottom + this.canvas.height * pixel),
                      this.canvas.width * pixel * view.scale, this.canvas.height * pixel * view.scale);
  }
}
