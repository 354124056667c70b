#include "lesson/subjects/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sort.hpp"
#include "hierarchy/broad_phase/broad_phase.hpp"
#include "lesson/check_solution.hpp"
#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/declared_effects.hpp"
#include "lesson/subjects/scene/effect_words.hpp"
#include "lesson/subjects/scene/entries.hpp"
#include "lesson/subjects/scene/samples.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "lesson/subjects/scene/scene_text.hpp"
#include "measure/timing.hpp"

namespace snug::lesson {

template class FactRun<SceneRun, FrameStep>;

namespace {

std::vector<std::string_view> scene_volumes() { return {kScene}; }
std::span<const Method> methods_of_any(std::string_view) { return scene_methods(); }
const SceneSet& set_of(const Lesson& lesson) { return static_cast<const SceneSet&>(*lesson.tables); }

void read_scene(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  lesson.points = read_points(*table.table("points"), complaints);
  lesson.tables = std::make_shared<const SceneSet>(read_scene_of(table, lesson.points.dim, complaints));
  lesson.points.dim = 3;  // in the plane it was refused
}

InputError at_line(InputError error, int line) {
  if (error.position == 0) error.unit = InputError::Unit::kLine, error.position = line;
  return error;
}

tl::expected<std::unique_ptr<Subject>, InputError> open_scene(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                              Clock clock) {
  auto points = own_points(lesson, mesh);
  if (!points) return tl::unexpected(std::move(points.error()));
  const SceneSet& set = set_of(lesson);
  if (set.is_too_long(fit::count_of(*points)))
    return tl::unexpected(at_line({.what = too_long_text()}, set.frames_line));
  if (const Done sound = check_scene_opens(set, lesson.algorithms, *points, lesson.seed); !sound)
    return tl::unexpected(at_line(sound.error(), set.line));
  if (!set.spare.empty())  // a student may call for all of them
    if (const Done sound = check_scene_opens(*with_all_called(set), lesson.algorithms, *points, lesson.seed); !sound)
      return tl::unexpected(at_line(sound.error(), set.line));
  return std::make_unique<SceneSubject>(lesson, *std::move(points), std::move(mesh), clock);
}

std::vector<InputError> faults_of_scene(const Lesson& lesson, const std::optional<io::PointFile>& mesh) {
  const auto points = own_points(lesson, mesh);
  if (!points) return {};  // what open_scene says of them stands alone
  const SceneSet& set = set_of(lesson);
  std::vector<InputError> faults = scene_faults(set, lesson.algorithms, *points, lesson.seed);
  if (faults.empty() && !set.spare.empty())
    faults = scene_faults(*with_all_called(set), lesson.algorithms, *points, lesson.seed);
  for (InputError& fault : faults) fault = at_line(std::move(fault), set.line);
  return faults;
}

/// Checks that no method has too many pairs.
void check_frames(const Lesson& lesson, const Subject& own, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms)
    if (const Done kept = check_pairs(set_of(lesson), name, *own.points(), lesson.seed); !kept)
      return complaints.add(static_cast<int>(kept.error().position), kept.error().what);
}

/// Checks that the model is no longer than a scene may be, and then as every task is checked.
void check_scene_task(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints) {
  const SceneSet& set = set_of(lesson);
  auto model = own.clone();
  if (const Done made = model->set_rows(task.model); !made) return complaints.add(task.model_place, made.error().what);
  if (set.is_too_long(model->size())) return complaints.add(task.model_place, too_long_text());
  if (const auto kept = check_pairs(set, task.algorithm, *model->points(), lesson.seed); !kept)
    return complaints.add(task.model_place, kept.error().what);
  check_solution(lesson, task, own, complaints);
}

/// If an effect behind the figures is off: says which of them are still those of an earlier frame.
std::string still_words(const SceneRun::Where& where, bool pairs) {
  const std::array<std::pair<const char*, const char*>, 3> makers{
      {{"refit", pairs ? "the AABBs are still those" : "the volume is still that"},
       {"broad_phase", "the pairs are still those"},
       {"narrow_phase", "the touching pairs are still those"}}};
  for (const auto& [effect, what] : makers)
    if (const int since = where.subject().off_since(effect, where.i + 1); since >= 0)
      return effect_words(effect) + " is off, so " + what + " of frame " + std::to_string(since) + ".";
  return {};
}

/// "the update examines 80 points; the volume is 35.0 % larger than the tightest of its kind, and 3.421 times the
/// hull’s."
std::string update_words(const FrameTaken& fact, const SceneRun::Where& where) {
  constexpr double kShown = 0.0005;  // less is shown as 0.0 %
  const bool slack = !where.hides("slack"), cost = !where.hides("cost");
  std::string words;
  if (cost) words += "the update examines " + (fact.cost == 0 ? "no point" : scene_figure_text("cost", fact.cost));
  if (!slack) return words + ".";
  if (cost) words += "; ";
  const double over = over_hull(where.step().volume, *where.subject().points());
  if (!std::isfinite(over)) return words + "all points lie in one plane, so the hull has no volume.";
  words += "the volume is ";
  if (fact.slack >= kShown) words += looser_words(fact.slack, "the tightest of its kind") + ", and ";
  return words + scene_figure_text(kOverHull, over) + " the hull’s.";
}

/// All frames; while something is dragged, those up to the one that is shown.
const SceneRecording& recording_for(const View& view, const SceneRun& run, int shown) {
  return run.recording(view.in_hand ? shown : run.steps());
}

/// Whether a method searches for pairs by sorting.
bool sorts(const Method& method) {
  return method.name == hierarchy::kPairSearchNames[static_cast<std::size_t>(hierarchy::PairSearch::kSweepAndPrune)];
}

std::string count_of_pairs(double n) { return count_text(static_cast<std::int64_t>(n)); }

/// "It is 4.8 times the tightest (+385 %)."; of an update "It examines 42 points."; of counts "There are 42 pairs." or
/// "There are none."
std::string range_sentence(std::string_view figure, double value, const std::string& text) {
  if (figure == "cost") return "The update examines " + (text == "none" ? "no point" : text) + ".";
  if (figure == kOverHull) return "The volume is " + text + " the hull’s.";
  if (figure == "energy") return "It is " + text + ".";
  if (figure != "slack")
    return text == "none" ? "There are none." : (value == 1 ? "There is " : "There are ") + text + ".";
  return percent_text(value / 100) == "0.0 %" ? "It is as tight as the tightest."
                                              : "It is " + looser_words(value / 100, "the tightest") + ".";
}

std::string refusal_text(const InputError& error) { return "The scene cannot run: " + effect_words(error.what) + "."; }

std::string pair_words(const FrameTaken& fact, const SceneRun::Where& where) {
  std::string words = "of " + count_of_pairs(fact.all_pairs) + (fact.all_pairs == 1 ? " pair" : " pairs");
  if (where.hides("after_broad")) return words + ", how many do the AABBs leave?";
  const auto left = [](auto pairs) { return pairs == 0 ? std::string("none") : count_of_pairs(pairs); };
  words += ", the AABBs leave " + left(fact.after_broad);
  if (where.hides("after_loose") || fact.after_broad == 0) return words + ".";
  words += " and the bounding spheres " + left(fact.after_loose);
  if (where.hides("touching") || fact.after_loose == 0) return words + ".";
  return words + "; " + left(fact.touching) + (fact.touching <= 1 ? " touches." : " touch.");
}

}  // namespace

