// Tests of two volumes as textbooks print them, on structs as they print them: the units in which ours are measured.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2 to 5.2 for the methods; k-DOPs as in K. Erleben's
// lecture on bounding volumes.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/frustum.hpp"
#include "geometry/volume.hpp"

namespace snug::bench {

template <class Scalar>
struct PlainSphere {
  Scalar c[3], r;
  explicit PlainSphere(const Sphere<Scalar, 3>& s) : c{s.center[0], s.center[1], s.center[2]}, r(s.radius) {}
};
template <class Scalar>
struct PlainAabb {
  Scalar min[3], max[3];
  explicit PlainAabb(const Aabb<Scalar, 3>& box)
      : min{box.min[0], box.min[1], box.min[2]}, max{box.max[0], box.max[1], box.max[2]} {}
};
template <class Scalar>
struct PlainObb {
  Scalar c[3], u[3][3], e[3];
  explicit PlainObb(const Obb<Scalar, 3>& box) {
    for (int k = 0; k < 3; ++k) {
      c[k] = box.center[k], e[k] = box.half_extents[k];
      for (int m = 0; m < 3; ++m) u[k][m] = box.axes(m, k);
    }
  }
};
template <class Scalar>
struct PlainCapsule {
  Scalar a[3], b[3], r;
  explicit PlainCapsule(const Capsule<Scalar, 3>& capsule)
      : a{capsule.a[0], capsule.a[1], capsule.a[2]}, b{capsule.b[0], capsule.b[1], capsule.b[2]}, r(capsule.radius) {}
};
template <class Scalar>
struct PlainLozenge {
  Scalar a[3], e0[3], e1[3], r;
  explicit PlainLozenge(const Lozenge<Scalar, 3>& lozenge) : r(lozenge.radius) {
    for (int i = 0; i < 3; ++i) a[i] = lozenge.origin[i], e0[i] = lozenge.edges[0][i], e1[i] = lozenge.edges[1][i];
  }
};
template <class Scalar>
struct PlainDop14 {
  Scalar min[7], max[7];
  explicit PlainDop14(const Kdop<Scalar, 3>& kdop) {
    for (int i = 0; i < 7; ++i) min[i] = kdop.min[i], max[i] = kdop.max[i];
  }
};

template <class Scalar>
Scalar dot(const Scalar (&a)[3], const Scalar (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Scalar>
void subtract(const Scalar (&a)[3], const Scalar (&b)[3], Scalar (&d)[3]) {
  for (int i = 0; i < 3; ++i) d[i] = a[i] - b[i];
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainAabb<Scalar>& a, const PlainAabb<Scalar>& b) {
  if (a.max[0] < b.min[0] || a.min[0] > b.max[0]) return false;
  if (a.max[1] < b.min[1] || a.min[1] > b.max[1]) return false;
  if (a.max[2] < b.min[2] || a.min[2] > b.max[2]) return false;
  return true;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainSphere<Scalar>& a, const PlainSphere<Scalar>& b) {
  Scalar d[3];
  subtract(a.c, b.c, d);
  const Scalar radii = a.r + b.r;
  return dot(d, d) <= radii * radii;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainSphere<Scalar>& s, const PlainAabb<Scalar>& box) {
  Scalar square = 0;
  for (int i = 0; i < 3; ++i) {
    const Scalar v = s.c[i];
    if (v < box.min[i]) square += (box.min[i] - v) * (box.min[i] - v);
    if (v > box.max[i]) square += (v - box.max[i]) * (v - box.max[i]);
  }
  return square <= s.r * s.r;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainSphere<Scalar>& s, const PlainObb<Scalar>& box) {
  Scalar v[3], square = 0;
  subtract(s.c, box.c, v);
  for (int i = 0; i < 3; ++i) {
    const Scalar d = dot(v, box.u[i]);
    Scalar excess = 0;
    if (d < -box.e[i]) excess = d + box.e[i];
    else if (d > box.e[i]) excess = d - box.e[i];
    square += excess * excess;
  }
  return square <= s.r * s.r;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainSphere<Scalar>& s, const PlainCapsule<Scalar>& capsule) {
  Scalar ab[3], ac[3], bc[3];
  subtract(capsule.b, capsule.a, ab), subtract(s.c, capsule.a, ac), subtract(s.c, capsule.b, bc);
  const Scalar e = dot(ac, ab), radii = s.r + capsule.r;
  Scalar square;
  if (e <= 0) square = dot(ac, ac);
  else {
    const Scalar f = dot(ab, ab);
    square = e >= f ? dot(bc, bc) : dot(ac, ac) - e * e / f;
  }
  return square <= radii * radii;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainCapsule<Scalar>& p, const PlainCapsule<Scalar>& q) {
  constexpr Scalar kEpsilon = sizeof(Scalar) == 4 ? Scalar(1e-12) : Scalar(1e-24);
  Scalar d1[3], d2[3], r[3];
  subtract(p.b, p.a, d1), subtract(q.b, q.a, d2), subtract(p.a, q.a, r);
  const Scalar a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r);
  Scalar s, t;
  if (a <= kEpsilon && e <= kEpsilon) s = t = 0;
  else if (a <= kEpsilon) s = 0, t = std::clamp(f / e, Scalar(0), Scalar(1));
  else {
    const Scalar c = dot(d1, r);
    if (e <= kEpsilon) t = 0, s = std::clamp(-c / a, Scalar(0), Scalar(1));
    else {
      const Scalar b = dot(d1, d2), denominator = a * e - b * b;
      s = denominator != 0 ? std::clamp((b * f - c * e) / denominator, Scalar(0), Scalar(1)) : Scalar(0);
      t = (b * s + f) / e;
      if (t < 0) t = 0, s = std::clamp(-c / a, Scalar(0), Scalar(1));
      else if (t > 1) t = 1, s = std::clamp((b - c) / a, Scalar(0), Scalar(1));
    }
  }
  Scalar square = 0;
  for (int i = 0; i < 3; ++i) {
    const Scalar d = (p.a[i] + d1[i] * s) - (q.a[i] + d2[i] * t);
    square += d * d;
  }
  const Scalar radii = p.r + q.r;
  return square <= radii * radii;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainSphere<Scalar>& s, const PlainLozenge<Scalar>& lozenge) {
  Scalar d[3], q[3] = {lozenge.a[0], lozenge.a[1], lozenge.a[2]};
  subtract(s.c, lozenge.a, d);
  for (const auto* edge : {&lozenge.e0, &lozenge.e1}) {
    const Scalar along = dot(d, *edge), square = dot(*edge, *edge);
    const Scalar t = along <= 0 ? Scalar(0) : along >= square ? Scalar(1) : along / square;
    for (int i = 0; i < 3; ++i) q[i] += t * (*edge)[i];
  }
  subtract(s.c, q, d);
  const Scalar radii = s.r + lozenge.r;
  return dot(d, d) <= radii * radii;
}

template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainDop14<Scalar>& a, const PlainDop14<Scalar>& b) {
  for (int i = 0; i < 7; ++i)
    if (a.min[i] > b.max[i] || a.max[i] < b.min[i]) return false;
  return true;
}

/// The fifteen axes written out, with an epsilon against parallel edges, face axes first.
template <class Scalar>
[[gnu::flatten]] bool plain_overlap(const PlainObb<Scalar>& a, const PlainObb<Scalar>& b) {
  constexpr Scalar kEpsilon = sizeof(Scalar) == 4 ? Scalar(1e-6) : Scalar(1e-14);
  Scalar r[3][3], s[3][3], t[3], d[3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = dot(a.u[i], b.u[j]);
  subtract(b.c, a.c, d);
  for (int i = 0; i < 3; ++i) t[i] = dot(d, a.u[i]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) s[i][j] = std::abs(r[i][j]) + kEpsilon;
  for (int i = 0; i < 3; ++i)
    if (std::abs(t[i]) > a.e[i] + dot(b.e, s[i])) return false;
  for (int j = 0; j < 3; ++j)
    if (std::abs(t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j]) >
        (a.e[0] * s[0][j] + a.e[1] * s[1][j] + a.e[2] * s[2][j]) + b.e[j])
      return false;
  const auto crossed = [&](int i, int i1, int i2, int j, int j1, int j2) {
    return std::abs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) >
           (a.e[i1] * s[i2][j] + a.e[i2] * s[i1][j]) + (b.e[j1] * s[i][j2] + b.e[j2] * s[i][j1]);
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (crossed(i, (i + 1) % 3, (i + 2) % 3, j, (j + 1) % 3, (j + 2) % 3)) return false;
  return true;
}

/// Unit normals that point out, as a camera's planes are kept; 0 inside, 1 intersecting, 2 outside.
template <class Scalar>
struct PlainFrustum {
  Scalar n[6][3], d[6];
  explicit PlainFrustum(const Frustum<Scalar, 3>& frustum) {
    for (int at = 0; at < 6; ++at) {
      const Scalar length = frustum[at].normal.norm();
      for (int i = 0; i < 3; ++i) n[at][i] = frustum[at].normal[i] / length;
      d[at] = frustum[at].d / length;
    }
  }
};

template <class Scalar>
[[gnu::flatten]] int plain_cull(const PlainFrustum<Scalar>& frustum, const PlainSphere<Scalar>& sphere) {
  int verdict = 0;
  for (int at = 0; at < 6; ++at) {
    const Scalar distance = dot(frustum.n[at], sphere.c) + frustum.d[at];
    if (distance > sphere.r) return 2;
    if (distance > -sphere.r) verdict = 1;
  }
  return verdict;
}

template <class Scalar>
[[gnu::flatten]] int plain_cull(const PlainFrustum<Scalar>& frustum, const PlainAabb<Scalar>& box) {
  int verdict = 0;
  for (int at = 0; at < 6; ++at) {
    Scalar p[3], n[3];
    for (int i = 0; i < 3; ++i) {
      const bool positive = frustum.n[at][i] >= 0;
      p[i] = positive ? box.max[i] : box.min[i];
      n[i] = positive ? box.min[i] : box.max[i];
    }
    if (dot(frustum.n[at], n) + frustum.d[at] > 0) return 2;
    if (dot(frustum.n[at], p) + frustum.d[at] > 0) verdict = 1;
  }
  return verdict;
}

/// A rotation and a translation, as they move a volume: the textbook's updates.
template <class Scalar>
struct PlainPose {
  Scalar r[3][3], t[3];
  explicit PlainPose(const Pose<Scalar, 3>& pose) {
    for (int i = 0; i < 3; ++i) {
      t[i] = pose.translation[i];
      for (int j = 0; j < 3; ++j) r[i][j] = pose.rotation(i, j);
    }
  }
};

template <class Scalar>
[[gnu::flatten]] void plain_update(const PlainSphere<Scalar>& sphere, const PlainPose<Scalar>& pose,
                                   PlainSphere<Scalar>& moved) {
  for (int i = 0; i < 3; ++i) moved.c[i] = dot(pose.r[i], sphere.c) + pose.t[i];
  moved.r = sphere.r;
}

/// One matrix product; the axes are rows here.
template <class Scalar>
[[gnu::flatten]] void plain_update(const PlainObb<Scalar>& box, const PlainPose<Scalar>& pose,
                                   PlainObb<Scalar>& moved) {
  for (int i = 0; i < 3; ++i) {
    moved.c[i] = dot(pose.r[i], box.c) + pose.t[i];
    for (int k = 0; k < 3; ++k) moved.u[k][i] = dot(pose.r[i], box.u[k]);
    moved.e[i] = box.e[i];
  }
}

/// A box by centre and half extents: |R| h.
template <class Scalar>
struct PlainExtents {
  Scalar c[3], h[3];
  explicit PlainExtents(const Aabb<Scalar, 3>& box) {
    for (int i = 0; i < 3; ++i) c[i] = (box.min[i] + box.max[i]) / 2, h[i] = (box.max[i] - box.min[i]) / 2;
  }
};
template <class Scalar>
[[gnu::flatten]] void plain_update(const PlainExtents<Scalar>& box, const PlainPose<Scalar>& pose,
                                   PlainExtents<Scalar>& moved) {
  for (int i = 0; i < 3; ++i) {
    moved.c[i] = dot(pose.r[i], box.c) + pose.t[i];
    moved.h[i] =
        std::abs(pose.r[i][0]) * box.h[0] + std::abs(pose.r[i][1]) * box.h[1] + std::abs(pose.r[i][2]) * box.h[2];
  }
}

}  // namespace snug::bench
