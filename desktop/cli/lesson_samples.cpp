#include "desktop/cli/lesson_samples.hpp"

namespace snug::desktop {
namespace {

constexpr std::string_view kPlane = R"([points]
list = [[-2, 0], [2, 0.3], [0.1, 1], [0, -1], [0.5, 2.5], [0.7, 0.2]]
)";
constexpr std::string_view kLoaded = R"([points]
list = [[-2, 0], [2, 0.3], [0.1, 1], [0, -1], [0.5, 2.5], [0.7, 0.2]]
[load]
)";
constexpr std::string_view kSpace = R"([points]
dim = 3
list = [[-2, 0, 0.2], [2, 0.3, 0], [0.1, 1, 1.5], [0, -1, -1.2], [0.5, 2.5, 0.4], [0.7, 0.2, 0.3]]
)";
constexpr std::string_view kBoxes = R"([boxes]
random_pairs = 10
center = [[-1, 0], [1, 0.3]]
half_extents = [[0.9, 0.4], [0.8, 0.5]]
turn = [[20], [-35]]
)";
constexpr std::string_view kBoxesInSpace = R"([boxes]
dim = 3
center = [[-1, 0, 0], [1, 0.3, 0.2]]
half_extents = [[0.9, 0.4, 0.5], [0.8, 0.5, 0.3]]
turn = [[20, 10, 0], [-35, 0, 15]]
)";
constexpr std::string_view kSpheres = R"([volumes]
a = { sphere = { center = [-1, 0], radius = 0.5 } }
b = { sphere = { center = [1, 0], radius = 0.5 } }
)";
constexpr std::string_view kUpright = R"([volumes]
a = { aabb = { min = [-1, 0], max = [0, 1] } }
b = { aabb = { min = [1, 0], max = [2, 1] } }
)";
constexpr std::string_view kSwept = R"([volumes]
dim = 3
a = { capsule = { a = [-2, 0, 0], b = [-1, 1, 0], radius = 0.3 } }
b = { lozenge = { origin = [0, 0, 0], edges = [[1, 0, 0], [0, 1, 0]], radius = 0.2 } }
)";
constexpr std::string_view kOriented = R"([volumes]
a = { obb = { center = [-1, 0], half_extents = [0.6, 0.4], turn = [20] } }
b = { obb = { center = [1, 0], half_extents = [0.6, 0.4], turn = [50] } }
)";
constexpr std::string_view kDops = R"([volumes]
a = { kdop = { k = 6, min = [-1, -1, -2], max = [0, 0, 0] } }
b = { kdop = { k = 8, min = [1, 0, 1, 0], max = [2, 1, 3, 2] } }
)";
constexpr std::string_view kHulls = R"([volumes]
a = { hull = { points = [[-2, 0], [-1, 0], [-1, 1]] } }
b = { hull = { points = [[0.5, -1], [2, 0], [0.8, 1.2]] } }
)";
constexpr std::string_view kBoxAndFrustum = R"([boxes]
taper = 0.3
center = [[0.4, 0.7], [0.6, 0]]
half_extents = [[0.5, 0.25], [1.1, 1.2]]
turn = [[-24], [0]]
)";
constexpr std::string_view kBoxAndFrustumInSpace = R"([boxes]
dim = 3
taper = 0.3
center = [[0.4, 0.7, 0.1], [0.6, 0, 0]]
half_extents = [[0.5, 0.25, 0.3], [1.1, 1.2, 0.8]]
turn = [[0, 0, -24], [0, 0, 0]]
)";
constexpr std::string_view kSphereAndFrustum = R"([boxes]
taper = 0.3
center = [[0.35, 0.95], [0.55, 0]]
radius = 0.3
half_extents = [[1.05, 1.15]]
turn = [[-4]]
)";
constexpr std::string_view kPointAndFrustum = R"([boxes]
taper = 0.3
center = [[0.35, 0.95], [0.55, 0]]
half_extents = [[1.05, 1.15]]
turn = [[-4]]
)";
constexpr std::string_view kField = R"([field]
objects = 64
camera = [-42, 12, 14]
aim = [0, 8, 0]
)";
constexpr std::string_view kObjects = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
)";
constexpr std::string_view kQueried = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
[query]
from = [-2.1, 0.9]
to = [1.3, -1]
)";
constexpr std::string_view kMovedObjects = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
built = [[-2, 0.8], [-1.2, -0.4], [0.6, 0.6], [-0.4, -0.7]]
)";
constexpr std::string_view kPile = R"([points]
dim = 3
list = [[0, 2, 0], [0.1, 3, 0], [0, 4, 0.1]]
[scene]
frames = 3
graph = true
[[scene.body]]
shape = "box"
at_points = true
[[scene.body]]
shape = "box"
name = "floor"
half_extents = [5, 0.5, 5]
fixed = true
[[scene.effect]]
effect = "fall"
[[scene.effect]]
effect = "refit"
[[scene.effect]]
effect = "broad_phase"
[[scene.effect]]
effect = "narrow_phase"
[[scene.effect]]
effect = "bounce"
)";
constexpr std::string_view kTurning = R"([points]
dim = 3
list = [[-2, 0, 0.2], [2, 0.3, 0], [0.1, 1, 1.5], [0, -1, -1.2], [0.5, 2.5, 0.4], [0.7, 0.2, 0.3]]
[scene]
frames = 3
[[scene.body]]
shape = "points"
[[scene.effect]]
effect = "spin"
axis = [1, 2, 3]
turns_per_second = 0.3
[[scene.effect]]
effect = "refit"
)";

