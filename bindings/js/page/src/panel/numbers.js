/**
 * A number with three digits; a dash if it is not finite.
 * @param {number | undefined} x
 */
export function short(x) {
  if (x === undefined || !Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-4) return x.toExponential(1);
  if (size >= 1000) return Math.round(x).toLocaleString('en-US');
  return String(Number(x.toPrecision(3)));
}

/**
 * A length with as many digits as tell methods apart.
 * @param {number | undefined} x
 */
export function long(x) {
  if (x === undefined || !Number.isFinite(x)) return '–';
  const size = Math.abs(x);
  if (size >= 1e7 || (size < 1e-3 && size > 0)) return x.toExponential(3);
  return x.toLocaleString('en-US', { minimumSignificantDigits: 5, maximumSignificantDigits: size >= 1e5 ? 7 : 5 });
}

/** @param {number | undefined} x */
export function milliseconds(x) {
  if (x === undefined) return '–';
  return x >= 1000 ? `${short(x / 1000)} s` : `${x >= 10 ? Math.round(x) : Number(x.toFixed(1))} ms`;
}

/** @param {number | undefined} x a fraction */
export function percent(x) {
  if (x === undefined || !Number.isFinite(x)) return '–';
  if (x < 5e-7) return '0 %'; // rounding errors
  const y = 100 * x;
  return `${y >= 10 ? Math.round(y) : y >= 0.01 ? Number(y.toPrecision(2)) : '< 0.01'} %`;
}

/** @param {number} n */
export function count(n) {
  return n.toLocaleString('en-US');
}

/**
 * The smallest of 1, 2, 5, 10, 20, ... and of 0.5, 0.2, 0.1, ... that is not below a number.
 * @param {number} x above 0
 */
export function roundUp(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  const step = [1, 2, 5, 10].find(digit => digit * power >= x * (1 - 1e-9)) ?? 10;
  return step * power;
}

/**
 * Round numbers from 0 to a largest one, and their texts, with the same number of digits.
 * @param {number} largest
 * @param {number} number about how many
 */
export function ticksUpTo(largest, number) {
  if (!(largest > 0 && largest < Infinity)) return [{ value: 0, text: '0' }];
  const step = roundUp(largest / number);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return Array.from({ length: Math.floor(largest / step + 1e-9) + 1 }, (_, i) => {
    const value = i * step;
    const text = value >= 1e6 || digits > 4 ? (value === 0 ? '0' : value.toExponential(1)) :
      value.toLocaleString('en-US', { minimumFractionDigits: digits, maximumFractionDigits: digits });
    return { value, text };
  });
}
