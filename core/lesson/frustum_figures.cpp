#include "lesson/frustum_figures.hpp"

#include <string>

#include "lesson/frustum_tests.hpp"

namespace snug::lesson {
namespace {

using query::Culling;
using Plane = query::PlaneTested<double, 3>;
using Corner = query::CornerTested<double, 3>;

std::string word(Culling culling) { return std::string(query::kCullingNames[static_cast<std::size_t>(culling)]); }

/// Collects the figures of one place in a run.
class FrustumBoard {
 public:
  explicit FrustumBoard(const RunView& run) : run_(run), dim_(run.boxes->dim) {
    for (int i = 0; i < run.step; ++i) std::visit(*this, run.recording->steps[i].step.fact);
  }

  std::vector<Figure> figures() && {
    const bool by_planes = run_.algorithm->name == "p_n_vertex";
    add("Plane", "plane", plane_ >= 0 ? plane_name(dim_, plane_) : "", plane_, "");
    if (by_planes) {
      const bool any = plane_ >= 0;
      add("Signs of its normal", "signs", any ? sign_name(dim_, tested_.signs) : "", tested_.signs, "");
      length("p-vertex" + name_of(tested_.p_vertex), "p_distance", tested_.p_distance, any);
      length("n-vertex" + name_of(tested_.n_vertex), "n_distance", tested_.n_distance, any);
      add("Planes tested", "planes_tested", std::to_string(planes_) + " of " + std::to_string(planes_of_frustum(dim_)),
          planes_, "planes");
    } else {
      const bool any = plane_ >= 0;
      length(any ? "Corner" + name_of(corner_.corner) : "Corner", "distance", corner_.distance, any);
    }
    const auto looked = run_.step > 0 ? run_.recording->steps[run_.step - 1].counts[kTests] : 0;
    add("Corner tests", "corners", std::to_string(looked), static_cast<double>(looked), "");
    add(done_ ? "Verdict" : "Verdict so far", "verdict", run_.step > 0 && (done_ || by_planes) ? word(verdict_) : "",
        static_cast<double>(verdict_), "");
    return std::move(figures_);
  }

  void operator()(const Plane& fact) {
    tested_ = fact;
    plane_ = fact.plane;
    verdict_ = fact.so_far;
    ++planes_;
  }
  void operator()(const Corner& fact) {
    corner_ = fact;
    plane_ = fact.plane;
  }
  void operator()(const query::Classified& fact) {
    verdict_ = fact.result.verdict;
    done_ = true;
    if (run_.algorithm->name != "p_n_vertex") plane_ = fact.result.rejected_by;  // else it rests on no one plane
  }
  void operator()(const auto&) {}

 private:
  static constexpr auto kTests = static_cast<std::size_t>(Operation::kOrientationTests);

  [[nodiscard]] std::string name_of(int corner) const { return run_.step > 0 ? " " + sign_name(dim_, corner) : ""; }

  /// An empty text: there is no value yet.
  void add(std::string name, std::string key, std::string text, double value, std::string unit) {
    const bool known = !text.empty();
    figures_.push_back({std::move(name), std::move(key), known ? std::move(text) : "—", value, std::move(unit), known});
  }
  /// Signed, above 0 outside.
  void length(std::string name, std::string key, double value, bool known) {
    add(std::move(name), std::move(key), known ? (value > 0 ? "+" : "") + number_text(value) + " units" : "", value,
        "units");
  }

  const RunView& run_;
  int dim_;
  Plane tested_;
  Corner corner_;
  int plane_ = -1, planes_ = 0;
  Culling verdict_ = Culling::kInside;
  bool done_ = false;
  std::vector<Figure> figures_;
};

}  // namespace

std::vector<Figure> frustum_figures(const RunView& run) { return FrustumBoard(run).figures(); }

std::vector<Proof> frustum_proofs(const RunView& run) {
  const auto& steps = run.recording->steps;
  if (run.step < static_cast<int>(steps.size()) || steps.empty()) return {};
  const auto* end = std::get_if<query::Classified>(&steps.back().step.fact);
  const auto shares = share_a_point(*run.boxes);
  if (end == nullptr || !shares) return {};
  const Culling says = end->result.verdict;
  std::vector<Proof> proofs{{"it says: " + word(says), true, true}};
  if (says == Culling::kOutside && *shares)
    proofs.push_back({"wrong: box and frustum share points, as their separating axes show", false, true});
  else if (says == Culling::kOutside) proofs.push_back({"right: box and frustum share no point", true, true});
  else if (says == Culling::kInside) proofs.push_back({"right: no corner is outside of any plane", true, true});
  else if (*shares) proofs.push_back({"right: they share points, and a corner is outside", true, true});
  else proofs.push_back({"really outside, though no one plane shows it: drawn in vain, but never lost", false, false});
  proofs.push_back({"decided exactly, on the numbers as they are", true, true});
  return proofs;
}

}  // namespace snug::lesson