std::string Entry<FrameTaken>::sentence(const FrameTaken& fact, const SceneRun::Where& where) {
  const std::string words = "Frame " + std::to_string(fact.frame) + ": ";
  // Beside a question, the sentence would nearly give away what is asked about a later frame.
  const bool asked = where.untold != nullptr && !where.untold->now.empty();
  if (asked || (fact.all_pairs == 0 && where.hides("slack") && where.hides("cost")))
    return words + "predict what comes next.";
  if (const std::string still = still_words(where, fact.all_pairs > 0); !still.empty()) return words + still;
  if (where.subject().set().graph) return words + counts_words(where.run.recording(fact.frame), fact.frame);
  if (fact.resting) return words + "all bodies are at rest, so no effect runs.";
  if (fact.all_pairs > 0) return words + pair_words(fact, where);
  return words + (where.step().has_volume ? update_words(fact, where) : "the bodies have moved.");
}

std::span<const QuestionKind> SceneRun::question_kinds(int) const { return Entry<FrameTaken>::kQuestionKinds; }

const char* offer_ranges(Asked& asked, const Run&) {
  const std::string unit = scene_figure(asked.question->figure, 0).unit;
  for (std::string& range : range_texts(asked.question->bounds, unit)) asked.add_choice(std::move(range));
  return nullptr;
}

