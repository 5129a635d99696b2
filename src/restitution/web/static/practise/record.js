// What has been practised: one attempt after the other, kept in this browser and nowhere else.

const NAME = "restitution practice";
const MOST = 2000; // attempts

const DAY = 86_400_000; // ms
export const today = () => Math.floor((Date.now() - new Date().getTimezoneOffset() * 60_000) / DAY);

const isAttempt = (each) =>
  each && typeof each.topic === "string" && Number.isInteger(each.level) &&
  Number.isInteger(each.day) && Array.isArray(each.mistakes);

function parsed(text) {
  try {
    const told = JSON.parse(text);
    return Array.isArray(told) ? told.filter(isAttempt).slice(-MOST) : null;
  } catch {
    return null;
  }
}

export function makeRecord() {
  let attempts = parsed(stored()) ?? [];

  function stored() {
    try {
      return localStorage.getItem(NAME) ?? "[]";
    } catch {
      return "[]"; // a browser may refuse to keep anything
    }
  }

  function keep() {
    try {
      localStorage.setItem(NAME, JSON.stringify(attempts));
    } catch {
      // The record lasts as long as the page.
    }
  }

  return {
    get attempts() {
      return attempts;
    },
    add(attempt) {
      // Who marks the same question once more has not practised twice.
      const { topic, level, seed, day } = attempt;
      const last = attempts.at(-1);
      const again = last && last.topic === topic && last.level === level && last.seed === seed &&
        last.day === day;
      attempts = [...(again ? attempts.slice(0, -1) : attempts), attempt].slice(-MOST);
      keep();
    },
    // A code that another machine takes, and the record out of one; false where it is none.
    get code() {
      return btoa(JSON.stringify(attempts));
    },
    take(code) {
      let told = null;
      try {
        told = parsed(atob(code.trim()));
      } catch {
        return false;
      }
      if (!told) return false;
      const known = new Set(attempts.map((each) => JSON.stringify(each)));
      attempts = [...attempts, ...told.filter((each) => !known.has(JSON.stringify(each)))]
        .sort((a, b) => a.day - b.day).slice(-MOST);
      keep();
      return true;
    },
  };
}
