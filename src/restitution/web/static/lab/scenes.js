// Prepared scenes, each with what to watch; spheres and walls in rows, as scene.js reads them.
// What stands behind the name is JSON.
export const SCENES = [
  {
    "id": "snooker",
    "title": "The snooker right angle",
    "watch": "Equal masses, e = 1, the second at rest: they leave at a right angle to each other, wherever they meet.",
    "spheres": [
      ["A", 1, 0.12, 0.6, 0.9, 1.6, 0],
      ["B", 1, 0.12, 2.2, 1.02, 0, 0]
    ],
    "walls": [
      ["Bottom", 0, 0, 4, 0, 1],
      ["Right", 4, 0, 4, 2, 1],
      ["Top", 4, 2, 0, 2, 1],
      ["Left", 0, 2, 0, 0, 1]
    ],
    "e": 1,
    "seconds": 1.95,
    "slow": true,
    "show": "velocities components trails speeds"
  },
  {
    "id": "corner",
    "title": "The corner",
    "watch": "Two cushions at a right angle, e = 1: the ball comes back antiparallel to the way it went in, whatever that was.",
    "spheres": [
      ["P", 1, 0.1, 1.6, 1.5, -1.2, -0.9]
    ],
    "walls": [
      ["Bottom", 0, 0, 3, 0, 1],
      ["Left", 0, 2, 0, 0, 1]
    ],
    "e": 1,
    "seconds": 2.9,
    "slow": true,
    "show": "velocities components trails"
  },
  {
    "id": "newton",
    "title": "Newton’s line",
    "watch": "Each sphere hands its whole velocity on; only the last one leaves. Change one mass, or e, and look again.",
    "spheres": [
      ["A", 1, 0.15, 0.5, 0.6, 1.5, 0],
      ["B", 1, 0.15, 1.5, 0.6, 0, 0],
      ["C", 1, 0.15, 1.86, 0.6, 0, 0],
      ["D", 1, 0.15, 2.22, 0.6, 0, 0],
      ["E", 1, 0.15, 2.58, 0.6, 0, 0]
    ],
    "walls": [
      ["Bottom", 0, 0, 4, 0, 1],
      ["Right", 4, 0, 4, 1.2, 1],
      ["Top", 4, 1.2, 0, 1.2, 1],
      ["Left", 0, 1.2, 0, 0, 1]
    ],
    "e": 1,
    "seconds": 5,
    "slow": true,
    "show": "velocities components speeds"
  },
  {
    "id": "angles",
    "title": "e measured by two angles",
    "watch": "At each impact tan β / tan α is e, at whatever angle and speed a ball comes in: throw them anew.",
    "spheres": [
      ["P", 1, 0.1, 0.4, 1.5, 1, -1],
      ["Q", 1, 0.1, 2.6, 1.6, 0.5, -1.5]
    ],
    "walls": [
      ["W", 0, 0, 4, 0, 0.6]
    ],
    "e": 1,
    "seconds": 2.2,
    "slow": true,
    "show": "velocities components trails"
  },
  {
    "id": "gas",
    "title": "A gas",
    "watch": "All set off at one speed and soon have very different ones; energy is kept, momentum goes to the walls and comes back.",
    "spheres": [
      ["G1", 1, 0.09, 0.25, 0.25, -0.86, 0.27],
      ["G2", 1, 0.09, 0.25, 0.75, -0.84, -0.33],
      ["G3", 1, 0.09, 0.25, 1.25, 0.8, -0.41],
      ["G4", 1, 0.09, 0.25, 1.75, -0.88, 0.19],
      ["G5", 1, 0.09, 0.25, 2.25, -0.9, -0.04],
      ["G6", 1, 0.09, 0.75, 0.25, -0.77, -0.47],
      ["G7", 1, 0.09, 0.75, 0.75, 0.36, 0.83],
      ["G8", 1, 0.09, 0.75, 1.25, -0.9, -0.07],
      ["G9", 1, 0.09, 0.75, 1.75, -0.62, -0.66],
      ["G10", 1, 0.09, 0.75, 2.25, 0.24, -0.87],
      ["G11", 1, 0.09, 1.25, 0.25, 0.75, 0.5],
      ["G12", 1, 0.09, 1.25, 0.75, -0.3, 0.85],
      ["G13", 1, 0.09, 1.25, 1.25, 0.76, 0.49],
      ["G14", 1, 0.09, 1.25, 1.75, 0.33, -0.84],
      ["G15", 1, 0.09, 1.25, 2.25, -0.31, -0.84],
      ["G16", 1, 0.09, 1.75, 0.25, 0.87, 0.23],
      ["G17", 1, 0.09, 1.75, 0.75, 0.89, -0.1],
      ["G18", 1, 0.09, 1.75, 1.25, 0.88, -0.2],
      ["G19", 1, 0.09, 1.75, 1.75, -0.51, -0.74],
      ["G20", 1, 0.09, 1.75, 2.25, -0.67, -0.6],
      ["G21", 1, 0.09, 2.25, 0.25, 0.49, 0.75],
      ["G22", 1, 0.09, 2.25, 0.75, 0.9, 0.08],
      ["G23", 1, 0.09, 2.25, 1.25, -0.89, -0.16],
      ["G24", 1, 0.09, 2.25, 1.75, 0.84, 0.33],
      ["G25", 1, 0.09, 2.25, 2.25, 0.33, 0.84],
      ["G26", 1, 0.09, 2.75, 0.25, 0.05, 0.9],
      ["G27", 1, 0.09, 2.75, 0.75, 0.88, 0.17],
      ["G28", 1, 0.09, 2.75, 1.25, -0.88, 0.2],
      ["G29", 1, 0.09, 2.75, 1.75, -0.84, 0.33],
      ["G30", 1, 0.09, 2.75, 2.25, 0.49, -0.75],
      ["G31", 1, 0.09, 3.25, 0.25, -0.89, -0.11],
      ["G32", 1, 0.09, 3.25, 0.75, -0.57, -0.69],
      ["G33", 1, 0.09, 3.25, 1.25, -0.9, 0.0],
      ["G34", 1, 0.09, 3.25, 1.75, -0.47, -0.77],
      ["G35", 1, 0.09, 3.25, 2.25, -0.87, 0.24],
      ["G36", 1, 0.09, 3.75, 0.25, -0.16, 0.89],
      ["G37", 1, 0.09, 3.75, 0.75, 0.9, -0.01],
      ["G38", 1, 0.09, 3.75, 1.25, 0.9, -0.02],
      ["G39", 1, 0.09, 3.75, 1.75, 0.48, -0.76],
      ["G40", 1, 0.09, 3.75, 2.25, -0.24, -0.87],
      ["G41", 1, 0.09, 4.25, 0.25, -0.36, 0.83],
      ["G42", 1, 0.09, 4.25, 0.75, 0.11, 0.89],
      ["G43", 1, 0.09, 4.25, 1.25, -0.22, 0.87],
      ["G44", 1, 0.09, 4.25, 1.75, 0.81, 0.38],
      ["G45", 1, 0.09, 4.25, 2.25, 0.09, -0.9]
    ],
    "walls": [
      ["Bottom", 0, 0, 4.5, 0, 1],
      ["Right", 4.5, 0, 4.5, 2.5, 1],
      ["Top", 4.5, 2.5, 0, 2.5, 1],
      ["Left", 0, 2.5, 0, 0, 1]
    ],
    "e": 1,
    "seconds": 12,
    "slow": false,
    "show": "velocities"
  },
  {
    "id": "break",
    "title": "A break",
    "watch": "One ball’s momentum spreads over sixteen; at every impact a little energy goes, and at the cushions momentum.",
    "spheres": [
      ["A", 1, 0.075, 0.8, 0.86, 4, 0],
      ["B1", 1, 0.075, 2.5, 0.9, 0, 0],
      ["B2", 1, 0.075, 2.6316, 0.824, 0, 0],
      ["B3", 1, 0.075, 2.6316, 0.976, 0, 0],
      ["B4", 1, 0.075, 2.7633, 0.748, 0, 0],
      ["B5", 1, 0.075, 2.7633, 0.9, 0, 0],
      ["B6", 1, 0.075, 2.7633, 1.052, 0, 0],
      ["B7", 1, 0.075, 2.8949, 0.672, 0, 0],
      ["B8", 1, 0.075, 2.8949, 0.824, 0, 0],
      ["B9", 1, 0.075, 2.8949, 0.976, 0, 0],
      ["B10", 1, 0.075, 2.8949, 1.128, 0, 0],
      ["B11", 1, 0.075, 3.0265, 0.596, 0, 0],
      ["B12", 1, 0.075, 3.0265, 0.748, 0, 0],
      ["B13", 1, 0.075, 3.0265, 0.9, 0, 0],
      ["B14", 1, 0.075, 3.0265, 1.052, 0, 0],
      ["B15", 1, 0.075, 3.0265, 1.204, 0, 0]
    ],
    "walls": [
      ["Bottom", 0, 0, 3.6, 0, 0.8],
      ["Right", 3.6, 0, 3.6, 1.8, 0.8],
      ["Top", 3.6, 1.8, 0, 1.8, 0.8],
      ["Left", 0, 1.8, 0, 0, 0.8]
    ],
    "e": 0.95,
    "seconds": 6,
    "slow": false,
    "show": "velocities trails"
  },
  {
    "id": "empty",
    "title": "An empty table",
    "watch": "One sphere and four cushions: throw it, add others, draw walls.",
    "spheres": [
      ["A", 1, 0.12, 1, 1, 0.8, 0.4]
    ],
    "walls": [
      ["Bottom", 0, 0, 4, 0, 0.9],
      ["Right", 4, 0, 4, 2, 0.9],
      ["Top", 4, 2, 0, 2, 0.9],
      ["Left", 0, 2, 0, 0, 0.9]
    ],
    "e": 0.9,
    "seconds": 10,
    "slow": true,
    "show": "velocities components trails"
  }
];
