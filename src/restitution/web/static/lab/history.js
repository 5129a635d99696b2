// What was edited, to be undone and done again.

export class History {
  constructor(value) {
    this.begin(value);
  }

  begin(value) {
    this.past = [];
    this.future = [];
    this.value = value;
  }

  // `key` joins edits of one kind that follow one another, such as the steps of a slider.
  put(value, key = null) {
    if (key === null || key !== this.key) this.past.push(this.value);
    this.key = key;
    this.value = value;
    this.future = [];
  }

  undo() {
    if (!this.past.length) return false;
    this.future.push(this.value);
    this.value = this.past.pop();
    this.key = null;
    return true;
  }

  redo() {
    if (!this.future.length) return false;
    this.past.push(this.value);
    this.value = this.future.pop();
    this.key = null;
    return true;
  }
}
