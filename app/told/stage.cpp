#include "app/told/stage.hpp"

#include <utility>

#include "lesson/point_subject.hpp"
#include "lesson/stored.hpp"

namespace snug::app::told {
namespace {

StoredForm form_of(lesson::StoredForm& own) {
  StoredForm told{.name = std::move(own.name), .bytes = own.bytes()};
  for (lesson::StoredMember& member : own.members)
    told.members.push_back({std::move(member.declared), std::move(member.text), std::move(member.mark)});
  for (lesson::StoredOperation& operation : own.operations)
    told.operations.push_back({std::move(operation.name), std::move(operation.says), operation.least});
  return told;
}

}  // namespace

std::vector<double> coordinates_of(const Vector<double, 3>& place, int dim) {
  return {place.data(), place.data() + dim};
}

Points points_of(const App& app, const lesson::Session& session) {
  const lesson::Subject& subject = session.stage().subject();
  const lesson::Tools tools = subject.tools();
  Points told{.tools_word = tools.word,
              .tools_title = tools.title,
              .size = lesson::count_of(subject),
              .dim = subject.dim(),
              .edited = session.stage().edited(),
              .source = subject.origin().source,
              .seed = subject.origin().seed,
              .can_undo = session.stage().can_undo(),
              .can_redo = session.stage().can_redo()};
  for (const lesson::NumberGroup& group : subject.numbers()) {
    NumberGroup& fields = told.numbers.emplace_back(NumberGroup{group.heading, group.name, {}});
    for (const lesson::NumberRow& row : group.rows)
      fields.rows.push_back({row.words, row.unit, row.turn, row.names, row.values});
  }
  if (subject.scalar() != nullptr) told.scalar = scalar_of(subject.in_float());
  const Index selected = app.selected();
  if (selected < 0 || selected >= subject.size()) return told;
  told.selected = selected;
  told.selected_name = subject.name_of(selected);
  told.coordinates = coordinates_of(subject.at(selected), subject.dim());
  return told;
}

Parts parts_of(const lesson::Session& session) {
  Parts told;
  if (!session.lesson().situations.empty()) told.situation = session.stage().situation();
  for (const lesson::ShownSlider& slider : session.stage().sliders())
    told.sliders.push_back(
        {slider.number, slider.slider->title, slider.value, slider.text, slider.place, slider.places});
  for (lesson::StoredVolume& volume : lesson::stored_of(session)) {
    StoredVolume& stored = told.stored.emplace_back(StoredVolume{std::move(volume.title), {}});
    for (lesson::StoredForm& form : volume.forms) stored.forms.push_back(form_of(form));
  }
  if (const auto file = session.stage().subject().file())
    told.file = StageFile{file->own, file->runs, file->typed, file->heading(), file->mistakes};
  for (const lesson::Switch& one : session.player().switches())
    told.effects.push_back(
        {one.name, one.on, one.constructed, one.run, one.skipped, one.microseconds, one.called, one.says});
  return told;
}

}  // namespace snug::app::told
