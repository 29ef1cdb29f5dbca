// What arguments can be. Wrong types raise `TypeError`, and wrong values `RangeError`.

/** The name of the type of a typed array, also of one of another window; or undefined. */
const typeOf = (values) =>
  ArrayBuffer.isView(values) && !(values instanceof DataView)
    ? values[Symbol.toStringTag]
    : undefined;

const isOfIntegers = (type) => /^(Int|Uint)/.test(type);

const shown = (value) => (typeof value === 'string' ? `'${value}'` : String(value));

/** The values as an argument of `Wasm.call`: typed arrays as they are, other ones converted. */
export function numbers(values, name, size) {
  const type = typeOf(values);
  if (type === undefined)
    values = Float64Array.from(elements(values, name), (x, i) => number(x, `${name}[${i}]`));
  else if (type.startsWith('Big'))
    throw new TypeError(`${name} are a ${type}; they must be numbers`);
  checkSize(values, name, size);
  return [values, Float64Array];
}

/** Arrays of integers as they are, other ones converted. */
export function integers(values, name, size) {
  const type = typeOf(values);
  if (type === undefined)
    values = Int32Array.from(elements(values, name), (x, i) => integer32(x, `${name}[${i}]`));
  else if (!isOfIntegers(type)) throw new TypeError(`${name} are a ${type}; they must be integers`);
  checkSize(values, name, size);
  return [values, type === 'Uint32Array' ? Uint32Array : Int32Array];
}

export function bytes(values, name) {
  if (values instanceof ArrayBuffer) return new Uint8Array(values);
  if (!ArrayBuffer.isView(values))
    throw new TypeError(`${name} must be a Uint8Array or an ArrayBuffer`);
  return new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
}

function elements(values, name) {
  if (Array.isArray(values)) return values;
  throw new TypeError(`${name} must be a typed array, or an array of numbers`);
}

/** `size` is the number of values of an element, or the exact `{ size }`, or undefined. */
function checkSize(values, name, size) {
  if (typeof size === 'number' && values.length % size !== 0)
    throw new RangeError(
      `${name} have ${values.length} numbers, which is not a multiple of ${size}`,
    );
  if (typeof size === 'object' && values.length !== size.size)
    throw new RangeError(`${name} have ${values.length} numbers; there must be ${size.size}`);
}

export function number(value, name) {
  if (typeof value === 'number') return value;
  throw new TypeError(`${name} is ${shown(value)}; it must be a number`);
}

export function finite(value, name) {
  if (Number.isFinite(number(value, name))) return value;
  throw new RangeError(`${name} is ${value}; it must be finite`);
}

export function distance(value, name) {
  if (number(value, name) >= 0) return value;
  throw new RangeError(`${name} is ${value}; it must not be negative`);
}

export function integer(value, name, smallest = -Infinity) {
  if (!Number.isInteger(value))
    throw new TypeError(`${name} is ${shown(value)}; it must be an integer`);
  if (value < smallest)
    throw new RangeError(`${name} is ${value}; it must be at least ${smallest}`);
  if (!Number.isSafeInteger(value)) throw new RangeError(`${name} is ${value}, which is too large`);
  return value;
}

function integer32(value, name) {
  if (integer(value, name) === (value | 0)) return value;
  throw new RangeError(`${name} is ${value}, which is too large`);
}

/** A number of elements, limited to what fits 32 bits: there are never so many. */
export function size(value, name, smallest) {
  return Math.min(integer(value, name, smallest), 0xffffffff);
}

/** The options, which must have these names. */
export function options(given, names) {
  if (given === null || typeof given !== 'object')
    throw new TypeError(`the options are ${shown(given)}; they must be an object`);
  for (const name of Object.keys(given))
    if (!names.includes(name))
      throw new TypeError(`there is no option '${name}'; there are ${names.join(', ')}`);
  if (given.progress != null && typeof given.progress !== 'function')
    throw new TypeError(`progress is ${shown(given.progress)}; it must be a function`);
  return given;
}
