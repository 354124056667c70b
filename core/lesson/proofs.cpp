#include "lesson/ask.hpp"
#include "lesson/box_figures.hpp"
#include "lesson/figures.hpp"
#include "lesson/frustum_box.hpp"
#include "lesson/frustum_figures.hpp"
#include "lesson/scene_set.hpp"
#include "lesson/volume_check.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

std::string all(Index n) { return n == 1 ? "the one point" : "all " + std::to_string(n) + " points"; }

std::string none_smaller(const Algorithm& algorithm, int dim) {
  return "no smaller " + std::string(volume_word(algorithm.volume, dim));
}

Proof smallest(const Certificate& certificate, const Algorithm& algorithm, int dim) {
  const std::string none = none_smaller(algorithm, dim);
  if (!algorithm.exact) return {none + ": not guaranteed", false, false};
  const char* why =
      algorithm.volume == "sphere" ? ": centre in the hull of the support set" : ": no orientation does better";
  return {none + why, certificate.optimal.value_or(false), true};
}

Proof boundary(const Algorithm& algorithm, bool holds) {
  return {algorithm.exact ? "support set on the boundary" : "it touches the points that it names", holds, true};
}

std::vector<Proof> of_result(const RunView& run) {
  const Certificate& certificate = run.recording->certificate;
  return {{"contains " + all(size_of(*run.points)) + ", exactly", certificate.contains, true},
          boundary(*run.algorithm, certificate.on_boundary),
          smallest(certificate, *run.algorithm, dim_of(*run.points))};
}

/// On the way nothing is promised of the points yet, and of a ball only what its support says.
std::vector<Proof> on_the_way(const RunView& run, const Step3& step) {
  const Index n = size_of(*run.points);
  const Index outside = count_outside(*run.points, step.volume);
  const std::string held = outside == 0
                               ? "contains " + all(n)
                               : "contains " + std::to_string(n - outside) + " of " + std::to_string(n) + " points";
  std::vector<Proof> proofs{{held, outside == 0, false}};
  const Sphere3* ball = ball_of(step);
  const std::vector<Index> support = support_after(run.recording->steps, run.step);
  if (support.empty() || ball == nullptr) return proofs;
  const StepCertificate certificate = certify_step(*run.points, *ball, support);
  proofs.push_back(boundary(*run.algorithm, certificate.on_boundary));
  if (run.algorithm->exact)
    proofs.push_back(
        {none_smaller(*run.algorithm, dim_of(*run.points)) + " contains the support set", certificate.smallest, false});
  return proofs;
}

}  // namespace

std::vector<Proof> proofs_of(const RunView& run) {
  if (run.algorithm->volume == kScene) return {};  // its figures are counts: there is nothing to prove
  if (run.boxes != nullptr) return has_frustum(*run.boxes) ? frustum_proofs(run) : box_proofs(run);
  const auto& steps = run.recording->steps;
  if (run.step == static_cast<int>(steps.size())) return of_result(run);
  if (run.step == 0 || !steps[run.step - 1].step.has_volume) return {};
  return on_the_way(run, steps[run.step - 1].step);
}

}  // namespace snug::lesson
