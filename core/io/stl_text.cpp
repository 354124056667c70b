#include "io/corner_merger.hpp"
#include "io/formats.hpp"

namespace snug::io {
namespace {

/// Goes through "solid, (facet, outer loop, three times vertex, endloop, endfacet) ..., endsolid" word by word.
class StlTextReader {
 public:
  StlTextReader(std::string_view text, bool skip_nan) : lines_(text), skip_nan_(skip_nan) {}

  Read<PointFile> read() {
    for (std::string_view word = take(); !word.empty(); word = take()) {
      if (!is(word, "solid")) return at_line(lines_.number(), "a solid does not begin with \"solid\"");
      if (!read_solid()) return tl::unexpected(std::move(error_));
    }
    PointFile file = merger_.take();
    pass_over(file, Passed::kEnd, ends_missing_);
    return file;
  }

 private:
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
      const std::string_view word = take_word(words_);
      if (word.empty()) return fail("a vertex has three coordinates, and there are " + std::to_string(axis));
      const auto value = parse_coordinate(word, skip_nan_);
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
  bool skip_nan_;
  std::string_view words_;
  CornerMerger merger_;
  std::int64_t ends_missing_ = 0;
  InputError error_;
};

}  // namespace

Read<PointFile> read_stl_text(std::string_view text, bool skip_nan) { return StlTextReader(text, skip_nan).read(); }

}  // namespace snug::io
