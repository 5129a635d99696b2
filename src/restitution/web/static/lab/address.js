// The address of the Lab: a prepared scene, perhaps with what was edited of it, or one's own.

import { fromRows, fromText, toText } from "./scene.js";
import { SCENES } from "./scenes.js";

// What a fragment says: the scene, the `base` to which it is reset, the `prepared` one behind it
// (the first where nothing is said) or null, and whether all of it could be read.
export function read(text) {
  const told = new URLSearchParams(text);
  const found = SCENES.find(({ id }) => id === told.get("scene")) ?? null;
  const own = fromText(told);
  const prepared = found ?? (own ? null : SCENES[0]);
  const base = prepared ? fromRows(prepared) : own;
  return { scene: own ?? base, base, prepared, readable: !text || Boolean(found ?? own) };
}

// The fragment of a scene.
export function fragment(scene, base, prepared) {
  const name = prepared ? `scene=${prepared.id}` : "";
  if (name && scene === base) return name;
  return [name, toText(scene)].filter(Boolean).join("&");
}
