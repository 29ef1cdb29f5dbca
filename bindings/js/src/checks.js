// What arguments can be. Wrong types raise `TypeError`, and wrong values `RangeError`.

/** The name of the type of a typed array, also of one of another window; or undefined. */
const typeOf = (values) =>
  ArrayBuffer.isView(values) && !(values instanceof DataView)
    ? values[Symbol.toStringTag]
    : undefined;

const isOfIntegers = (type) => /^(Int|Uint)/.test(type);

/** An object of properties: also one of another window, but none of a class. */
const isPlain = (value) => {
  if (value === null || typeof value !== 'object') return false;
  const prototype = Object.getPrototypeOf(value);
  return prototype === null || Object.getPrototypeOf(prototype) === null;
};

/** How messages show a value: of objects, what distinguishes them. */
export function shown(value) {
  if (typeof value === 'string') return `'${value}'`;
  if (typeof value === 'bigint') return `${value}n`;
  if (typeof value === 'function') return 'a function';
  if (value === null || typeof value !== 'object') return String(value);
  if (!isPlain(value))
    return `an object of type ${Object.prototype.toString.call(value).slice('[object '.length, -1)}`;
  const [first, ...others] = Object.keys(value);
  if (first === undefined) return '{}';
  const names = [first, ...others.slice(0, 5), ...(others.length > 5 ? ['...'] : [])];
  return `{ ${names.join(', ')} }`;
}

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
  else checkIntegers(type, name);
  checkSize(values, name, size);
  return [values, type === 'Uint32Array' ? Uint32Array : Int32Array];
}

export function bytes(values, name) {
  if (values instanceof ArrayBuffer) return new Uint8Array(values);
  if (!ArrayBuffer.isView(values))
    throw new TypeError(`${name} must be a Uint8Array or an ArrayBuffer`);
  return new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
}

/** The elements of what can be iterated, which strings are not meant to be; or else undefined. */
export function sequence(values, name) {
  const type = typeOf(values);
  if (type !== undefined) checkIntegers(type, name);
  if (values === null || typeof values !== 'object') return undefined;
  if (typeof values[Symbol.iterator] !== 'function') return undefined;
  checkAttached(values, name);
  return type === undefined ? Array.from(values) : values;
}

function elements(values, name) {
  if (Array.isArray(values)) return values;
  throw new TypeError(`${name} must be a typed array, or an array of numbers`);
}

function checkIntegers(type, name) {
  if (!isOfIntegers(type)) throw new TypeError(`${name} are a ${type}; they must be integers`);
}

/** `size` is the number of values of an element, or the exact `{ size }`, or undefined. */
function checkSize(values, name, size) {
  checkAttached(values, name);
  if (typeof size === 'number' && values.length % size !== 0)
    throw new RangeError(
      `${name} have ${values.length} numbers, which is not a multiple of ${size}`,
    );
  if (typeof size === 'object' && values.length !== size.size)
    throw new RangeError(`${name} have ${values.length} numbers; there must be ${size.size}`);
}

/** A typed array is empty when its buffer was transferred, to a worker for instance. */
function checkAttached(values, name) {
  if (values.length !== 0 || !ArrayBuffer.isView(values)) return;
  try {
    new Uint8Array(values.buffer);
  } catch {
    throw new TypeError(`${name} were transferred, and are not here anymore`);
  }
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

/** Whether an option is wanted. */
export function flag(value, name) {
  if (value == null || typeof value === 'boolean') return Boolean(value);
  throw new TypeError(`${name} is ${shown(value)}; it must be true or false`);
}

/** The options, which must have these names, or any. */
export function options(given, names = undefined) {
  named(given, names, 'the options', 'option');
  if (given.progress != null && typeof given.progress !== 'function')
    throw new TypeError(`progress is ${shown(given.progress)}; it must be a function`);
  return given;
}

/** An object whose properties have these names. */
export function named(given, names, name, part) {
  if (!isPlain(given))
    throw new TypeError(`${name} are ${shown(given)}; they must be a plain object`);
  for (const one of names ? Object.keys(given) : [])
    if (!names.includes(one))
      throw new TypeError(`there is no ${part} '${one}'; there are ${names.join(', ') || 'none'}`);
}

/** Those of `loadGeodesics`, and others. */
export function loadOptions(given, ...others) {
  const names = ['wasmUrl', 'wasmBinary', 'wasmModule', 'maximumMemory', 'warmUp', ...others];
  return options(given, names);
}
