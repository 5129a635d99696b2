// What a form holds: which bodies and events each kind of question has, and an empty form of it.

export const KINDS = [
  ["wall", "One wall"],
  ["walls", "Two walls"],
  ["spheres", "Two spheres"],
  ["chain", "Spheres, then a wall"],
];

const EVENTS = {
  wall: [["P", "W"]],
  walls: [["P", "AB"], ["P", "BC"]],
  spheres: [["A", "B"]],
  chain: [["A", "B"], ["B", "W"]],
};

// The bodies by their roles; a statement that is read back may name them otherwise.
export const spheresOf = ({ kind }) => (kind === "wall" || kind === "walls" ? ["P"] : ["A", "B"]);
export const nameOf = ({ names }, role) => names[role] ?? role;
export const countOf = ({ kind }) => EVENTS[kind].length;

// Whether a sphere is told by its speed and its angle to the line of centres.
const isToLine = (answers, role) => answers[`${role}Velocity`] === "line";
export const isAway = (answers, role) =>
  isToLine(answers, role) && answers[`${role}Way`].startsWith("away");

// Which of two spheres strikes the other: it is plain where both are told along the line.
export const isPlainWho = (answers) => isToLine(answers, "A") && isToLine(answers, "B");

export function eventsOf(answers) {
  const events = EVENTS[answers.kind];
  const turned = isPlainWho(answers) ? isAway(answers, "A") : answers.order === "BA";
  return spheresOf(answers).length > 1 && turned ? [["B", "A"], ...events.slice(1)] : events;
}

// How a sphere moves along the line of centres, and to which side of it.
const WAY = "towards-left";

export const noFact = () => ({ what: "", value: "", speed: "", angle: "", way: WAY });
export const noResult = () => ({ what: "", sign: "=", value: "" });

// What is ticked. Until somebody chooses, these are the velocities afterwards that are not known, and
// none where something is to be shown.
export function askedOf({ asked, usual, known, shows }) {
  if (asked !== usual) return asked;
  if (shows.some(({ what }) => what)) return [];
  const isKnown = (key) => known.some(({ what }) =>
    what.replace(/^(polar|line) /, "") === key || what.startsWith(`${key} = `));
  return asked.filter((key) => !isKnown(key));
}

// An empty form: nothing is asked but the velocities afterwards.
export function emptyOf(kind) {
  const shared = {
    kind, names: {}, title: "", e1: "", e2: "", also: "", terms: "", unknown: "", known: [noFact()],
    shows: [noResult()],
  };
  const velocity = (role, way) => {
    const blank = { Mass: "", X: "", Y: "", Speed: "", Angle: "", Vector: "" };
    const fields = Object.entries({ ...blank, Velocity: way, Way: WAY });
    return Object.fromEntries(fields.map(([key, value]) => [role + key, value]));
  };
  const way = (name, mode) => ({ [name]: mode, [`${name}Vector`]: "", [`${name}Angle`]: "" });
  const spheres = {
    ...velocity("A", "components"), ...velocity("B", "components"), ...way("line", "i"),
    order: "AB", offset: "", radius: "",
  };
  const usual = eventsOf({ ...spheres, kind }).flatMap((event, index) =>
    event.filter((role) => spheresOf({ kind }).includes(role))
      .map((role) => `velocity(${role}, ${index + 1})`));
  return { ...shared, ...fieldsOf(), asked: usual, usual };

  function fieldsOf() {
    switch (kind) {
      case "wall":
        return { ...way("wall", "i"), ...velocity("P", "components") };
      case "walls":
        return {
          ...way("first", "i"), ...way("second", "between"), between: "", ...velocity("P", "wall"),
        };
      case "spheres":
        return spheres;
      case "chain":
        return { ...spheres, ...way("wall", "j") };
    }
  }
}
