// Every tolerance of the core, each relative to the size of its input, with the reason for its number.
#pragma once

#include <algorithm>
#include <limits>

namespace snug::tolerance {

/// The unit roundoff u: the largest relative error of one rounded operation.
template <class Scalar>
inline constexpr Scalar kRoundoff = std::numeric_limits<Scalar>::epsilon() / 2;

/// What one rounding costs a result of that size: u of it, but among the subnormal numbers no less than one step.
/// Tested by "subnormal points have a smallest ball too".
template <class Scalar>
[[nodiscard]] constexpr double roundoff(double size) {
  return std::max(static_cast<double>(kRoundoff<Scalar>) * size,
                  static_cast<double>(std::numeric_limits<Scalar>::denorm_min()));
}

/// A squared distance |p - c|^2 in 3-D carries at most: one rounding per difference (2u once squared), one per square,
/// two for the sum, so 5u; its square root half of that and u/2 more. 8u covers all of it with room for the terms in
/// u^2. Tested by "a computed squared distance stays within its bound".
template <class Scalar>
inline constexpr Scalar kSquaredDistance = 8 * kRoundoff<Scalar>;

/// A computed squared distance D (1 + 5u) and the square R (1 + 3u) of a sum of two radii: where they differ by more
/// than 9u of the latter, so do D and R. 12u leaves room for the rounding of the difference and of this bound. Tested
/// by "sphere against sphere and box, as rational arithmetic has it".
template <class Scalar>
inline constexpr Scalar kSquaresCompared = 12 * kRoundoff<Scalar>;

/// The least difference between a squared distance d^2 and the squared sum r^2 of the radii at which the filter decides
/// a pair, in units of the sum Q of d^2, r^2 and all squared edges or half extents (at most four). Let L be d + r plus
/// twice the edges: no length in the test is larger, and L^2 <= 18 Q. So d differs from r by more than k Q / (d + r) >=
/// k L / 36. Rounding takes 20u of L, and the whole test calls volumes touching that are up to 64u of L apart; k =
/// 4096u makes 113u of L. Tested by "the filter's verdict is that of the whole test".
template <class Scalar>
inline constexpr Scalar kDistanceFilter = 4096 * kRoundoff<Scalar>;

/// The error of |p - c|^2 - r^2 in twice the digits, relative to r^2, with |p - c| near the radius r: the differences,
/// r^2 and each sum are exact except for what is summed separately, and there each of twelve roundings is at most 2^-53
/// of 2^-49; the square of a difference's last digits, which is left out, is 2^-106. 2^-98 leaves room for all of them.
/// Tested by "the side of a sphere is what rational arithmetic says, in the last of 106 bits".
inline constexpr double kWideSquaredDistance = 0x1p-98;

/// A square between this and its inverse keeps those digits: 2^-98 of it is far above the least double.
inline constexpr double kSoundWideSquare = 0x1p-900;

/// A pivot of the support's Gram matrix, scaled to a largest entry near 1 and solved in about 106 bits (relative error
/// 2^-104), below which its points count as affinely dependent: half of those digits are then gone, but the centre
/// still keeps all of double's. Tested by "support points 1e-10 apart".
inline constexpr double kDependentPivot = 0x1p-90;

/// A barycentric coordinate of a ball's centre above this is certainly positive, and a point whose distance from the
/// centre is less than the radius by this share of it is certainly inside: at kDependentPivot the coordinates are off
/// by 2^-14. Tested by "the first sure ball of a few points is the largest of all subsets'".
inline constexpr double kBeyondDoubt = 0x1p-10;

/// How far a proven lower bound may stay below the radius for the ball to be called the smallest, in units of u *
/// (radius + largest coordinate): the centre is rounded once per coordinate (sqrt(3) u of its size), the radius grows
/// by as much again, and the distances by kSquaredDistance / 2. Tested by "certificates of far and tiny balls".
inline constexpr double kOptimalityRoundoffs = 16;

/// The same, for a support point to count as lying on the boundary.
inline constexpr double kBoundaryRoundoffs = 16;

/// A point outside a ball by more than this share of the radius is seen outside, so no rounding of far coordinates
/// excuses it. Tested by "a point that is seen outside is counted, however much rounding would excuse".
inline constexpr double kSeenOutside = 0x1p-5;

/// A projection (p - c) . u carries one rounding per difference, one per product and two for the sum: 4u of the sum of
/// the terms' sizes. 6u leaves room for the rounding of that sum and of what it is compared with. Tested by "a box
/// holds a point just where its slabs do in rational arithmetic".
inline constexpr double kProjection = 6 * kRoundoff<double>;

/// Below this sum of such terms, the underflow of a product, at most 2^-1075, could matter beside u of it.
inline constexpr double kSoundProjection = 0x1p-960;

/// The distance from a point to a place s e + t f on a parallelogram carries at most 4u of the sizes of point, e and f
/// from the place, and 3u from the norm: 7u. The same place seen along a direction carries 6u. 10u leaves room for the
/// rounding of the sizes. Tested by "a capsule and a lozenge hold a point just where rational arithmetic says".
inline constexpr double kSweptDistance = 10 * kRoundoff<double>;

/// A rotation matrix from geometry/turn.hpp or pose.hpp, or the same rounded to Scalar, lengthens a vector by at most
/// this part of its length: the quaternion's length is off by 2u, and computing each entry adds 4u. Tested by "a
/// rotation matrix, and the same rounded to float, lengthens nothing by more than its tolerance says".
template <class Scalar>
inline constexpr Scalar kRotation = 16 * kRoundoff<Scalar>;

/// How far a corner of a k-DOP, worked out from its slabs, may miss one of them, in parts of the largest bound: each
/// bound is rounded once when it is moved to the origin, a point of two planes has five operations a coordinate, and
/// its projection onto a third axis three. Tested by "a k-DOP's corners lie in all of its slabs".
template <class Scalar>
inline constexpr Scalar kKdopCorner = 16 * kRoundoff<Scalar>;

/// The gap, in parts of the largest extent of two volumes about a common point, up to which they still count as
/// touching: corners are rounded by at most 5u of that size, their projections onto an axis and the axis's length by as
/// much again, half of that for each volume. Tested by "volumes put at a known gap are told apart from it on".
template <class Scalar>
inline constexpr Scalar kTouching = 16 * kRoundoff<Scalar>;

/// Edges shorter than this part of all that they are compared with are points: their squares would soon lose digits,
/// and leaving them out costs less than a rounding. Tested by "tiny segments and rectangles have the exact distance".
template <class Scalar>
inline constexpr Scalar kVanishing = kRoundoff<Scalar>* kRoundoff<Scalar>;

/// The errors of a sum of products of rounded differences, in units of the sum of the products' sizes: u for each
/// difference, product and sum that a term passes through (two products 3u, three in a dot product 5u, the six triple
/// products of a determinant 7u, and terms in u^2). Tested by "signs are those of rational arithmetic, near zero too".
inline constexpr double kTwoProducts = 4 * kRoundoff<double>;
inline constexpr double kThreeProducts = 6 * kRoundoff<double>;
inline constexpr double kSixTripleProducts = 8 * kRoundoff<double>;

/// What underflow of such products, 2^-1075 each, can take from the sum: up to 32 of them.
inline constexpr double kLostToUnderflow = 0x1p-1070;

/// How far below the greatest rounded projection onto an axis the rounded projection of the truly farthest point may
/// be, in parts of the points' size: each of the two carries kProjection of at most sqrt(3) of the size, and the centre
/// that they are compared with adds as much as one of them. Tested by "a box on given axes holds every point exactly".
inline constexpr double kExtremeProjection = 32 * kRoundoff<double>;

/// A projection in about 106 bits, of coordinates scaled to 4 or below, carries at most 2^-99: with this error bound,
/// the verdict is certain. Tested by the same.
inline constexpr double kWideProjection = 0x1p-96;

/// The sine of the angle below which a direction is too nearly parallel to a first one to give a second axis: what is
/// left of its unit vector across the first is then mostly that vector's own rounding. Tested by "axes from any two
/// directions".
inline constexpr double kParallel = 0x1p-44;

/// The thickness, in parts of the points' size, up to which a box counts as flat when boxes are compared: less is
/// rounding of their axes. Tested by "among flat boxes the smaller area is better".
inline constexpr double kFlatBox = 16 * kRoundoff<double>;

/// On which side of a facet's plane a point lies, in coordinates within [-1, 1] that are each off by u: with e and f
/// two edges of the facet and |.| their largest coordinate, the determinant carries 24u (|e| + |f|) + 12u |e||f| from
/// these, 8u |e||f| in each of the normal's coordinates, which a point at a distance of up to 2 makes 48u, and 48u
/// |e||f| from the two dot products. As |e||f| <= |e| + |f|, 132u of that sum covers all of these, and 160u terms in
/// u^2 and the error bound's own rounding as well. Times |e| + |f| + u, since edges may vanish but for their rounding.
/// Tested by "near-flat clouds keep just their extreme points".
inline constexpr double kFacetPlane = 160 * kRoundoff<double>;

/// How far the axes of a box may be from unit and perpendicular: each of their dot products is off by no more. A
/// rotation matrix from a quaternion within 2u of unit, its entries within 4u, keeps 22u; what is normalized directly,
/// less.
template <class Scalar>
inline constexpr Scalar kObbAxes = 24 * kRoundoff<Scalar>;

/// The sine of the angle between two edges up to which they count as parallel: twice 8u by which each direction may be
/// rounded, and as much again for directions that were worked out on different ways.
template <class Scalar>
inline constexpr Scalar kParallelAxes = 32 * kRoundoff<Scalar>;

/// The error bound of a gap in the separating-axis test, times the axis's length, in units of the distance of the
/// centres and all half extents. With axes off by kObbAxes a frame is off by up to 36u from a true one; that enters an
/// edge-edge axis and either side of each of its products: 160u with 4u for each rounded dot product. True normals and
/// the table's differ by up to 36u more. Parallel edges, left out, are up to 48u from truly so, which twice could widen
/// the gap along another axis by 96u. Tested by "the verdict is that of exact arithmetic".
template <class Scalar>
inline constexpr Scalar kSatGap = 320 * kRoundoff<Scalar>;

/// How many times the error bound kSatGap two boxes must penetrate each other along all axes but those of parallel
/// edges to overlap, where edges i of A and j of B count as parallel if the other two entries of column j of R,
/// rounded, sum up to no more than kParallelAxes. The proof: those entries are dot products, each off by 4u of
/// rounding, and A's axes are perpendicular within 24u; so the sine of the angle is at most 32u + 8u + 24 sqrt(2) u <
/// 74u. Replace each such edge direction of B by the parallel one of A, which moves it by at most 74u. Then its axis
/// vanishes, and the boxes overlap if they do along the others. These axes turn by at most 148u, where both edges of a
/// face of B are replaced, and each edge's own direction by 74u, so that no gap grows by more than 222u of the size;
/// back in B's place, its points move by at most 74u of its extents. So 296u of penetration beyond the error of 320u
/// are enough: twice kSatGap. Tested by "boxes with parallel edges are decided by the filter, and rightly".
template <class Scalar>
inline constexpr Scalar kSatParallelDepth = 2;

/// As kSatGap for the true normals in double, whatever the axes: 4u for the cross product, 8u for the distance, 10u for
/// the radii.
inline constexpr double kSatInDouble = 16 * kRoundoff<double>;

/// A sum of up to three coordinates carries 5u of the largest, and 3u more once a bound is moved by that error bound.
/// Tested by "a k-DOP's bounds are the exact projections, rounded outwards".
template <class Scalar>
inline constexpr Scalar kKdopProjection = 10 * kRoundoff<Scalar>;

/// How far from a swept sphere's boundary a point that holds it in place may lie, in units of u * (largest coordinate +
/// size): its coordinates along the principal axes carry 8u, the ends of the segment or rectangle set by them as much
/// when they are taken back, and the radius all of that. Tested by "capsules and lozenges keep their promises on
/// degenerate clouds".
inline constexpr double kSweptBoundaryRoundoffs = 64;

/// A coordinate in a frame of unit size is off by 8u. Less than twice that is no reason to move a lozenge's corner: its
/// radius is widened for it in the end. Tested by "a lozenge in the plane moves no corner".
template <class Scalar>
inline constexpr Scalar kLocalCoordinate = 16 * kRoundoff<Scalar>;

/// A box stops shrinking once it is smaller than the one before by less than this part. Around some points (a
/// tetrahedron's) the k-th rectangle gains a part of about 3 / k^2, so that millions would gain more than rounding;
/// this ends it after about 440, and fit::kMostRectangles ends it in any case. Tested by "rectangles that shrink a box
/// by less and less come to an end".
inline constexpr double kSameBox = 0x1p-16;

/// A turned coordinate is a sum of three products, of which each carries up to 3u: 4u of the sum of their sizes with
/// room for terms in u^2. Walks uphill (fit/hull/hill_climb.hpp) compare it with an error bound of twice that, and 2u
/// more for the error bound's own rounding. Tested by "hill climbing gives the box that rebuilding gives, bit for bit".
template <class Scalar>
inline constexpr Scalar kClimb = 10 * kRoundoff<Scalar>;

/// The same for a placed point's projection onto an axis of a k-DOP: 4u and one more rounding for each coordinate, 2u
/// for the bound's rounding outwards, so 7u; twice that and 4u more.
template <class Scalar>
inline constexpr Scalar kClimbKdop = 18 * kRoundoff<Scalar>;

/// How much longer than a point's distance a turned coordinate may be: kRotation, three roundings and one of the reach.
/// Tested by "every update holds every placed point exactly, over full turns".
template <class Scalar>
inline constexpr Scalar kLooseReach = kRotation<Scalar> + 8 * kRoundoff<Scalar>;

/// Two placed points, each off by (3 sqrt(3) + 1) u of its distance from the origin and u of the translation, are apart
/// by what they were before but for 7u of the volume's size, 13u of its centre's distance from the origin and 3u of the
/// translation; a rotation that lengthens by kRotation adds 16u of the size. 32u of the sum of the three covers it, and
/// the roundings of that sum. Tested by the same.
template <class Scalar>
inline constexpr Scalar kPlaced = 32 * kRoundoff<Scalar>;

/// How far an axis a' of an updated box, seen from the body, may lie from the axis a that it was: |R^T a' - a|. The
/// rotation and the box's axes are off by kRotation and kObbAxes, the product by 6u, and making it straight again moves
/// an axis by as much as all of these together; R^T R is off by twice kRotation once more. Tested by "every update
/// holds every placed point exactly, over full turns".
template <class Scalar>
inline constexpr Scalar kTurnedBox = 160 * kRoundoff<Scalar>;

/// The sine of a triangle's angle below which its normal, worked out in about 106 bits, might not have all of a
/// double's digits, and is worked out exactly. Tested by "the normals of thin triangles keep their digits".
inline constexpr double kThinTriangle = 0x1p-40;

/// How much shorter than measured the smallest box's lengths may be, in parts of the points' size, for it to be called
/// smallest: its axes are off by up to 8u, each length by that and by 4u of projecting, the comparison of its volume
/// with a bound by 24u of each length; and where stretches of a search end at kSameTurn, by 16u more. Tested by "the
/// smallest box is proven so".
inline constexpr double kBoxProof = 64 * kRoundoff<double>;

/// The turn of a box's two axes together, in radians, up to which a stretch of boxes counts as one. Tested by the same.
inline constexpr double kSameTurn = 16 * kRoundoff<double>;

/// How far from a box's face a point that holds it may lie, in units of u * (largest coordinate): the centre is
/// rounded, which moves it sqrt(3)u, and was set by projections that carry 16u; as seen again they carry as much. A
/// length measured for the proof that the box is smallest may be off by twice that. Tested by "box fitters keep their
/// promises".
inline constexpr double kBoxBoundaryRoundoffs = 64;

/// How much a length of a fitted volume may be off, in parts of the points' size plus their farthest coordinate: of a
/// smallest box by kBoxProof, of which 16u are the projections' and 8u the axes'; where a centre or bound is rounded,
/// in a ball as in a slab, by kBoundaryRoundoffs or less. A product of lengths is then off by that times the other
/// lengths, once for each. Tested by "no volume is told to be smaller than the smallest, and what is flat is compared
/// with nothing".
template <class Scalar>
inline constexpr double kVolumeLength = 64 * static_cast<double>(kRoundoff<Scalar>);

/// How many times larger than what rounding may make of it a smallest size must be for others to be compared with it:
/// their ratio is then off by a sixteenth at most, and mostly by far less. Less is called flat. Tested by the same.
inline constexpr double kKnownSize = 16;

/// The error that is allowed in a box's axes and a lozenge's edges as people and programs write them down: each dot
/// product of unit axes is off by no more. Eight times the error of entries rounded to float or to seven digits; a
/// mistake made by hand is larger.
inline constexpr double kAxesAsGiven = 0x1p-20;

/// The same for axes written with four digits, which are taken with a warning: each entry is off by 5e-5, and so a dot
/// product of two rows by 2 sqrt(3) times that.
inline constexpr double kAxesRough = 0x1p-12;

/// The sine of the angle to a direction up to which a face counts as lying along it: far above the rounding of its
/// normal, so that an outline never breaks off, and small enough to take in no more than a few vertices too many.
/// Tested by "an outline is that of all points".
inline constexpr double kOnOutline = 0x1p-40;

/// How far normal . p + d, over the points of a volume, may be from rounded, in units of the sum of the normal's sizes
/// times the volume's size (plane_reach.hpp) plus |d|: an OBB's normal carries 3u in the box's frame, its radius 4u
/// more; the centre's value 4u; their difference u. Axes a tenth too long and the rounding of size and error bound: 16u
/// cover 12u of them. A sphere's radius carries 5u; a k-DOP's weights 2u, the sums of their products 3u, the division
/// u. Tested by "a million grazing boxes and spheres are classified as exact arithmetic does" and "the rounded reach
/// stays within its error bound".
template <class Scalar>
inline constexpr Scalar kPlaneReach = 16 * kRoundoff<Scalar>;

/// The same for planes that were made unit first: each of their numbers is off by 4u more (the length 3u, the division
/// u), in units of twice the largest coordinate, which the three of a unit normal come to at most, plus |d|. Tested by
/// "boxes and spheres at once have the verdicts that they have one by one".
template <class Scalar>
inline constexpr Scalar kUnitPlaneReach = kPlaneReach<Scalar> + 8 * kRoundoff<Scalar>;

/// The error bound of a gap between a frustum and a box along an axis, in units of the axis's size (the sum of the
/// products that it is made of) times the largest coordinate of both: corners carry 8u, an edge-edge axis 8u of its
/// size in each coordinate, the projections 4u each and the radius 8u, in three coordinates, on both sides. Tested by
/// "the exact test of frustum and box is that of linear programming".
inline constexpr double kFrustumGap = 256 * kRoundoff<double>;

/// A lozenge's corner, the sum of its origin and edges, is off by at most 2u of their coordinates' sum; as much again
/// for the sum's own rounding. Tested by "the merged volume holds both".
inline constexpr double kLozengeCorner = 4 * kRoundoff<double>;

/// How far along an axis a box reaches from a point, in units of its half extents and its centre's coordinates from
/// there, all summed, worked out in double: each entry of the axes' inverse carries 3u of a cofactor, 6u of the
/// determinant and 3u of dividing, which three of them in a product make 21u, and 8u for it and the sum of extents; the
/// centre's distance along the axis 4u, the last sums 3u of all; a direction that is itself a row of such an inverse,
/// off by 12u in each entry, as much again, 21u of the extents and of the distance. 64u leaves room for terms in u^2.
/// Tested by the same.
inline constexpr double kMergedBox = 64 * kRoundoff<double>;

/// Where a ray meets a plane across an axis: u for the difference, u for the quotient, each way, which makes 4u between
/// where it enters one slab and leaves another; and as much again for terms in u^2 and the bound's own rounding. Tested
/// by "a ray never misses a box that it touches".
template <class Scalar>
inline constexpr Scalar kRaySlab = 8 * kRoundoff<Scalar>;

}  // namespace snug::tolerance
