#include <algorithm>
#include <iterator>

#include "io/corner_merger.hpp"
#include "io/formats.hpp"

namespace snug::io {
namespace {

/// Goes through "solid, (facet, outer loop, three times vertex, endloop, endfacet) ..., endsolid" word by word.
class StlTextReader {
 public:
  StlTextReader(std::string_view text, const Wanted& wanted) : lines_(text), wanted_(wanted) {}

  Read<PointFile> read() {
    for (std::string_view word = take(); !word.empty(); word = take()) {
      if (is_note(word)) {
        ++notes_;
        words_ = {};
        continue;
      }
      if (!is(word, "solid")) return at_line(lines_.number(), "a solid does not begin with \"solid\"");
      solid_ = true;
      if (!read_solid()) return tl::unexpected(std::move(error_));
    }
    PointFile file = merger_.take();
    pass_over(file, Passed::kEnd, ends_missing_);
    pass_over(file, Passed::kLines, notes_);
    return file;
  }

 private:
  /// Whether a word after a solid begins a line that is no part of a solid.
  [[nodiscard]] bool is_note(std::string_view word) const {
    constexpr std::string_view kStatements[] = {"solid",  "facet",   "normal",   "outer",    "loop",
                                                "vertex", "endloop", "endfacet", "endsolid", "end"};
    const std::string name = lower_case(word);
    return solid_ && std::find(std::begin(kStatements), std::end(kStatements), name) == std::end(kStatements);
  }

  bool read_solid() {
    if (!skip_name("facet")) return false;
    for (;;) {
      const std::string_view word = take();
      if (word.empty()) {
        ++ends_missing_;
        return true;
      }
      if (lower_case(word.substr(0, 8)) == "endsolid" || is(word, "end")) return skip_name("solid");
      if (!is(word, "facet")) return fail("there is " + quoted(word) + " where \"facet\" or \"endsolid\" should be");
      if (!read_facet()) return false;
    }
  }

  bool read_facet() {
    if (!expect("normal")) return false;
    std::string_view word = take();
    for (int axis = 0; axis < 3 && !is(word, "outer"); ++axis) word = take();  // not used, and often not a number
    if (!is(word, "outer")) return fail_at(word, "outer");
    if (!expect("loop")) return false;
    Vector<double, 3> first, last, corner;
    for (int count = 0;; ++count) {
      word = take();
      if (count >= 3 && is(word, "endloop")) return expect("endfacet");
      if (!is(word, "vertex")) return fail_at(word, count < 3 ? "vertex" : "endloop");
      if (!read_corner(corner)) return false;
      if (count >= 3 && (!add(first) || !add(last))) return false;  // a polygon is a fan of triangles
      if (count == 0) first = corner;
      last = corner;
      if (!add(corner)) return false;
    }
  }

  bool read_corner(Vector<double, 3>& point) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t line = lines_.number();
      const std::string_view word = take();  // it may be on the next line
      if (word.empty() || is(word, "vertex") || is(word, "endloop")) {
        error_ = at_line(line, "a vertex has three coordinates, and there are " + std::to_string(axis)).value();
        return false;
      }
      const auto value = parse_coordinate(word, wanted_.skip_nan);
      if (!value) return fail(value.error());
      point[axis] = *value;
    }
    return true;
  }

  bool add(const Vector<double, 3>& corner) {
    if (merger_.full()) return fail(std::string(kTooManyPoints));
    merger_.add(corner);
    return true;
  }

  /// Leaves out the rest of the line, which is a name, but for a statement that begins on it.
  bool skip_name(std::string_view statement) {
    while (!trim(words_).empty()) {
      const std::string_view before = words_;
      const std::string_view word = take_word(words_);
      std::string_view after = words_;
      if (!is(word, statement)) continue;
      if (statement == "facet" && (!is(take_word(after), "normal") || trim(after).empty())) continue;
      if (statement == "solid" && lower_case(after).find("facet") == std::string::npos) continue;
      words_ = before;
      return true;
    }
    return true;
  }

  static bool is(std::string_view word, std::string_view keyword) { return lower_case(word) == keyword; }

  /// The next word, on whatever line; empty at the end of the file.
  std::string_view take() {
    if (trim(words_).empty() && lines_.next_filled()) words_ = lines_.line();
    return take_word(words_);
  }
  bool fail_at(std::string_view word, std::string_view wanted) {
    if (word.empty()) return fail("the file ends within a facet");
    return fail("there is " + quoted(word) + " where " + quoted(wanted) + " should be");
  }
  bool expect(std::string_view keyword) {
    const std::string_view word = take();
    return is(word, keyword) || fail_at(word, keyword);
  }
  bool fail(std::string what) {
    error_ = at_line(lines_.number(), std::move(what)).value();
    return false;
  }

  Lines lines_;
  Wanted wanted_;
  std::string_view words_;
  CornerMerger merger_;
  bool solid_ = false;  // whether one was read
  std::int64_t ends_missing_ = 0, notes_ = 0;
  InputError error_;
};

}  // namespace

Read<PointFile> read_stl_text(std::string_view text, const Wanted& wanted) {
  return StlTextReader(text, wanted).read();
}

}  // namespace snug::io