/// The truth of "figure": the range that the figure lies in.
Truth range_truth(const Asked& asked, const Run& run) {
  const Question& question = *asked.question;
  const FrameStep& step = scene_run(run).entry(asked.fact).step;
  const double value = value_of(step, question.figure, *scene_run(run).subject().points());
  const auto range = std::lower_bound(question.bounds.begin(), question.bounds.end(), value) - question.bounds.begin();
  const bool none = value == 0 && asked.choices.front() == "none";
  const std::string text = none ? "none" : scene_figure_text(question.figure, value);
  return {{static_cast<int>(range)}, {}, text, range_sentence(question.figure, value, text)};
}

const SubjectRow kSceneRow{.name = "scene",
                           .table = "points",
                           .step_word = "frame",
                           .volumes = &scene_volumes,
                           .methods = &methods_of_any,
                           .facts = &FactList<decltype(FrameStep::fact)>::names,
                           .question_kinds = &FactList<decltype(FrameStep::fact)>::question_kinds,
                           .read = &read_scene,
                           .read_model = &read_scene_model,
                           .check_first = &check_frames,
                           .check_task = &check_scene_task,
                           .open = &open_scene,
                           .faults = &faults_of_scene,
                           .samples = kSceneSamples};

SceneSubject::SceneSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh, Clock clock)
    : PointSubject(lesson, std::move(points), std::move(mesh)),
      set_(std::static_pointer_cast<const SceneSet>(lesson.tables)), own_set_(set_), methods_(lesson.algorithms),
      clock_(clock) {
  if (clock_ != nullptr) clock_step_ = cost::resolution_of(clock_);
}

std::string_view SceneSubject::fixed_now() const {
  return set().at_points() ? "Bodies can only be moved before frame 1." : "Points can only be moved before frame 1.";
}

/// The lesson's own scene was opened when it was read. An edited scene may be refused: then its bodies stand where they
/// are put, and nothing runs.
std::unique_ptr<Run> SceneSubject::run(const Method& method, std::unique_ptr<Run>) const {
  refused_.clear();
  const auto stand_still = [&](const InputError& error) {
    refused_ = refusal_text(error);
    return start_of(set(), *points(), origin_.seed);
  };
  auto run = run_scene(set(), method.name, *points(), origin_.seed, clock_, off_, pushed_).or_else(stand_still);
  return std::make_unique<SceneRun>(*this, run ? *std::move(run) : SceneRecorder());
}

std::string SceneSubject::refusal_now(std::string_view method) const {
  const auto scene = declaration_with(set(), method, *points(), origin_.seed).and_then([](const auto& declaration) {
    return scene::Scene::open(declaration);
  });
  return scene ? "" : refusal_text(scene.error());
}

std::string SceneSubject::opening(const Method& method) const {
  if (!refused_.empty()) return refused_;
  const std::string many = std::to_string(size()) + (set().at_points() ? " bodies" : " points");
  const std::string what = set().at_points() ? (size() == 1 ? "1 body" : many)
                                             : "a body of " + (size() == 1 ? std::string("1 point") : many);
  return std::string(method.title) + ", " + what + ": nothing has moved yet. Go to frame 1.";
}

std::vector<Figure> SceneSubject::figures(const View& view) const {
  if (view.step == 0) return {};
  return scene_figures(scene_run(view.run()).entry(view.step - 1).step, *points(), sorts(view.method()));
}

/// None: its figures are counts.
std::vector<Proof> SceneSubject::proofs(const View&) const { return {}; }

/// Where nothing is switched off or pushed, the last frame alone is worked out: no frame before it is recorded.
std::vector<Figure> SceneSubject::figures_at_end(const Method& method, const View& view) const {
  const auto is_shown = [&](const Slot& slot) { return slot.method == &method && slot.run != nullptr; };
  if (is_disturbed() || std::any_of(view.slots.begin(), view.slots.end(), is_shown))
    return PointSubject::figures_at_end(method, view);
  const auto last = last_frame(set(), method.name, *points(), origin_.seed);
  return last ? scene_figures(last->step, *points(), sorts(method)) : PointSubject::figures_at_end(method, view);
}

/// Those of the last frame, with every effect on and nothing pushed. If the scene cannot run, none is known.
std::vector<Figure> SceneSubject::results(const Method& method, const View&) const {
  const auto last = last_frame(set(), method.name, *points(), origin_.seed);
  std::vector<Figure> figures = picture_figures(set(), last ? last->pictured : Pictured());
  const auto add = [&](std::string_view key) {
    figures.push_back(scene_figure(key, last ? value_of(last->step, key, *points()) : 0));
  };
  for (const std::string_view key : scene_figure_names()) add(key);
  if (last && last->step.has_volume) add(kOverHull);
  for (Figure& figure : figures) figure.known = figure.known && last.has_value();
  return figures;
}

