#include "lesson/ask.hpp"
#include "lesson/ball_check.hpp"
#include "lesson/figures.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

std::string all(Index n) { return n == 1 ? "the one point" : "all " + std::to_string(n) + " points"; }

Proof smallest(const Certificate& certificate, bool exact, int dim) {
  const std::string none = std::string("no smaller ") + ball_word(dim);
  if (exact) return {none + ": centre in the support's hull", certificate.optimal.value_or(false), true};
  return {none + ": not claimed", false, false};
}

std::vector<Proof> of_result(const RunView& run) {
  const Certificate& certificate = run.recording->certificate;
  return {{"holds " + all(size_of(*run.points)) + ", exactly", certificate.contains, true},
          {"support on the boundary", certificate.on_boundary, true},
          smallest(certificate, run.algorithm->exact, dim_of(*run.points))};
}

/// On the way nothing is promised of the points yet, and of the ball only what its support says.
std::vector<Proof> on_the_way(const RunView& run, const Sphere3& ball) {
  const Index n = size_of(*run.points);
  const Index outside = count_outside(*run.points, ball);
  const std::string held =
      outside == 0 ? "holds " + all(n) : "holds " + std::to_string(n - outside) + " of " + std::to_string(n) + " points";
  std::vector<Proof> proofs{{held, outside == 0, false}};
  const Support support = support_after(run.recording->steps, run.step);
  if (support.size() == 0) return proofs;
  const StepCertificate certificate = certify_step(*run.points, ball, support);
  proofs.push_back({"support on the boundary", certificate.on_boundary, true});
  if (run.algorithm->exact) proofs.push_back({std::string("no smaller ") + ball_word(dim_of(*run.points)) + " holds the support", certificate.smallest, false});
  return proofs;
}

}  // namespace

std::vector<Proof> proofs_of(const RunView& run) {
  const auto& steps = run.recording->steps;
  if (run.step == static_cast<int>(steps.size())) return of_result(run);
  if (run.step == 0 || !steps[static_cast<std::size_t>(run.step - 1)].step.has_ball) return {};
  return on_the_way(run, steps[static_cast<std::size_t>(run.step - 1)].step.ball);
}

}  // namespace snug::lesson
