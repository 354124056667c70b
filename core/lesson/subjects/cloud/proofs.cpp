#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/subjects/cloud/volume_check.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

std::string all(Index n) { return n == 1 ? "the one point" : "all " + count_text(n) + " points"; }

std::string none_smaller(const Method& method, int dim) {
  return "no smaller " + std::string(method.volume == "aabb" ? "AABB" : volume_word(method.volume, dim));
}

/// Why no volume of its kind is smaller. Only an oriented box has orientations to choose from.
std::string smallest_text(const Method& method, int dim) {
  if (method.volume == "hull") return "no smaller convex set contains the points";
  const std::string none = none_smaller(method, dim);
  if (method.volume == "sphere") return none + ": centre in the hull of the support set";
  if (method.volume == "kdop") return none + " with these directions";
  if (method.volume == "aabb") return none + (dim == 2 ? ": a point lies on each side" : ": a point lies on each face");
  return none + ": no orientation does better";
}

Proof smallest(const Certificate& certificate, const Method& method, int dim) {
  if (!method.exact) return {none_smaller(method, dim) + ": not guaranteed", false, false};
  return {smallest_text(method, dim), certificate.optimal.value_or(false), true};
}

Proof boundary(const Method& method, bool holds) {
  return {method.exact ? "support set on the boundary" : "it touches the points that it names", holds, true};
}

std::vector<Proof> of_result(const Method& method, const FitRun& run) {
  const Certificate& certificate = run.recording().certificate;
  return {{"contains " + all(fit::count_of(run.points())) + ", exactly", certificate.contains, true},
          boundary(method, certificate.on_boundary),
          smallest(certificate, method, run.dim())};
}

/// Before the end, containment is not guaranteed yet, and only the ball's support set can be checked.
std::vector<Proof> on_the_way(const View& view, const FitRun& run, const Step3& step) {
  const Index n = fit::count_of(run.points());
  const Index outside = run.outside_at(view.step - 1);
  const std::string held =
      outside == 0 ? "contains " + all(n) : "contains " + count_text(n - outside) + " of " + count_text(n) + " points";
  std::vector<Proof> proofs{{held, outside == 0, false}};
  const Sphere3* ball = ball_of(step);
  const std::vector<Index> support = run.support(view.step);
  if (support.empty() || ball == nullptr) return proofs;
  const StepCertificate certificate = certify_step(run.points(), *ball, support);
  proofs.push_back(boundary(view.method(), certificate.on_boundary));
  if (view.method().exact)
    proofs.push_back(
        {none_smaller(view.method(), run.dim()) + " contains the support set", certificate.smallest, false});
  return proofs;
}

}  // namespace

std::vector<Proof> fit_proofs(const View& view, const FitRun& run) {
  if (view.at_end()) return of_result(view.method(), run);
  if (view.step == 0 || !run.trace()[view.step - 1].step.has_volume) return {};
  return on_the_way(view, run, run.trace()[view.step - 1].step);
}

}  // namespace snug::lesson
