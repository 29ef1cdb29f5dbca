import { Color, DoubleSide, ShaderMaterial } from 'three';
import { CELL_COLORS, COLOR_MAPS, textureOf } from './color_maps.js';

const VERTEX = /* glsl */ `
attribute float value; // a distance or an error; -1 where no source arrives
attribute float cell; // number of the nearest source
attribute float weight; // logarithm to base 2 of the cost per length
varying float vValue;
varying float vReached;
varying float vWeight;
varying vec3 vNormal;
flat varying float vCell;

void main() {
  vValue = value;
  vReached = value < 0.0 ? 0.0 : 1.0;
  vWeight = weight;
  vCell = cell;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = /* glsl */ `
uniform sampler2D colors;
uniform float largest; // value that has the last color
uniform float spacing; // of isolines; 0 for none
uniform bool showsCells;
uniform vec3 cellColors[${CELL_COLORS.length}];
uniform vec3 heavy;
uniform vec3 light;
varying float vValue;
varying float vReached;
varying float vWeight;
varying vec3 vNormal;
flat varying float vCell;

// How much of the pixel lines at multiples of a period cover. The derivative tells how far away the next
// line is, in pixels. Lines that are too dense to be told apart are faded out.
float lines(float period, float halfWidth) {
  float x = vValue / period;
  float perPixel = max(fwidth(x), 1e-7);
  float pixels = abs(fract(x - 0.5) - 0.5) / perPixel;
  float covered = 1.0 - smoothstep(halfWidth - 0.5, halfWidth + 0.5, pixels);
  return x < 0.5 ? 0.0 : covered * (1.0 - smoothstep(0.2, 0.5, perPixel));
}

void main() {
  vec3 base = texture2D(colors, vec2(clamp(vValue / largest, 0.0, 1.0), 0.5)).rgb;
  if (showsCells) {
    int number = int(vCell + 0.5) % ${CELL_COLORS.length};
    base = mix(cellColors[number], vec3(1.0), 0.35 * smoothstep(0.0, 1.0, vValue / largest));
  }
  if (vReached < 0.999) base = vec3(0.35);
  float amount = clamp(abs(vWeight) / 3.0, 0.0, 1.0);
  base = mix(base, vWeight > 0.0 ? heavy : light, 0.75 * amount);
  if (spacing > 0.0 && vReached > 0.999) {
    float dark = max(0.42 * lines(spacing, 0.6), 0.72 * lines(5.0 * spacing, 1.0));
    // light lines on dark colors
    float luminance = dot(base, vec3(0.2126, 0.7152, 0.0722));
    vec3 ink = mix(vec3(0.4, 0.5, 0.58), vec3(0.012, 0.02, 0.04), smoothstep(0.05, 0.11, luminance));
    base = mix(base, ink, dark);
  }
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
  float lit = 0.5 + 0.5 * dot(normal, normalize(vec3(-0.5, 0.65, 0.6)));
  gl_FragColor = vec4(base * (0.22 + 0.95 * lit * lit), 1.0);
  #include <colorspace_fragment>
}`;

/** The material of the surface: colors, isolines, cells, and painted weights. */
export function surfaceMaterial() {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    uniforms: {
      colors: { value: textureOf(COLOR_MAPS.lagoon.stops) },
      largest: { value: 1 },
      spacing: { value: 0 },
      showsCells: { value: false },
      cellColors: { value: CELL_COLORS.map(color => new Color(color)) },
      heavy: { value: new Color('#8f2d1f') },
      light: { value: new Color('#f7fbe6') },
    },
    // lines on the surface are in front of it
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}
