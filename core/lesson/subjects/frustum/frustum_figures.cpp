#include "lesson/subjects/frustum/frustum_figures.hpp"

#include <string>

#include "lesson/subjects/frustum/matrix_planes.hpp"

namespace snug::lesson {
namespace {

using query::Culling;
using Plane = query::PlaneTested<double, 3>;
using Corner = query::CornerTested<double, 3>;

std::string word(Culling culling) { return std::string(query::kCullingNames[static_cast<std::size_t>(culling)]); }

/// Collects the figures at one step of a run.
class FrustumBoard {
 public:
  FrustumBoard(const View& view, const BoxPair& pair)
      : view_(view), pair_(pair), steps_(frustum_run(view.run()).trace()), dim_(pair.dim) {
    for (int i = 0; i < view.step; ++i) std::visit(*this, steps_[i].step.fact);
  }

  std::vector<Figure> figures() && {
    const bool matrix = is_of_matrix(view_.method().name);
    const bool by_planes = matrix || view_.method().name == "p_n_vertex",
               by_center = view_.method().volume != kFrustumBox;
    const int plane = plane_at(steps_.first(view_.step));
    const bool any = plane >= 0, normal = any && !frustum_run(view_.run()).has_no_normal(plane);
    add("Plane", "plane", any ? plane_name(dim_, plane) : "", plane, "");
    if (by_planes) {
      add("Signs of the normal", "signs", normal ? sign_name(dim_, tested_.signs) : "", tested_.signs, "");
      length("p-vertex" + (normal ? name_of(tested_.p_vertex) : ""), "p_distance", tested_.p_distance, normal);
      length("n-vertex" + (normal ? name_of(tested_.n_vertex) : ""), "n_distance", tested_.n_distance, normal);
      add("Planes tested", "planes_tested", std::to_string(planes_) + " of " + std::to_string(planes_of_frustum(dim_)),
          planes_, "planes");
    } else if (by_center) {
      const double radius = (tested_.p_distance - tested_.n_distance) / 2;
      const bool point = view_.method().volume == kFrustumPoint;
      length(point ? "n · p + d" : "n · c + d", "distance", tested_.n_distance + radius, any);
      if (!point) add("Radius", "radius", any ? number_text(radius) + " units" : "", radius, "units");
      add("Planes tested", "planes_tested", std::to_string(planes_) + " of " + std::to_string(planes_of_frustum(dim_)),
          planes_, "planes");
    } else {
      const bool known = any && !done_;
      length(known ? "Vertex" + name_of(corner_.corner) : "Vertex", "distance", corner_.distance, known);
    }
    const auto looked = view_.step > 0 ? steps_[view_.step - 1].counts[kTests] : 0;
    if (!by_center) add("Vertex tests", "corners", std::to_string(looked), static_cast<double>(looked), "");
    add(done_ ? "Verdict" : "Verdict so far", "verdict",
        view_.step > 0 && (done_ || by_planes || by_center) ? word(verdict_) : "", static_cast<double>(verdict_), "");
    figures_.back().names = query::kCullingNames;
    if (matrix) far_plane();
    return std::move(figures_);
  }

  void operator()(const Plane& fact) {
    tested_ = fact;
    verdict_ = fact.so_far;
    ++planes_;
  }
  void operator()(const Corner& fact) { corner_ = fact; }
  void operator()(const query::Classified& fact) {
    verdict_ = fact.result.verdict;
    done_ = true;
  }
  void operator()(const auto&) {}

 private:
  static constexpr auto kTests = static_cast<std::size_t>(Operation::kOrientationTests);

  [[nodiscard]] std::string name_of(int corner) const { return " " + sign_name(dim_, corner); }

  /// Adds a figure; an empty text means that there is no value yet.
  void add(std::string name, std::string key, std::string text, double value, std::string unit) {
    const bool known = !text.empty();
    figures_.push_back({std::move(name), std::move(key), known ? std::move(text) : "—", value, std::move(unit), known});
  }
  /// Adds a signed distance, above 0 outside.
  void length(std::string name, std::string key, double value, bool known) {
    add(std::move(name), std::move(key), known ? (value > 0 ? "+" : "") + number_text(value) + " units" : "", value,
        "units");
    figures_.back().of_step = true;
  }

  /// Once it was tested: before, the figures would give away which plane is off.
  void far_plane() {
    if (!done_ && tested_.plane != planes_of_frustum(dim_) - 1) return;
    const FarPlane far = far_plane_of(view_.method().name, pair_);
    const std::string off = far.lost ? "no normal left" : (far.off > 0 ? "+" : "") + number_text(far.off, 3) + " %";
    add("Far plane, off by", "far_off", off, far.off, "%");
    figures_.back().known = !far.lost;
    if (!far.lost) add("Far plane, tilted by", "far_tilt", number_text(far.degrees, 3) + "°", far.degrees, "degrees");
  }

  const View& view_;
  const BoxPair& pair_;
  FrustumSteps steps_;
  int dim_;
  Plane tested_;
  Corner corner_;
  int planes_ = 0;
  Culling verdict_ = Culling::kInside;
  bool done_ = false;
  std::vector<Figure> figures_;
};

}  // namespace

int plane_at(FrustumSteps steps) {
  if (steps.empty()) return -1;
  const auto& fact = steps.back().step.fact;
  if (const auto* tested = std::get_if<Plane>(&fact)) return tested->plane;
  if (const auto* corner = std::get_if<Corner>(&fact)) return corner->plane;
  const auto* end = std::get_if<query::Classified>(&fact);
  return end != nullptr ? end->result.rejected_by : -1;
}

std::vector<Figure> frustum_figures(const View& view, const BoxPair& pair) {
  return FrustumBoard(view, pair).figures();
}

std::vector<Proof> frustum_proofs(const View& view, const BoxPair& pair) {
  const FrustumSteps steps = frustum_run(view.run()).trace();
  if (!view.at_end() || steps.empty()) return {};
  const auto* end = std::get_if<query::Classified>(&steps.back().step.fact);
  const auto shares = share_a_point(pair);
  if (end == nullptr || !shares) return {};
  const Culling says = end->result.verdict;
  const std::string body = body_word(pair), both = body + " and frustum share ";
  const bool box = pair.form == Form::kBox;
  std::vector<Proof> proofs{{"this test says: " + word(says), true, true}};
  if (says == Culling::kOutside && *shares)
    proofs.push_back({"wrong: " + both + (box ? "points, since no axis separates them" : "points"), false, true});
  else if (says == Culling::kOutside) proofs.push_back({"right: " + both + "no point", true, true});
  else if (says == Culling::kInside)
    proofs.push_back(
        {"right: " + std::string(box ? "every vertex" : "the " + body) + " is inside every plane", true, true});
  else if (*shares) proofs.push_back({"right: they share points, and a part is outside", true, true});
  else
    proofs.push_back({"a false positive: the " + body + " is outside, though no single plane shows it", false, false});
  proofs.push_back(pair.form == Form::kBall
                       ? Proof{"checked by the distance from the frustum, within rounding", true, true}
                       : Proof{"decided in exact arithmetic", true, true});
  return proofs;
}

}  // namespace snug::lesson
