// Opening a session, the algorithms, and what is worked out when asked for.
#include "lesson/session.hpp"

#include <algorithm>

#include "lesson/costs.hpp"
#include "lesson/methods.hpp"
#include "lesson/own_points.hpp"
#include "lesson/scene_figures.hpp"
#include "measure/timing.hpp"

namespace snug::lesson {
namespace {

InputError too_many(const fit::Algorithm& algorithm) {
  return {.what = std::string(algorithm.title) + " takes at most " + std::to_string(algorithm.max_points) + " points"};
}

}  // namespace

tl::expected<Session, InputError> Session::open(Lesson lesson, std::optional<io::PointFile> mesh, scene::Clock clock) {
  if (lesson.algorithms.empty()) return tl::unexpected(InputError{.what = "the lesson offers no algorithm"});
  auto points = own_points(lesson, lesson.seed, mesh);
  if (!points) return tl::unexpected(std::move(points.error()));
  Snapshot own{*std::move(points), nullptr, lesson.seed, "own"};
  own.boxes = lesson.boxes;
  if (!lesson.points.generate.empty()) {
    own.source = lesson.points.generate;
    own.generated = lesson.points.count;
  }
  if (!lesson.points.mesh.empty()) {
    own.source = lesson.points.mesh;
    own.triangles = std::make_shared<const Triangles>(std::move(mesh->triangles));
  }
  Session session(std::move(lesson), std::move(own));
  if (session.lesson_.scene && clock != nullptr)
    session.clock_ = clock, session.clock_step_ = cost::resolution_of(clock);
  if (auto made = session.make_room_for(session.size()); !made) return tl::unexpected(std::move(made.error()));
  const Lesson& opened = session.lesson_;
  if (opened.scene && !opened.points.mesh.empty())  // any other was run when it was read
    if (auto sound = check_scene_opens(*opened.scene, opened.algorithms, session.points(), opened.seed); !sound)
      return tl::unexpected(std::move(sound.error()));
  session.points_changed();
  session.step_ = 0;
  if (session.lesson_.start == Lesson::Start::kEnd) {
    session.step_ = session.steps();
    session.previewing_ = true;
  }
  return session;
}

Session::Session(Lesson lesson, Snapshot own) : lesson_(std::move(lesson)), own_(own), now_(std::move(own)) {
  use(0, find_method(lesson_.volume, lesson_.algorithms.front()));
  if (!lesson_.compare.empty()) use(1, find_method(lesson_.volume, lesson_.compare));
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

void Session::use(int slot, const fit::Algorithm* algorithm) {
  Slot& own = slots_[slot];
  own = {algorithm, {}, {}, {}, {}};
  if (algorithm == nullptr) return;
  const auto pseudocode = fit::pseudocode_of(*algorithm, dim());
  own.pseudocode.assign(pseudocode.begin(), pseudocode.end());
  for (const Pseudocode& words : lesson_.pseudocode)
    if (words.algorithm == algorithm->name) own.pseudocode.assign(words.lines.begin(), words.lines.end());
}

const std::vector<SceneFrame>* Session::frames(int slot) const {
  return lesson_.scene ? &slots_[slot].frames : nullptr;
}

const SceneFrame* Session::frame() const {
  const auto at = static_cast<std::size_t>(step_);
  return at < slots_[0].frames.size() ? &slots_[0].frames[at] : nullptr;
}

const SwitchedOff* Session::switched_off(std::string_view effect) const {
  const auto off = std::find_if(off_.begin(), off_.end(), [&](const SwitchedOff& one) { return one.effect == effect; });
  return off == off_.end() ? nullptr : &*off;
}

bool Session::is_on(std::string_view effect) const { return switched_off(effect) == nullptr; }

int Session::off_since(std::string_view effect) const {
  const SwitchedOff* off = switched_off(effect);
  return off != nullptr && off->after < step_ ? off->after : -1;
}

bool Session::turn(std::string_view effect, bool on) {
  const SceneFrame* now = frame();
  if (now == nullptr || (step_ == 0 && !on)) return false;
  if (std::none_of(now->tallies.begin(), now->tallies.end(),
                   [&](const scene::Tally& tally) { return tally.effect == effect; }))
    return false;
  if (is_on(effect) == on) return true;
  if (on) std::erase_if(off_, [&](const SwitchedOff& one) { return one.effect == effect; });
  else off_.push_back({std::string(effect), step_});
  run(0);
  run(1);
  trace_changed(false);
  ++revision_;
  return true;
}

std::string Session::time_of(std::string_view effect) const {
  if (!clock_ || slots_[0].frames.empty()) return {};
  for (const scene::Tally& tally : slots_[0].frames.back().tallies)
    if (tally.effect == effect) return effect_time_text(tally, clock_step_);
  return {};
}

std::span<const std::string_view> Session::pseudocode(int slot) const { return slots_[slot].pseudocode; }

tl::expected<void, InputError> Session::choose(int slot, std::string_view name) {
  const bool clear = name.empty() && slot == 1;
  const fit::Algorithm* algorithm = clear ? nullptr : find_method(lesson_.volume, name);
  if (algorithm == nullptr && !clear)
    return tl::unexpected(InputError{.what = "there is no algorithm " + std::string(name)});
  if (algorithm != nullptr && size() > algorithm->max_points) return tl::unexpected(too_many(*algorithm));
  if (algorithm == this->algorithm(slot)) return {};
  const bool at_end = step_ == steps();
  use(slot, algorithm);
  run(slot);
  if (slot == 0) {
    step_ = 0;
    trace_changed(at_end);
    if (lesson_.measures) worked_.grade.reset();
  }
  ++revision_;
  return {};
}

/// An algorithm that does not take so many points gives way: the main one to the first of the lesson's that does.
tl::expected<void, InputError> Session::make_room_for(Index points) {
  if (slots_[0].algorithm->max_points < points) {
    const fit::Algorithm* fits = nullptr;
    for (const std::string& name : lesson_.algorithms) {
      const fit::Algorithm* offered = find_method(lesson_.volume, name);
      if (fits == nullptr && offered->max_points >= points) fits = offered;
    }
    if (fits == nullptr) return tl::unexpected(too_many(*slots_[0].algorithm));
    use(0, fits);
  }
  if (slots_[1].algorithm != nullptr && slots_[1].algorithm->max_points < points) use(1, nullptr);
  return {};
}

void Session::run(int slot) {
  Slot& own = slots_[slot];
  if (own.algorithm == nullptr) return;
  if (lesson_.scene) {
    auto run = run_scene(*lesson_.scene, own.algorithm->name, points(), seed(), clock_, off_);
    own.recording =
        run ? std::move(run->recording) : fit::Recording();  // the lesson's own scene was opened when it was read
    own.frames = run ? std::move(run->frames) : std::vector<SceneFrame>();
    own.members = run ? std::move(run->members) : std::vector<scene::Member>();
    return;
  }
  own.recording = now_.boxes ? record(*own.algorithm, *now_.boxes)
                             : own.algorithm->record(points(), {.seed = seed()}, std::move(own.recording));
}

void Session::points_changed() {
  const bool at_end = step_ == steps() && step_ > 0;
  worked_ = {};
  run(0);
  run(1);
  trace_changed(at_end);
  ++revision_;
}

/// Null where there is none, or where it does not take so many points. A chart is to tell what the smallest is, and
/// costs.
const fit::Algorithm* Session::exact() const {
  const fit::Algorithm* exact = lesson_.measures ? nullptr : fit::exact_algorithm(lesson_.volume);
  return exact != nullptr && size() <= exact->max_points ? exact : nullptr;
}

const fit::Recording* Session::optimum() const {
  const fit::Algorithm* own = exact();
  if (own == nullptr) return nullptr;
  for (const Slot& slot : slots_)
    if (slot.algorithm == own) return &slot.recording;
  if (!worked_.optimum) worked_.optimum = own->record(points(), {.seed = seed()});
  return &*worked_.optimum;
}

std::optional<double> Session::smallest_size() const {
  const fit::Algorithm* own = exact();
  if (own == nullptr) return std::nullopt;
  if (!worked_.smallest_size) worked_.smallest_size = size_of(*own);
  return *worked_.smallest_size;
}

/// What a slot shows already is not run again.
double Session::size_of(const fit::Algorithm& algorithm) const {
  for (const Slot& slot : slots_)
    if (slot.algorithm == &algorithm) return fit::size_of(slot.recording.result.volume, dim());
  if (&algorithm == exact() && worked_.smallest_size) return *worked_.smallest_size;
  return fit::size_of(algorithm.fit(points(), {.seed = seed()}).volume, dim());
}

const std::vector<Session::Rival>& Session::rivals() const {
  if (worked_.rivals) return *worked_.rivals;
  std::vector<Rival> rivals;
  if (now_.boxes || lesson_.scene || lesson_.measures) return worked_.rivals.emplace();
  const std::optional<double> smallest = smallest_size();
  for (const std::string& name : lesson_.algorithms) {
    const fit::Algorithm* algorithm = find_method(lesson_.volume, name);
    if (algorithm->max_points < size()) continue;
    const double own = size_of(*algorithm);
    rivals.push_back({algorithm, own, excess_of(own, smallest)});
  }
  return worked_.rivals.emplace(std::move(rivals));
}

std::optional<Grade> Session::grade() const {
  if (!lesson_.task) return std::nullopt;
  if (!worked_.grade && lesson_.measures) worked_.grade = grade_of_costs();
  if (!worked_.grade && lesson_.scene) worked_.grade = grade_scene(*lesson_.task, *lesson_.scene, points(), seed());
  if (!worked_.grade)
    worked_.grade =
        now_.boxes ? grade_boxes(*lesson_.task, *now_.boxes, found_) : lesson::grade(*lesson_.task, points(), seed());
  std::optional<Grade> now = worked_.grade;
  if (lesson_.scene && step_ > 0 && !now->done)
    now->says += lesson_.scene->at_points() ? " Bodies can be moved before frame 1 only."
                                            : " Points can be moved before frame 1 only.";
  return now;
}

std::uint64_t Session::trace_hash() const {
  if (!worked_.hash) worked_.hash = fit::hash_of(recording(0).steps);
  return *worked_.hash;
}

RunView Session::view(int slot) const {
  const Slot& own = slots_[slot];
  return {&now_.points, own.algorithm, &own.recording, step_of(slot), smallest_size(), boxes()};
}

std::string_view Session::asked_figure() const {
  const Asked* now = asked();
  if (now == nullptr) return {};
  return now->question->asks == Question::Asks::kVerdict ? "verdict" : std::string_view(now->question->figure);
}

bool Session::is_hidden(std::string_view figure) const {
  if (figure == asked_figure()) return true;
  const auto first =
      std::find_if(asked_.begin(), asked_.end(), [&](const Asked& asked) { return asked.question->figure == figure; });
  return first != asked_.end() && step() < first->until && open_question(*first);
}

std::vector<Figure> Session::figures(int slot) const {
  if (algorithm(slot) == nullptr) return {};
  std::vector<Figure> figures = figures_of(view(slot));
  for (Figure& figure : figures)
    if (is_hidden(figure.key)) figure.text = "—", figure.known = false;
  return figures;
}

std::vector<Proof> Session::proofs(int slot) const {
  if (algorithm(slot) == nullptr) return {};
  return proofs_of(view(slot));
}

}  // namespace snug::lesson