Grade SceneSubject::grade(const Lesson& lesson, const Task& task, const View& view) const {
  if (std::string refusal = refusal_now(task.algorithm); !refusal.empty()) return {.says = std::move(refusal)};
  return PointSubject::grade(lesson, task, view);
}

int SceneSubject::off_since(std::string_view effect, int step) const {
  for (const SwitchedOff& off : off_)
    if (off.effect == effect) return off.after < step ? off.after : -1;
  return -1;
}

std::string SceneSubject::time_of(const scene::EffectTally& tally) const {
  return clock_ != nullptr ? effect_time_text(tally, clock_step_) : std::string();
}

std::vector<Switch> SceneSubject::switches(const View& view) const {
  const SceneRecording& run = recording_for(view, scene_run(view.run()), view.step);
  const std::size_t effects = run.tallies.size(), first = static_cast<std::size_t>(view.step) * effects;
  std::vector<Switch> all;
  for (std::size_t i = 0; i < effects; ++i) {
    const scene::EffectTally& last = run.tallies[i];
    const EffectCount& now = run.counts[first + i];
    const bool on = std::none_of(off_.begin(), off_.end(), [&](const auto& off) { return off.effect == last.effect; });
    all.push_back({last.effect, on, last.constructed, now.run, now.skipped, time_of(last)});
    if (set().graph) all.back().says = deed_words(*run.kinds[i], deed_of(run, view.step, i));
  }
  return set().graph ? with_optional(std::move(all), set()) : all;
}

/// Before the first frame an effect cannot be switched off: its readers would have nothing to work with.
bool SceneSubject::turn(std::string_view name, bool on, const View& view) {
  if (view.step == 0 && !on) return false;
  const std::vector<Switch> all = switches(view);
  const auto found = std::find_if(all.begin(), all.end(), [&](const Switch& one) { return one.name == name; });
  if (found == all.end()) return false;
  if (found->on == on) return true;
  if (on) std::erase_if(off_, [&](const SwitchedOff& one) { return one.effect == name; });
  else off_.push_back({std::string(name), view.step});
  return true;
}

/// Those whose numbers the scene takes: of the others a copy was edited, which is dropped.
Done SceneSubject::is_sound() const {
  if (set().is_too_long(size()))
    return tl::unexpected(InputError{.what = "this scene can show at most " + std::to_string(set().most_points()) +
                                             " points, and here are " + std::to_string(size()) +
                                             ": all its frames are computed before the first is shown"});
  if (const auto sound = scene::check(declaration_of(set(), *points(), origin_.seed)); !sound)
    return tl::unexpected(InputError{.what = sound.error().what});
  return {};
}

/// A drag moves the subject itself, so that what is refused has to be taken back.
Done SceneSubject::move(Index i, const Point3& to) {
  const Point3 from = at(i);
  if (Done moved = PointSubject::move(i, to); !moved) return moved;
  Done sound = is_sound();
  if (!sound) static_cast<void>(PointSubject::move(i, from));
  return sound;
}

Done SceneSubject::add(const Point3& at) {
  return PointSubject::add(at).and_then([&] { return is_sound(); });
}

Done SceneSubject::load(const io::PointFile& file, std::string_view name) {
  return PointSubject::load(file, name).and_then([&] { return is_sound(); });
}

Done SceneSubject::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) {
  return PointSubject::set_generator(kind, count, dim, seed, own).and_then([&] { return is_sound(); });
}

Rows SceneSubject::rows() const {
  Rows rows = PointSubject::rows();
  if (is_switched()) rows.push_back(called_row(set()));
  return rows;
}

bool SceneSubject::is_switched() const {
  return set_ != own_set_ && set_->text == with_called(*own_set_, called_row(*set_))->text;
}

StageFile SceneSubject::file() const {
  StageFile file{is_switched() ? set().text : own_set_->text, set().text, typed_ ? typed_->text : set().text};
  if (typed_)
    for (const FileError& one : typed_->mistakes)
      file.mistakes.push_back(std::to_string(one.place.line) + ":" + std::to_string(one.place.column) + ": " +
                              one.what);
  return file;
}

