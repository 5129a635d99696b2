// What was edited, to be undone and done again.

export class History {
  constructor(value) {
    this.begin(value);
  }

  begin(value) {
    this.past = [];
    this.future = [];
    this.value = value;
    this.key = null;
  }

  // `key` joins edits of one kind that follow one another, such as the steps of a slider.
  put(value, key = null) {
    if (key === null || key !== this.key) this.past.push(this.value);
    this.key = key;
    this.value = value;
    this.future = [];
  }

  // Each tells whether there was anything to go to.
  undo() {
    return this.turn(this.past, this.future);
  }

  redo() {
    return this.turn(this.future, this.past);
  }

  turn(from, to) {
    if (!from.length) return false;
    to.push(this.value);
    this.value = from.pop();
    this.key = null;
    return true;
  }
}
