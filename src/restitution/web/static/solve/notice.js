// What is said when the server takes its time, or does not answer a statement; trying again.

import { sentence } from "../api.js";
import { button, html } from "../player/elements.js";

const KNOCK = 4000; // ms between two looks for a server that is lost

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

  // Whether the server is there again.
  async function knock() {
    const mine = timer;
    const reply = await fetch("health").catch(() => null);
    if (reply?.ok && mine === timer && !root.hidden) retry();
  }

  function retry() {
    clear();
    again();
  }

  return {
    clear,
    // What is being done, where it takes its time.
    doing(said) {
      clear();
      root.append(html("p", {}, said));
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
        const hint = "Your work is kept, and goes on as soon as it is back.";
        put(`The connection to the server is lost. ${hint}`, "Try again");
        timer = setInterval(knock, KNOCK);
      } else {
        put(`${sentence(message)} Your work is kept.`, "Try again");
      }
    },
  };
}
