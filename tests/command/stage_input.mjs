// What stands on a lesson's stage, from its tables, as the command line takes it.

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const plus = (a, b, times = 1) => a.map((x, i) => x + times * b[i]);
const minus = (a) => a.map((x) => -x);
const product = (a, b) => a.map((row) => b[0].map((_, j) => dot(row, b.map((other) => other[j]))));

/** The rotation by degrees about x, then y, then z, as a matrix; in the plane by one angle. */
export function rotation(turn) {
  const angles = typeof turn === "number" ? [turn] : turn;
  const about = angles.length === 1 ? [2] : [0, 1, 2];
  return about.reduce((before, axis, i) => {
    const [cos, sin] = [Math.cos(angles[i] * Math.PI / 180), Math.sin(angles[i] * Math.PI / 180)];
    const [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
    const matrix = [0, 1, 2].map((row) => [0, 1, 2].map((column) => Number(row === column)));
    Object.assign(matrix[j], { [j]: cos, [k]: -sin }), Object.assign(matrix[k], { [j]: sin, [k]: cos });
    return product(matrix, before);
  }, [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
}

/** The axis and the angle in degrees of that rotation, in space. */
export function axis_and_degrees(turn) {
  const r = rotation(turn);
  const axis = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
  return { axis, degrees: Math.atan2(Math.hypot(...axis), r[0][0] + r[1][1] + r[2][2] - 1) * 180 / Math.PI };
}

/** The unit axes of a box that is rotated so, as rows. */
function axes_of(turn, dim) {
  const r = rotation(turn);
  return Array.from({ length: dim }, (_, i) => r.slice(0, dim).map((row) => row[i]));
}

export const obb = (center, half_extents, turn) => ({ obb: { center, axes: axes_of(turn, center.length), half_extents } });

/** A volume of [volumes], whose oriented boxes have angles in place of axes. */
export const volume = (held) => held.obb ? obb(held.obb.center, held.obb.half_extents, held.obb.turn) : held;

/** A plane whose normal has length 1, through a point. */
function plane(normal, through) {
  const unit = normal.map((x) => x / Math.hypot(...normal));
  return [...unit, -dot(unit, through)];
}

/** The planes that a camera sees between. sideways: pairs of an axis across the view and the tangent of half its angle. */
export function frustum(position, ahead, sideways, near, far) {
  const planes = sideways.flatMap(([across, tangent]) =>
    [minus(across), across].map((way) => plane(plus(way, ahead, -tangent), position)));
  return { planes: [...planes, plane(minus(ahead), plus(position, ahead, near)), plane(ahead, plus(position, ahead, far))] };
}

/** The body and the frustum of [boxes], whose second box tapers towards the camera. */
export function body_and_frustum({ dim = 2, taper, center, half_extents, turn, radius }) {
  const box = half_extents.at(-1), axes = axes_of(turn.at(-1), dim);
  const apex = 2 * box[0] * taper / (1 - taper), far = apex + 2 * box[0];
  const position = plus(center[1], axes[0], -box[0] - apex);
  const sideways = dim === 2 ? [[minus(axes[1]), box[1] / far]] : [[axes[2], box[2] / far], [axes[1], box[1] / far]];
  const body = half_extents.length === 2 ? obb(center[0], half_extents[0], turn[0]) : { sphere: { center: center[0], radius: radius ?? 0 } };
  return { frustum: frustum(position, axes[0], sideways, apex, far), volume: body };
}

/** Uniform numbers in [0, 1), those of the program for a seed. */
function* uniform(seed) {
  const mask = (1n << 64n) - 1n;
  for (let state = BigInt(seed);;) {
    state = (state + 0x9e3779b97f4a7c15n) & mask;
    let z = ((state ^ (state >> 30n)) * 0xbf58476d1ce4e5b9n) & mask;
    z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & mask;
    yield Number((z ^ (z >> 31n)) >> 11n) * 2 ** -53;
  }
}

/** The boxes of [field] and its camera's frustum. */
export function field({ objects, reach = 50, height = 20, size = [0.2, 0.8], camera, aim, tangents = [0.75, 0.5], near = 1, far = 50 }, seed) {
  const random = uniform(seed), between = (low, high) => low + (high - low) * random.next().value;
  const low = [-reach, 0, -reach], high = [reach, height, reach];
  const boxes = Array.from({ length: objects }, () => {
    const sides = [0, 1, 2].map((axis) => [between(low[axis], high[axis]), between(...size)]);
    return { aabb: { min: sides.map(([center, half]) => center - half), max: sides.map(([center, half]) => center + half) } };
  });
  const unit = (v) => v.map((x) => x / Math.hypot(...v));
  const back = unit(plus(camera, aim, -1)), right = unit([back[2], 0, -back[0]]);
  const up = [0, 1, 2].map((i) => back[(i + 1) % 3] * right[(i + 2) % 3] - back[(i + 2) % 3] * right[(i + 1) % 3]);
  return { boxes, frustum: frustum(camera, minus(back), [[right, tangents[0]], [up, tangents[1]]], near, far) };
}

/** The boxes of [objects]. */
export const objects = ({ center, half_extents }) => center.map((at, i) => {
  const half = half_extents[half_extents.length === 1 ? 0 : i];
  return { aabb: { min: plus(at, half, -1), max: plus(at, half) } };
});

/** The frustum of a query from Q to R. */
export function query_frustum({ from, to }) {
  const way = plus(to, from, -1), far = Math.hypot(...way), ahead = way.map((x) => x / far);
  return frustum(from, ahead, [[[ahead[1], -ahead[0]], 0.5]], 0.1 * far, far);
}
