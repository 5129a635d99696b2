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
  switch (kind) {
    case "wall":
      return {
        ...shared, ...way("wall", "i"), ...velocity("P", "components"), asked: ["velocity(P, 1)"],
      };
    case "walls":
      return {
        ...shared, ...way("first", "i"), ...way("second", "between"), between: "",
        ...velocity("P", "wall"), asked: ["velocity(P, 1)", "velocity(P, 2)"],
      };
    case "spheres":
      return { ...shared, ...spheres, asked: ["velocity(A, 1)", "velocity(B, 1)"] };
    case "chain":
      return {
        ...shared, ...spheres, ...way("wall", "j"),
        asked: ["velocity(A, 1)", "velocity(B, 1)", "velocity(B, 2)"],
      };
  }
}