constexpr std::string_view kOneOfEach =
    "\"sphere/welzl\", \"aabb/min_max\", \"obb/exact\", \"kdop/k8\", \"hull/quickhull\"";

constexpr LessonSample kSamples[] = {
    {"sphere", "", "", kPlane},
    {"sphere", "", "\"sphere/welzl\", \"aabb/min_max\"", kPlane},
    {"sphere", "", "\"welzl\", \"ritter\", \"pca\", \"aabb_center\", \"ritter_iterative\", \"pivot\", \"brute_force\"",
     kPlane},
    {"aabb", "", "", kPlane},
    {"aabb", "", "", kSpace},
    {"obb", "", "", kPlane},
    {"obb", "", "", kSpace},
    {"capsule", "", "", kPlane},
    {"lozenge", "", "", kPlane},
    {"lozenge", "", "", kSpace},
    {"kdop", "", "", kPlane},
    {"kdop", "", "", kSpace},
    {"hull", "", "\"quickhull\"", kPlane},
    {"hull", "", "", kPlane},
    {"hull", "", "", kSpace},
    {"box_pair", "", "", kBoxes},
    {"box_pair", "", "", kBoxesInSpace},
    {"volume_pair", "", "", kSpheres},
    {"volume_pair", "", "", kUpright},
    {"volume_pair", "", "", kSwept},
    {"volume_pair", "", "", kOriented},
    {"volume_pair", "", "", kDops},
    {"volume_pair", "", "", kHulls},
    {"frustum_box", "", "", kBoxAndFrustum},
    {"frustum_box", "", "", kBoxAndFrustumInSpace},
    {"frustum_sphere", "", "", kSphereAndFrustum},
    {"frustum_point", "", "", kPointAndFrustum},
    {"frustum_field", "", "", kField},
    {"bvh_build", "", "", kObjects},
    {"bvh_query", "", "", kQueried},
    {"bvh_update", "", "", kMovedObjects},
    {"scene", "", "\"sweep_and_prune\", \"tree\"", kPile},
    {"scene", "", "\"rebuild\", \"loose\", \"sphere\", \"k14\"", kTurning},
    {"update", "", "", kPlane},
    {"update", "", "", kSpace},
    {"sphere", "criteria", kOneOfEach, kLoaded},
    {"sphere", "claims", kOneOfEach, kPlane},
};

}  // namespace

std::span<const LessonSample> lesson_samples() { return kSamples; }

std::string lesson_of(const LessonSample& sample, std::string_view algorithms) {
  std::string text = "version = 2\ntitle = \"Sample\"\nsummary = \"Sample.\"\nminutes = 1\nvolume = \"";
  ((text += sample.volume) += "\"\nalgorithms = [") += algorithms;
  text += "]\n";
  if (!sample.chart.empty()) ((text += "chart = \"") += sample.chart) += "\"\n";
  return (text += sample.stage) += "\n[[section]]\ntitle = \"Sample\"\ntext = \"Sample.\"\n";
}

}  // namespace snug::desktop
