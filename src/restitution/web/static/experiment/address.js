// The address of an experiment: its table and how it is read, so that a link carries both.

const NAMES = ["data", "angle_error", "speed_error", "from_normal"];

// What the address holds, as texts by name; null where it holds no table.
export function read() {
  const given = new URLSearchParams(location.hash.slice(1));
  if (!given.get("data")) return null;
  return Object.fromEntries(NAMES.map((name) => [name, given.get(name) ?? ""]));
}

export function fragment(fields) {
  const kept = NAMES.filter((name) => fields[name]).map((name) => [name, fields[name]]);
  return `#${new URLSearchParams(kept)}`;
}

// From now on the address is that of this experiment.
export function hold(fields) {
  const address = fields.data.trim() ? fragment(fields) : "#";
  if (address !== (location.hash || "#")) history.replaceState(null, "", address);
}
