// What is said when the server takes its time, or does not answer a statement; trying again.

import { sentence } from "../api.js";
import { button, html } from "../player/elements.js";

export function makeNotice(root, again) {
  let timer = 0;

  function clear() {
    clearInterval(timer);
    root.replaceChildren();
    root.hidden = true;
  }

  function put(said, label) {
    root.replaceChildren(html("p", {}, said), button(label, retry));
    root.hidden = false;
  }

  function retry() {
    clear();
    again();
  }

  return {
    clear,
    solving() {
      clear();
      root.append(html("p", {}, "Solving …"));
      root.hidden = false;
    },
    refused({ status, message, wait }) {
      clear();
      if (status === 503) {
        let left = Math.ceil(wait ?? 5);
        const counting = html("span", { "aria-hidden": "true" });
        const count = () => (counting.textContent = `Trying again in ${left} s.`);
        put(["The server is busy just now. ", counting], "Try now");
        count();
        timer = setInterval(() => {
          left -= 1;
          if (left <= 0) retry();
          else count();
        }, 1000);
      } else if (status === 0) {
        const hint = "Your work is kept; try again when you are back on the network.";
        put(`There is no answer from the server. ${hint}`, "Try again");
      } else {
        put(`${sentence(message)} Your work is kept.`, "Try again");
      }
    },
  };
}
