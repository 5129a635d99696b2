// Numbers as people write them, and vectors [x, y].

export function figures(x) {
  if (Math.abs(x) < 5e-10) return "0";
  const size = Math.abs(x);
  const near = Math.round(size);
  let text = size >= 999.5 ? String(near) : size.toPrecision(3);
  if (near && Math.abs(size - near) < 1e-9 * near) text = String(near);
  if (text.includes("e")) text = size.toFixed(6);
  return (x < 0 ? "−" : "") + text;
}

export const seconds = (t) => `${(Math.abs(t) < 0.005 ? 0 : t).toFixed(2).replace("-", "−")} s`;

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
export const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
export const plus = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1]];
export const size = (a) => Math.hypot(a[0], a[1]);
export const smooth = (x) => x * x * (3 - 2 * x); // from 0 to 1 without a jerk at either end
