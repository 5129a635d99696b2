// Small pictures beside the fields: what the kinds look like, and what an angle is measured from.

import { svg } from "../player/elements.js";

const line = (x1, y1, x2, y2, style = "thin") => svg("line", { x1, y1, x2, y2, class: style });
const disc = (cx, cy, r = 7) => svg("circle", { cx, cy, r });
const word = (x, y, said, style = "") => svg("text", { x, y, class: style }, said);

function arrow(x1, y1, x2, y2) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  const [x, y] = [(x2 - x1) / length, (y2 - y1) / length];
  const corner = (side) => `${x2 - 7 * x - 3 * side * y},${y2 - 7 * y + 3 * side * x}`;
  return [
    line(x1, y1, x2 - 5 * x, y2 - 5 * y, "thick"),
    svg("polygon", { points: `${x2},${y2} ${corner(1)} ${corner(-1)}` }),
  ];
}

const hatches = (count, hatch) => Array.from({ length: Math.floor(count) }, (_, k) => hatch(k));
const ground = (x1, y, x2) => [
  line(x1, y, x2, y, "wall"),
  ...hatches((x2 - x1) / 7, (k) => line(x1 + 7 * k + 6, y + 1, x1 + 7 * k + 1, y + 6)),
];
const upright = (x, y1, y2) => [
  line(x, y1, x, y2, "wall"),
  ...hatches((y2 - y1) / 7, (k) => line(x + 1, y1 + 7 * k + 1, x + 6, y1 + 7 * k + 6)),
];
const slope = () => [
  line(74, 50, 94, 15, "wall"),
  ...hatches(5, (k) => line(77 + 3.7 * k, 46 - 6.5 * k, 83 + 3.7 * k, 48 - 6.5 * k)),
];

const DRAWN = {
  wall: () => [ground(18, 50, 82), arrow(20, 12, 46, 44), arrow(54, 44, 80, 22)],
  walls: () => [ground(10, 50, 74), slope(), arrow(14, 22, 36, 48), arrow(40, 48, 80, 32)],
  spheres: () => [disc(43, 32), disc(57, 32), arrow(12, 48, 35, 36), arrow(88, 14, 65, 27)],
  chain: () => [
    disc(34, 32), disc(48, 32), arrow(4, 32, 26, 32), arrow(57, 32, 78, 32), upright(84, 12, 54),
  ],
  angle: (wall) => [
    ground(14, 50, 96), line(20, 50, 55, 50), arrow(20, 14, 54, 48),
    svg("path", { d: "M33 50A22 22 0 0 1 39.4 34.4", class: "thin" }),
    word(22, 44, "α", "letter"), word(84, 46, wall, "name"),
  ],
  between: () => [
    ground(10, 50, 74), slope(),
    svg("path", { d: "M60 50A14 14 0 0 1 81 37.8", class: "thin" }),
    word(8, 45, "A", "name"), word(78, 58, "B", "name"), word(98, 20, "C", "name"),
  ],
  line: () => [
    line(20, 52, 82, 12, "dashed"), disc(44.1, 36.4), disc(55.9, 28.8),
    word(41, 39.6, "A", "name"), word(53, 32, "B", "name"),
  ],
  offset: () => [
    line(10, 44, 96, 44, "dashed"), line(10, 34, 96, 34, "dashed"),
    disc(40, 44), disc(49.8, 34), arrow(8, 44, 32, 44),
    line(82, 34, 82, 44, "thick"), word(86, 42, "d", "letter"),
    word(37, 47.2, "A", "name"), word(46.8, 37.2, "B", "name"),
  ],
};

const [GAP, SIZE, REACH] = [25, 9, 33]; // of the spheres from the middle, of one, of an arrow
const TILT = (38 * Math.PI) / 180; // of an arrow to the line
// How a line of centres is drawn: turned by so many degrees, in a frame that holds it.
const DRAWN_LINES = {
  i: { turned: 0, viewBox: "-4 2 112 58" },
  j: { turned: 90, viewBox: "-4 -24 112 110" },
  other: { turned: 25, viewBox: "-6 -12 116 86" },
};

// Two spheres on their line of centres, and how one of them moves: towards the other or away from
// it, to the left or the right of the line as one looks from A to B.
export function moving(line, role, way, names) {
  const { turned, viewBox } = DRAWN_LINES[line] ?? DRAWN_LINES.other;
  const turn = (turned * Math.PI) / 180;
  const place = (along, across) => [
    52 + along * Math.cos(turn) - across * Math.sin(turn),
    31 - along * Math.sin(turn) - across * Math.cos(turn),
  ];
  const [sense, side] = way.split("-");
  const ahead = (sense === "towards") === (role === "A") ? 1 : -1;
  const up = side === "left" ? 1 : -1;
  const at = role === "A" ? -GAP : GAP;
  const reach = (length, tilt = TILT) =>
    place(at + ahead * length * Math.cos(tilt), up * length * Math.sin(tilt));
  const named = (name, along) => {
    const [x, y] = place(along, 0);
    return [disc(x, y, SIZE), word(x - 2.8, y + 3.2, name, "name")];
  };
  // The angle, from the line to the arrow.
  const arc = [0, 0.5, 1].map((share) => reach(18, share * TILT).join(" "));
  return svg("svg", { ...SEEN, viewBox }, [
    line_(place(-50, 0), place(50, 0)), named(names.A ?? "A", -GAP), named(names.B ?? "B", GAP),
    arrow(...reach(SIZE), ...reach(REACH)),
    svg("path", { d: `M${arc[0]}Q${arc[1]} ${arc[2]}`, class: "thin" }),
  ].flat(2));
}

const line_ = ([x1, y1], [x2, y2]) => line(x1, y1, x2, y2, "dashed");

const SEEN = {
  viewBox: "0 0 104 62", class: "hint-picture", "aria-hidden": "true", focusable: "false",
};

export const picture = (name, wall) => svg("svg", SEEN, DRAWN[name](wall).flat());
