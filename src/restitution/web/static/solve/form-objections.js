// Why a field cannot go into a statement as it stands: what would say more there than one value.
// What is in the field all the same, the server judges.

import { plainDegrees } from "./form-angle.js";

const WORDS = {
  number: /\b(at|from|to|in|as|of|and|again)\b/,
  angle: /\b(at|in|as|of|and|again)\b/,
  vector: /\b(in|as|of|and|again)\b/,
  shown: /\b(at|from|in|as|of|and|again)\b/,
};
const UNIT_VECTOR = /(?<![A-Za-z_])[ij](?![A-Za-z_(])/;
// Units that a velocity, or an angle, surely has not; of the others the server judges.
const STRANGE = {
  component: [/[\d)]\s*(kg|N\s?s|J|rad|deg\w*|°)(?!\w)/, "a velocity is in m/s"],
  angle: [/[\d)]\s*(kg|[kc]?m\s?\/\s?[sh]|m\s?s|N\s?s|[kcm]m|[mgsNJ])(?!\w)/,
    "an angle is in degrees"],
};
// A unit behind a letter would be read as letters, and is meant as none.
const UNITS = String.raw`kg|km\s?/\s?h|m\s?/\s?s|m\s?s\s?\^?\s?[-−]\s?1|N\s?s`;
const BEHIND_A_LETTER = new RegExp(String.raw`(?<=\p{L})(?<!\d\s*kg)\s+(${UNITS})$`, "u");
const DECIMAL_COMMA = /^[-−–]?\s*\d+,\d+$/;
const NAMED = /^\p{L}\w?\s*=(?=\s*[^\s=<>≤≥]+$)/u; // as in e = 1/2
const NUMBER = /^\d+(\.\d+)?\s*%?$/;

// `kind` is what the field is to hold: a title, a number, component, angle, vector, percentage,
// fact, list of items, list of letters, or a result that is shown.
export function objection(text, kind) {
  if (kind === "title") {
    return /[\\\n]/.test(text) ? "Leave out the sign \\: a title is one line of words." : null;
  }
  const sign = /[#:\\\n]/.exec(text);
  if (sign) return `Leave out the sign ${sign[0]}: it means something else in a statement.`;
  const open = unbalanced(text);
  if (open) return open;
  if (!LISTS.has(kind)) {
    if (DECIMAL_COMMA.test(text)) {
      return `Write ${text.replace(",", ".")}: a decimal has a point in place of the comma.`;
    }
    if (hasOutside(text, ",")) return "Leave out the comma: this field takes one value.";
    const relation = kind !== "fact" && /[=<>≤≥]/.exec(text);
    const named = relation && NAMED.exec(text);
    if (named) return `Leave out “${named[0].trim()}”: this field takes the value alone.`;
    if (relation) {
      return `Leave out the sign ${relation[0]}: this field takes a value. ` +
        "An equation goes under “What else is known”.";
    }
  }
  const word = WORDS[kind === "component" || kind === "size" ? "number" : kind]?.exec(text);
  if (word) return `Leave out the word “${word[0]}”: this field takes one value.`;
  const unit = BEHIND_A_LETTER.exec(text);
  if (unit) return `Leave out “${unit[1]}”: a letter stands for a value with its unit.`;
  const strange = STRANGE[kind]?.[0].exec(text);
  if (strange) return `Leave out “${strange[1]}”: ${STRANGE[kind][1]}.`;
  if (kind === "component" && UNIT_VECTOR.test(text)) {
    return `Leave out ${UNIT_VECTOR.exec(text)[0]}: the field says already which component it is.`;
  }
  if (kind === "percentage" && !NUMBER.test(text) && !/%/.test(text)) {
    return "A percentage is a number such as 60; a fraction has a line of its own.";
  }
  if (kind === "acute" && plainDegrees(text) > 90) {
    return "The angle with the line of centres is at most 90°; its sense is chosen below.";
  }
  return null;
}

const LISTS = new Set(["fact", "items"]);

function unbalanced(text) {
  let depth = 0;
  for (const sign of text) {
    depth += (sign === "(") - (sign === ")");
    if (depth < 0) return "There is a closing bracket too many.";
  }
  return depth > 0 ? "A bracket is not closed." : null;
}

function hasOutside(text, wanted) {
  let depth = 0;
  return [...text].some((sign) => {
    depth += (sign === "(") - (sign === ")");
    return depth === 0 && sign === wanted;
  });
}
