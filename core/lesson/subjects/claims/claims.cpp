#include "lesson/subjects/claims/claims.hpp"

#include <algorithm>
#include <array>

#include "lesson/figures.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/claims/samples.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<std::string_view, 3> kVerdicts{"holds", "typical", "false"};
constexpr std::array<std::string_view, 3> kVerdictChoices{
    "It holds on every cloud", "It holds typically, on more than half of them", "It is false on half of them or more"};

const char* offer_verdicts(Asked& asked, const Run&) {
  for (const std::string_view choice : kVerdictChoices) asked.add_choice(std::string(choice));
  return nullptr;
}

Truth verdict_truth(const Asked& asked, const Run&) {
  const auto& trials = static_cast<const ClaimsSubject&>(*asked.subject).trials();
  const cost::TrialTally tally = cost::tally_trials(asked.question->figure, trials);
  const auto* const found = std::find(kVerdicts.begin(), kVerdicts.end(), tally.verdict());
  Truth truth{.pending = found == kVerdicts.end()};
  if (truth.pending) return truth;
  const std::size_t verdict = found - kVerdicts.begin();
  truth.choices.push_back(static_cast<int>(verdict));
  truth.happened = kVerdictChoices[verdict];
  truth.sentence = "It holds on " + tally_text(tally) + ".";
  return truth;
}

void read_verdict(TomlTable& table, Question& question) {
  std::vector<std::string_view> names;
  for (const cost::Claim* claim : cost::tried_claims()) names.push_back(claim->name);
  question.figure = table.text("claim");
  check_name(table, "claim", question.figure, names);
}

const char* offer_own(Asked& asked, const Run&) {
  for (const std::string& choice : asked.question->choices) asked.add_choice(choice);
  return nullptr;
}
Truth own_truth(const Asked& asked, const Run& run) {
  const bool tried = !static_cast<const ClaimsSubject&>(*asked.subject).trials().empty();
  return tried ? choice_truth(asked, run) : Truth{.pending = true};
}

constexpr std::array kClaimsQuestionKinds{
    QuestionKind{.name = "choice", .offer = &offer_own, .truth = &own_truth},
    QuestionKind{.name = "verdict", .offer = &offer_verdicts, .truth = &verdict_truth, .read = &read_verdict}};

/// Checks that each counter-example can be shown.
void check_claims(const Lesson& lesson, const Subject&, Complaints& complaints) {
  for (const cost::Claim* claim : cost::tried_claims())
    if (!is_among(lesson.algorithms, shown_by(lesson, *claim)))
      complaints.add(FilePlace(1), "\"algorithms\" lacks " + std::string(claim->volume) + '/' +
                                       std::string(claim->algorithm) + ", which shows the claim " +
                                       std::string(claim->name));
}

tl::expected<std::unique_ptr<Subject>, InputError> open_claims(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                               Clock clock) {
  auto cloud = open_cloud_of(lesson, std::move(mesh), clock);
  if (!cloud) return tl::unexpected(std::move(cloud.error()));
  return std::make_unique<ClaimsSubject>(*std::move(cloud));
}

void try_all(Session& session) {
  session.inform<ClaimsSubject>([](ClaimsSubject& claims) { claims.tried(cost::all_trials()); });
}

constexpr Experiment kClaimsExperiment{.chart = "claims", .perform = &try_all};

}  // namespace

constinit const SubjectRow kClaimsRow = row_on_cloud({.name = "claims",
                                                      .experiment = &kClaimsExperiment,
                                                      .question_kinds = &of_no_fact<kClaimsQuestionKinds>,
                                                      .check_first = &check_claims,
                                                      .open = &open_claims,
                                                      .samples = kClaimsSamples});

void ClaimsSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  cloud().begin_task(lesson, task, own.shape());
  static_cast<void>(edited({}));
}

std::string shown_by(const Lesson& lesson, const cost::Claim& claim) {
  const Method* method = find_method(lesson, std::string(claim.volume) + '/' + std::string(claim.algorithm));
  return method != nullptr ? name_in(lesson, *method) : std::string();
}

std::string tally_text(const cost::TrialTally& tally) {
  const std::string all = count_text(tally.clouds);
  if (tally.held == tally.clouds) return "all " + all + " clouds";
  return (tally.held == 0 ? "none" : count_text(tally.held)) + " of " + all + " clouds";
}

}  // namespace snug::lesson
