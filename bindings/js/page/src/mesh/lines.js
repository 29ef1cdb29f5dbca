/** A file that cannot be read. The message says what is wrong, and where. */
export class MeshFileError extends Error {}

/** The lines of a text, as lists of words. Comments after `#` and empty lines are skipped. */
export class Lines {
  /** @param {string} text */
  constructor(text) {
    this.text = text;
    this.position = 0;
    this.number = 0;
  }

  /**
   * The words of the next line that has any; undefined at the end of the text.
   * @returns {string[] | undefined}
   */
  next() {
    while (this.position < this.text.length) {
      const words = withoutComment(this.takeLine()).trim();
      if (words !== '') return words.split(/\s+/);
    }
    return undefined;
  }

  /**
   * The words of the next line, which has to be there.
   * @param {string} what the line is for
   */
  require(what) {
    const words = this.next();
    if (!words) throw new MeshFileError(`the file ends before ${what}`);
    return words;
  }

  /**
   * @param {string | undefined} word
   * @param {string} what it is
   */
  finite(word, what) {
    const number = Number(word);
    if (word === undefined || !Number.isFinite(number)) this.fail(`${what} is ${shown(word)}, not a number`);
    return number;
  }

  /**
   * @param {string | undefined} word
   * @param {string} what it is
   */
  integer(word, what) {
    const number = Number(word);
    if (word === undefined || !Number.isSafeInteger(number)) this.fail(`${what} is ${shown(word)}, not an integer`);
    return number;
  }

  /**
   * @param {string} what
   * @returns {never}
   */
  fail(what) {
    throw new MeshFileError(`line ${this.number}: ${what}`);
  }

  takeLine() {
    const end = this.text.indexOf('\n', this.position);
    const line = this.text.slice(this.position, end < 0 ? undefined : end);
    this.position = end < 0 ? this.text.length : end + 1;
    ++this.number;
    return line;
  }
}

/** @param {string} line */
function withoutComment(line) {
  const start = line.indexOf('#');
  return start < 0 ? line : line.slice(0, start);
}

/** @param {string | undefined} word */
function shown(word) {
  if (word === undefined) return 'missing';
  return `“${word.length > 20 ? word.slice(0, 20) + '…' : word}”`;
}