/// What is wrong with a scene that was read without a mistake.
std::vector<FileError> SceneSubject::mistakes_of(const SceneSet& next) const {
  std::vector<FileError> mistakes;
  const auto add = [&](int line, std::string what) { mistakes.push_back({FilePlace(line), std::move(what), {}}); };
  const auto of_points = [](const SceneSet& set) {
    return std::any_of(set.bodies.begin(), set.bodies.end(), [](const SceneBody& one) { return one.of_points; });
  };
  if (own_set_->at_points() && !next.at_points())
    add(next.line, "no body has \"at_points = true\": the handles on the stage are the places of such bodies");
  if (!own_set_->at_points() && next.at_points()) add(next.line, "the stage has no places for bodies at points");
  if (of_points(*own_set_) != of_points(next))
    add(next.line, "a body of the shape \"points\" cannot be added or removed here");
  for (const InputError& fault : scene_faults(next, methods_, *points(), origin_.seed))
    add(fault.position > 0 ? static_cast<int>(fault.position) : next.line, fault.what);
  for (const std::string& method : methods_)
    if (const auto kept = check_pairs(next, method, *points(), origin_.seed); mistakes.empty() && !kept)
      add(static_cast<int>(kept.error().position), kept.error().what);
  sort_stably(mistakes, [](const FileError& a, const FileError& b) { return a.place.line < b.place.line; });
  return mistakes;
}

Done SceneSubject::set_file(std::string text) {
  origin_.edited = true;
  SceneTyped read = read_typed(text);
  if (read.set) read.mistakes = mistakes_of(*read.set);
  const bool own = text == own_set_->text;
  if (!read.mistakes.empty() && !own) {
    typed_ = TypedText{std::move(text), std::move(read.mistakes)};
    return {};
  }
  typed_.reset();
  if (text == set().text) return {};
  set_ = own ? own_set_ : std::make_shared<const SceneSet>(*std::move(read.set));
  pushed_.clear();
  return {};
}

Done SceneSubject::set_rows(const Rows& rows) {
  const bool declares = !rows.empty() && is_called_row(rows.back());
  if (Done set = PointSubject::set_rows(declares ? Rows(rows.begin(), rows.end() - 1) : rows); !set) return set;
  const bool differs = declares && rows.back() != called_row(*own_set_);
  set_ = differs ? with_called(*own_set_, rows.back()) : own_set_;
  typed_.reset();
  return is_sound();
}

Done SceneSubject::call_for(std::string_view name, bool called) {
  auto next = with_call(set(), name, called);
  if (!next) return tl::unexpected(InputError{.what = "nothing here can call for " + std::string(name)});
  const bool own = next->text == own_set_->text && called_row(*next) == called_row(*own_set_);
  set_ = own ? own_set_ : std::move(next);
  std::erase_if(off_, [&](const SwitchedOff& one) { return one.effect == name; });
  pushed_.clear();
  origin_.edited = true;
  return {};
}

void SceneSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  PointSubject::begin_task(lesson, task, own);
  set_ = own_set_;
  typed_.reset();
}

bool SceneSubject::push(Index i, const View& view) {
  const SceneRecording& run = scene_run(view.run()).recording(view.step);
  const std::size_t body = set().first_at_points() + static_cast<std::size_t>(i);
  if (!set().graph || view.step == 0 || body >= run.members.size() || !run.members[body].moves()) return false;
  const bool moves =
      std::any_of(run.tallies.begin(), run.tallies.end(), [](const auto& t) { return t.effect == "move"; });
  std::vector<Pushed> pushed = pushed_;
  std::erase_if(pushed, [&](const Pushed& one) { return one.after > view.step; });
  pushed.push_back({body, view.step});
  if (!moves || frames_of(set(), size(), pushed) <= view.step) return false;
  pushed_ = std::move(pushed);
  return true;
}

const SceneRecording* recorded_scene(const Session& session, int slot) {
  if (as<SceneSubject>(session.stage().subject()) == nullptr || session.player().method(slot) == nullptr)
    return nullptr;
  return &recording_for(session.player().view(), scene_run(session.player().run(slot)), session.player().step_of(slot));
}

const SceneFrame* frame_of(const Session& session) {
  const SceneRecording* run = recorded_scene(session, 0);
  const std::size_t at = session.player().step();
  return run != nullptr && at < run->frames.size() ? &run->frames[at] : nullptr;
}

}  // namespace snug::lesson
