// The judge of what a student writes, for the page: a small program of its own, which only such exercises load.
#include <emscripten/bind.h>

#include <optional>
#include <string>
#include <vector>

#include "number/fnv.hpp"
#include "write/judge.hpp"
#include "write/shape.hpp"
#include "write/stage.hpp"

namespace snug::web {
namespace {

using emscripten::val;

/// A function that is being tried.
class Trial {
 public:
  /// Returns false if there is none of that name.
  bool open(const std::string& id) { return (function_ = write::find_function(id)) != nullptr; }

  /// The name in the code, the shape of what it gives, the marks and the hash.
  [[nodiscard]] val about() const {
    val about = val::object();
    about.set("name", std::string(function_->name));
    about.set("gives", std::string(function_->gives));
    about.set("of", static_cast<int>(function_->kinds.size()));
    about.set("hash", hex_of(write::hash_of(*function_)));
    return about;
  }

  /// The cases, a line of JSON for each.
  std::string cases(double seed) {
    cases_ = write::cases_of(*function_, static_cast<std::uint64_t>(seed));
    inputs_.clear();
    for (const write::Case& one : cases_) inputs_.push_back(one.input);
    return write::json_lines(*function_, inputs_);
  }

  val judge(const std::string& lines) {
    const std::vector<write::Answered> answers = write::read_answers(lines, cases_.size());
    const write::Judged judged = write::judge(*function_, cases_, answers);
    val told = val::object(), kinds = val::array();
    for (const auto& [kind, passed, of] : judged.kinds) {
      val row = val::object();
      row.set("name", std::string(kind->name));
      row.set("passed", passed);
      row.set("of", of);
      kinds.call<void>("push", row);
    }
    told.set("kinds", kinds);
    told.set("mark", judged.mark());
    told.set("of", judged.of());
    told.set("says", write::says(judged));
    found_.reset();
    if (judged.first) found_ = {inputs_[*judged.first], answers[*judged.first]};
    const auto kind = judged.first ? function_->kinds[static_cast<std::size_t>(cases_[*judged.first].kind)].name : "";
    told.set("first", judged.first ? found(kind) : val::null());
    return told;
  }

  /// Inputs that are shorter than the one that was answered wrong, a line for each; none if nothing was.
  std::string shorter() {
    inputs_ = found_ ? write::shorter(*function_, found_->input) : std::vector<write::Numbers>();
    return write::json_lines(*function_, inputs_);
  }
  /// Goes on to the first of these that is answered wrong. Returns it, or null.
  val narrow(const std::string& lines) {
    const std::vector<write::Answered> answers = write::read_answers(lines, inputs_.size());
    const auto wrong =
        write::first_wrong(*function_, inputs_, answers, write::shows(*function_, found_->input, found_->answer));
    if (!wrong) return val::null();
    found_ = {inputs_[*wrong], answers[*wrong]};
    return found("");
  }

 private:
  struct Found {
    write::Numbers input;
    write::Answered answer;
  };

  [[nodiscard]] val found(std::string_view kind) const {
    const std::string given = write::json_of(function_->takes, found_->input);
    const std::string right = write::json_of(function_->gives, function_->right(found_->input));
    const write::Answered& answer = found_->answer;
    const bool fits = answer && write::fits(function_->gives, *answer);
    const std::string yours = fits ? write::json_of(function_->gives, *answer) : answer ? "" : answer.error();
    val one = val::object();
    one.set("kind", std::string(kind));
    one.set("given", given);
    one.set("right", right);
    one.set("yours", yours);
    one.set("lesson", write::lesson_of(*function_, found_->input, answer, "Right: " + right + "\nYours: " + yours));
    one.set("words", write::words_of(*function_, found_->input, answer));
    return one;
  }

  const write::Function* function_ = nullptr;
  std::vector<write::Case> cases_;
  std::vector<write::Numbers> inputs_;
  std::optional<Found> found_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(judge) {
  emscripten::class_<Trial>("Trial")
      .constructor<>()
      .function("open", &Trial::open)
      .function("about", &Trial::about)
      .function("cases", &Trial::cases)
      .function("judge", &Trial::judge)
      .function("shorter", &Trial::shorter)
      .function("narrow", &Trial::narrow);
}

}  // namespace snug::web
