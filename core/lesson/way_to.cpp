#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"
#include "lesson/place.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_change.hpp"

namespace snug::lesson {
namespace {

// ---- in the run ------------------------------------------------------------------------------------------------

Done refused(std::string why) { return tl::unexpected(InputError{.what = std::move(why)}); }

/// Finds a question by its id; null for none.
const Question* find_question(const Lesson& lesson, std::string_view id) {
  const auto found = std::find_if(lesson.questions.begin(), lesson.questions.end(),
                                  [&](const Question& question) { return question.id == id; });
  return found != lesson.questions.end() ? &*found : nullptr;
}

Done no_question(const Lesson& lesson, const std::string& id) {
  std::vector<std::string_view> ids;
  for (const Question& question : lesson.questions) ids.push_back(question.id);
  return refused(ids.empty() ? "the lesson has no questions" : "the question " + none_of_text(id, ids));
}

Done use(Session& session, const std::string& algorithm) {
  const Lesson& lesson = session.lesson();
  if (offered(lesson, algorithm).empty())
    return refused("the lesson's algorithm " + none_of_text(algorithm, lesson.algorithms));
  return session.player().choose(0, algorithm);
}

/// Goes to where a question of the run is asked, past the others.
Done open_question(Session& session, const std::string& id) {
  const auto& all = session.conversation().questions();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Asked& one) { return one.question->id == id; });
  if (it == all.end()) return refused("the question " + id + " does not come on what is on the stage");
  if (it->step != Asked::kAnytime) session.jump(it->step);
  else session.conversation().ask_predictions();
  for (std::size_t others = all.size(); others > 0; --others) {
    const Asked* asked = session.conversation().asked();
    if (asked == nullptr) break;
    if (asked->question->id == id) return {};
    session.conversation().give({}, false);
  }
  return refused("the question " + id + " comes while another one is open");
}

Done go_to_question(Session& session, const Place& at) {
  const Question* question = find_question(session.lesson(), at.question);
  if (question == nullptr) return no_question(session.lesson(), at.question);
  const std::string& own = question->gate.algorithm;
  const auto method = [&](const std::string& name) { return find_method(session.lesson(), name); };
  if (!at.algorithm.empty() && !own.empty() && method(at.algorithm) != method(own))
    return refused("the question " + at.question + " is about " + own + ", not about " + at.algorithm);
  if (!at.situation.empty() && at.situation != question->situation)
    return refused("the question " + at.question + " is asked in " + question->situation + ", not in " + at.situation);
  if (Done shown = session.stage().show_situation(question->situation); !shown) return shown;
  if (!own.empty())
    if (Done used = use(session, own); !used) return used;
  if (at.answered && question->predicts)
    return refused("the question " + at.question + " is decided by what is measured then, and has no outcome before");
  if (Done opened = open_question(session, at.question); !opened) return opened;
  if (at.answered) session.conversation().give(model_answer(*session.conversation().asked(), session.player().run(0)));
  return {};
}

Done go_to_step(Session& session, int step) {
  const int steps = session.player().steps();
  if (step > steps)
    return refused("there is no " + std::string(session.lesson().subject->step_word) + ' ' + std::to_string(step) +
                   ": " + name_in(session.lesson(), *session.player().method(0)) + " has " + std::to_string(steps));
  session.jump(step == Place::kLastStep ? steps : step);
  return {};
}

// ---- on the stage ----------------------------------------------------------------------------------------------

/// The points or the task that an address names: "task", "task:2", "clusters:200", "bunny".
Done take_source(const Place& place, Session& session, const MeshOf& mesh) {
  const auto words = source_in(place.from);
  if (!words) return refused("there are no points \"" + place.from + '"');
  const std::string name(words->name);
  if (name == "task") {
    const auto task = static_cast<std::size_t>(words->number.value_or(1));
    if (task > session.lesson().tasks.size()) return refused("this lesson has no task " + std::to_string(task));
    session.stage().start_task(task - 1);
    return {};
  }
  if (words->number)
    return session.stage().set_generator(name, *words->number, session.stage().subject().dim(),
                                         place.seed.value_or(session.lesson().seed));
  if (!is_among(session.lesson().meshes, name)) return refused("this lesson has no points \"" + name + '"');
  return mesh(name).and_then([&](const io::PointFile& file) { return session.stage().load(file, name); });
}

Done take_moved(const Place& place, Session& session) {
  Rows all = session.stage().subject().rows();
  for (std::vector<double> row : place.moved) {
    const double at = row.front();
    if (!(at >= 0 && at < static_cast<double>(all.size())) || at != std::floor(at))
      return refused("there is no such point");
    row.erase(row.begin());
    all[static_cast<std::size_t>(at)] = std::move(row);
  }
  return session.stage().set_rows(all);
}

