// A program without the chart of costs: see snug_program() in CMakeLists.txt.
#include "app/costs.hpp"
#include "lesson/costs.hpp"
#include "web/costs.hpp"

namespace snug::lesson {

std::vector<Asked> asked_of_costs(const Lesson&) { return {}; }
bool answers_of_costs(const Asked&, const Answer&) { return false; }
Outcome predicted(const Asked&, const Answer&) { return {}; }
void decide(const Asked&, Costs, Outcome&) {}
Answer model_answer(const Asked&, Costs) { return {}; }
Grade grade_costs(const Task&, Costs, std::string_view) { return {}; }
std::string_view cheapest_of(const Task&, Costs) { return {}; }
std::vector<cost::CostRow> counted_costs(const Lesson&, const AnyPointSet&) { return {}; }

}  // namespace snug::lesson

namespace snug::app {

Costs::Costs(const Platform&) {}
Costs::~Costs() = default;
void Costs::open() {}
tl::expected<void, InputError> Costs::load(lesson::Session& session, const io::PointFile& file, std::string_view name) {
  return session.load(file, name);
}
bool Costs::command(lesson::Session&, std::string_view) { return false; }
void Costs::work(lesson::Session&, double) {}
Index Costs::size(const lesson::Session&) const { return 0; }
void Costs::draw(const Look&, lesson::Session&, const Rect&, bool) {}
std::string Costs::caption(const lesson::Session&) const { return {}; }
std::vector<Handle> Costs::handles() const { return {}; }

}  // namespace snug::app

namespace snug::web {

cost::Provenance web_provenance(const std::string&) { return {}; }
emscripten::val costs_object(app::App&) { return emscripten::val::null(); }
std::string costs_file(app::App&, const std::string&) { return {}; }
std::string lay_over(app::App&, const std::string&, const std::string&) {
  return "this lesson has no chart to lay it over";
}

}  // namespace snug::web
