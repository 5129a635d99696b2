// What scrolls, and how the keyboard comes to it.

import { reachable } from "../player/elements.js";

// What scrolls in an element can be reached by the keyboard, and only while it does: looked at when
// the element has another size, when letters come, and whenever what is returned is called.
export function keepReachable(root, selector) {
  const look = () => root.querySelectorAll(selector).forEach(reachable);
  new ResizeObserver(look).observe(root);
  document.fonts.addEventListener("loadingdone", look);
  return look;
}