Done take_text(Session& session, std::string StageFile::*of, const std::string& change) {
  const auto file = session.stage().subject().file();
  const auto text = file ? changed((*file).*of, change) : std::nullopt;
  if (!text) return refused("it changes a text that this lesson does not have");
  Done set = session.stage().set_file(*text);
  if (set) session.stage().end_typing();
  return set;
}

/// A part of the way: the key that asks for it, whether it is asked for, and how it is gone.
struct Part {
  std::string_view key;
  bool (*is_asked)(const Place& place);
  Done (*take)(const Place& place, Session& session, const MeshOf& mesh);
};
constexpr std::array kParts{
    Part{"situation", [](const Place& place) { return !place.situation.empty(); },
         [](const Place& place, Session& session, const MeshOf&) {
           return session.stage().show_situation(place.situation);
         }},
    Part{"seed", [](const Place& place) { return place.seed.has_value(); },
         [](const Place& place, Session& session, const MeshOf&) {
           if (*place.seed != session.stage().subject().origin().seed) session.stage().scatter(*place.seed);
           return Done();
         }},
    Part{"from", [](const Place& place) { return !place.from.empty(); }, &take_source},
    Part{"scalar", [](const Place& place) { return !place.scalar.empty(); },
         [](const Place& place, Session& session, const MeshOf&) {
           return session.stage().set_float(place.scalar == "float");
         }},
    Part{
        "sliders", [](const Place& place) { return !place.sliders.empty(); },
        [](const Place& place, Session& session, const MeshOf&) { return session.stage().set_sliders(place.sliders); }},
    Part{"rows", [](const Place& place) { return !place.rows.empty(); },
         [](const Place& place, Session& session, const MeshOf&) { return session.stage().set_rows(place.rows); }},
    Part{"moved", [](const Place& place) { return !place.moved.empty(); },
         [](const Place& place, Session& session, const MeshOf&) { return take_moved(place, session); }},
    Part{"file", [](const Place& place) { return !place.file.empty(); },
         [](const Place& place, Session& session, const MeshOf&) {
           return take_text(session, &StageFile::own, place.file);
         }},
    Part{"draft", [](const Place& place) { return !place.draft.empty(); },
         [](const Place& place, Session& session, const MeshOf&) {
           return take_text(session, &StageFile::runs, place.draft);
         }},
    Part{"algorithm", [](const Place& place) { return !place.algorithm.empty(); },
         [](const Place& place, Session& session, const MeshOf&) { return use(session, place.algorithm); }},
    Part{"compare", [](const Place& place) { return place.beside.has_value(); },
         [](const Place& place, Session& session, const MeshOf&) { return session.player().choose(1, *place.beside); }},
    Part{"question", [](const Place& place) { return !place.question.empty(); },
         [](const Place& place, Session& session, const MeshOf&) { return go_to_question(session, place); }},
    Part{"step", [](const Place& place) { return place.step.has_value(); },
         [](const Place& place, Session& session, const MeshOf&) { return go_to_step(session, *place.step); }}};

}  // namespace

std::string WayTo::mesh_needed(const Lesson& lesson) const {
  const auto words = source_in(place_.from);
  if (!words || words->number || !is_among(lesson.meshes, words->name)) return {};
  return std::string(words->name);
}

bool WayTo::done() const {
  return std::none_of(kParts.begin() + static_cast<std::ptrdiff_t>(next_), kParts.end(),
                      [&](const Part& part) { return part.is_asked(place_); });
}

tl::expected<std::string_view, PlaceFault> WayTo::go_on(Session& session) {
  while (next_ < kParts.size()) {
    const Part& part = kParts[next_++];
    if (!part.is_asked(place_)) continue;
    if (const Done taken = part.take(place_, session, mesh_); !taken)
      return tl::unexpected(PlaceFault{std::string(part.key), taken.error()});
    return part.key;
  }
  return "";
}

tl::expected<void, PlaceFault> go_to(const Place& place, Session& session, const MeshOf& mesh) {
  const AtOnce at_once(session.stage());  // each part is taken on what the last one left
  for (WayTo way(place, mesh); !way.done();)
    if (auto gone = way.go_on(session); !gone) return tl::unexpected(std::move(gone.error()));
  return {};
}

Done go_in_run(const Place& place, Session& session) {
  if (!place.situation.empty())
    if (Done shown = session.stage().show_situation(place.situation); !shown) return shown;
  if (!place.algorithm.empty())
    if (Done used = use(session, place.algorithm); !used) return used;
  if (!place.question.empty()) return go_to_question(session, place);
  return place.step ? go_to_step(session, *place.step) : Done();
}

}  // namespace snug::lesson
