#include "desktop/cli/exercise_sheet.hpp"

#include <algorithm>

#include "desktop/cli/sheet_figure.hpp"
#include "desktop/cli/sheet_page.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/figures.hpp"
#include "lesson/prose.hpp"
#include "lesson/prose_figures.hpp"

namespace snug::desktop {
namespace {

using lesson::Asked;

constexpr double kWidth = kPageWidth - 2 * kMargin, kMostFigure = 120, kLeastFigure = 66;
constexpr double kBetween = 1.5, kGutter = 8, kFoot = kMargin / 2;
constexpr double kRoomToBuild = 2.4;  // of the squared paper, over what stands on it
constexpr const char* kItalic = "font-style=\"italic\"";
constexpr const char* kMuted = "fill=\"#555\"";

/// A question with what belongs to it, from its own upper left corner.
struct Block {
  SheetPage page;
  double height = 0;
};

/// What the run has reached before a question, which the screen would show: its circle, or its last step if that was
/// the program's own.
std::string reached_before(const lesson::Session& session, std::size_t question) {
  const Asked& asked = session.conversation().questions()[question];
  const lesson::Run& run = session.player().run(0);
  if (asked.step <= 0 || asked.ordered) return {};
  if (const auto* volume = run.volume(asked.step); volume != nullptr)
    if (const auto* ball = std::get_if<fit::Sphere3>(volume)) {
      const lesson::Point3& c = ball->center;
      std::string text = asked.dim == 2 ? "The circle now: centre (" : "The sphere now: centre (";
      text += lesson::coordinate_text(c[0]) + ", " + lesson::coordinate_text(c[1]);
      if (asked.dim == 3) text += ", " + lesson::coordinate_text(c[2]);
      text += "), radius " + lesson::coordinate_text(ball->radius);
      const std::vector<Index> support = run.support(asked.step);
      return text + (support.empty() ? "." : ", through " + asked.names(support) + ".");
    }
  if (run.fact(asked.step - 1) == "axes_found") return "The dashed line is the main axis.";
  const bool was_asked =
      std::any_of(session.conversation().questions().begin(), session.conversation().questions().end(),
                  [&](const Asked& one) { return one.fact == asked.step - 1; });
  return was_asked ? std::string() : run.sentence(asked.step - 1, {});
}

/// A question's words, which on the screen may ask for a tap.
std::string words_of(const Asked& asked, lesson::ProseFigures& figures) {
  std::string words = plain_now(asked.prompt, figures);
  if (const std::size_t tap = words.find("Tap "); tap != std::string::npos) words.replace(tap, 3, "Name");
  return words;
}

Block block_of(const lesson::Session& session, std::size_t question, double width, bool solved) {
  const Asked& asked = session.conversation().questions()[question];
  lesson::ProseFigures figures(session.conversation());
  Block block;
  constexpr double kIndent = 6;
  double y = 0;
  const std::string before = reached_before(session, question);
  const bool is_new = question == 0 || before != reached_before(session, question - 1);
  if (!solved && is_new && !before.empty()) y = block.page.paragraph(0, y, width, before, kMuted);
  y = block.page.paragraph(0, y, width, std::to_string(question + 1) + ". " + words_of(asked, figures));
  const lesson::Truth truth = asked.kind->truth(asked, session.player().run(0));
  const double room = width - kIndent;
  if (solved) y = block.page.paragraph(kIndent, y, room, truth.happened + ". " + truth.sentence, kItalic);
  else if (!asked.choices.empty() && !asked.on_stage) y = block.page.choices(kIndent, y, room, asked.choices);
  else block.page.line(kIndent, y + 1, width, y + 1), y += kLine;
  block.height = y + kBetween;
  return block;
}

/// All questions in one column, or in two, and the height of the taller one.
struct Columns {
  std::vector<Block> blocks;
  std::size_t split = 0;  // the first block of the second column
  double height = 0;
};

Columns columns_of(const lesson::Session& session, int count, bool solved) {
  Columns columns;
  double sum = 0;
  for (std::size_t i = 0; i < session.conversation().questions().size(); ++i) {
    columns.blocks.push_back(block_of(session, i, count == 1 ? kWidth : (kWidth - kGutter) / 2, solved));
    sum += columns.blocks.back().height;
  }
  double left = 0;
  while (columns.split < columns.blocks.size() && (count == 1 || left < sum / 2))
    left += columns.blocks[columns.split++].height;
  columns.height = std::max(left, sum - left);
  return columns;
}

void put_columns(SheetPage& page, const Columns& columns, double top, double scale) {
  double x = kMargin, y = top;
  for (std::size_t i = 0; i < columns.blocks.size(); ++i) {
    if (i == columns.split) x = kMargin + (kWidth + kGutter) / 2, y = top;
    page.put(columns.blocks[i].page, x, y, scale);
    y += scale * columns.blocks[i].height;
  }
}

/// Title, what is asked, and a line for the name. Returns where the next line would be.
double head(SheetPage& page, const lesson::Exercise& exercise, std::uint64_t seed, bool solved) {
  page.text(kMargin, kMargin + 4, exercise.stage.title, 6.5, "font-weight=\"600\"");
  page.text(kPageWidth - kMargin, kMargin + 4, "Instance " + std::to_string(seed), 3.9, "text-anchor=\"end\"");
  double y = page.paragraph(kMargin, kMargin + 12, kWidth, exercise.stage.summary);
  // What is on the screen for the student to do begins with "You".
  for (const lesson::Section& section : exercise.stage.sections)
    for (const lesson::Paragraph* paragraph : paragraphs_of(section))
      if (const std::string text = plain_text(*paragraph); !solved && !text.starts_with("You "))
        y = page.paragraph(kMargin, y + kBetween, kWidth, text, kMuted);
  y += solved ? 0 : kBetween;
  if (solved) page.text(kMargin, y, "Solution", 3.9, "font-weight=\"600\"");
  else page.text(kMargin, y, "Name: ________________________________", 3.9);
  return y + 4;
}

void ask_decisions(SheetPage& page, const lesson::Session& session, const SheetFigure& figure, double y, bool solved) {
  SheetPage numbers;
  const double below = columns(numbers, 0, numbers_of(session)) + 10;
  const double room = kPageHeight - kFoot - y - below;
  Columns questions = columns_of(session, 1, solved);
  if (questions.height + kLeastFigure > room) questions = columns_of(session, 2, solved);
  const double figure_room = std::clamp(room - questions.height, kLeastFigure, kMostFigure);
  const double scale = std::min(1.0, (room - figure_room) / questions.height);
  draw(page, figure, y, figure_room);
  page.put(numbers, 0, y + figure_room + 4, 1);
  put_columns(page, questions, y + figure_room + below, scale);
}

/// What is to be built: the stage with room around it, and a line for each thing that may move.
void ask_to_build(SheetPage& page, const lesson::Exercise& exercise, const lesson::Session& session, double y,
                  bool solved) {
  lesson::ProseFigures figures(session.conversation());
  const lesson::Task& task = exercise.stage.tasks.front();
  if (!exercise.build->claim.empty())
    y = page.paragraph(kMargin + 6, y + kBetween, kWidth - 6, exercise.build->claim, kItalic);
  y = page.paragraph(kMargin, y + kBetween, kWidth, plain_now(task.prompt, figures));
  const std::vector<std::string> levels = level_texts(exercise, session);
  if (solved) y = page.paragraph(kMargin, y, kWidth, now_says(session), kItalic);
  else if (levels.size() > 1) y = page.choices(kMargin, y, kWidth, levels);
  const auto figure = figure_of(session);
  if (!figure) return;
  draw(page, *figure, y, kMostFigure, solved ? 1 : kRoomToBuild);
  y = columns(page, y + kMostFigure + 4, numbers_of(session)) + 6;
  if (solved) return;
  std::vector<std::string> names = task.only;
  for (Index i = 0; task.only.empty() && i < session.stage().subject().size(); ++i)
    names.push_back(session.stage().subject().name_of(i));
  for (std::string& name : names)
    name += session.stage().subject().dim() == 2 ? " ( ________ , ________ )" : " ( ______ , ______ , ______ )";
  page.text(kMargin, y, "Your example:", 3.9);
  columns(page, y + kLine + 1, names);
}

}  // namespace

tl::expected<std::string, InputError> sheet_of(const lesson::Exercise& exercise, const lesson::Session& session,
                                               std::uint64_t seed, bool solved) {
  const auto figure = figure_of(session);
  if (!figure) return tl::unexpected(InputError{.what = exercise.id + ": " + figure.error().what});
  SheetPage page;
  const double y = head(page, exercise, seed, solved);
  if (!exercise.build) {
    ask_decisions(page, session, *figure, y, solved);
    return page.finished();
  }
  const auto model = solved ? find_model(exercise, session) : std::nullopt;
  if (!model) {
    ask_to_build(page, exercise, session, y, false);
    return page.finished();
  }
  auto built = lesson::make_instance(exercise, seed).and_then([&](const lesson::Instance& instance) {
    return open_instance(exercise, instance);
  });
  if (!built) return tl::unexpected(built.error());
  if (const auto put = built->stage().set_rows(*model); !put) return tl::unexpected(put.error());
  ask_to_build(page, exercise, *built, y, true);
  return page.finished();
}

}  // namespace snug::desktop
