import { DataTexture, LinearFilter, SRGBColorSpace } from 'three';

/**
 * Colors from small to large values. Their lightness grows or falls all the way, so that they can be told
 * apart by readers who see colors differently, and in print.
 * @type {Record<string, {label: string, stops: string[]}>}
 */
export const COLOR_MAPS = {
  lagoon: { label: 'Lagoon', stops: ['#12284c', '#1b4a72', '#23708a', '#3c9793', '#74b893', '#b3d3a0', '#eeeac0'] },
  ember: { label: 'Ember', stops: ['#fdf3d8', '#fbcf8e', '#f59f5b', '#e0684a', '#b63c52', '#7c2557', '#3d1a4d'] },
  viridis: { label: 'Viridis', stops: ['#440154', '#46327e', '#365c8d', '#277f8e', '#1fa187', '#4ac16d', '#a0da39', '#fde725'] },
  gray: { label: 'Gray', stops: ['#3a3f45', '#6d737a', '#a3a8ad', '#e4e6e8'] },
};

/** Colors of errors: none is nearly white. */
export const ERROR_MAP = { label: 'Error', stops: ['#f4f1e8', '#f3cfa6', '#ec9a6f', '#d35f55', '#9c2f55', '#571a47'] };

/** Colors of cells, in turn. */
export const CELL_COLORS = ['#6fa8c7', '#e3b565', '#8dbb8a', '#d68a7c', '#a797c9', '#c9c06c', '#79bdb4', '#d39ab8'];

/**
 * A color of a map, as CSS writes it.
 * @param {string[]} stops
 * @param {number} t from 0 to 1
 */
export function colorAt(stops, t) {
  const x = Math.min(1, Math.max(0, t)) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(x));
  const [from, to] = [stops[i], stops[i + 1]].map(bytesOf);
  return `rgb(${from.map((c, k) => Math.round(c + (to[k] - c) * (x - i))).join(' ')})`;
}

/** @param {string[]} stops */
export function gradientOf(stops) {
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

/** @param {string[]} stops */
export function textureOf(stops) {
  const width = 256;
  const data = new Uint8Array(4 * width);
  for (let i = 0; i < width; ++i) {
    const [r, g, b] = /** @type {string[]} */ (colorAt(stops, i / (width - 1)).match(/\d+/g)).map(Number);
    data.set([r, g, b, 255], 4 * i);
  }
  const texture = new DataTexture(data, width, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** @param {string} color as #rrggbb */
function bytesOf(color) {
  return [1, 3, 5].map(i => parseInt(color.slice(i, i + 2), 16));
}
