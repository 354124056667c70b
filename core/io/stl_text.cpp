#include "io/corner_merger.hpp"
#include "io/formats.hpp"

namespace snug::io {
namespace {

/// Goes through "solid, (facet, outer loop, three times vertex, endloop, endfacet) ..., endsolid" line by line.
class StlTextReader {
 public:
  explicit StlTextReader(std::string_view text) : lines_(text) {}

  Read<PointFile> read() {
    while (lines_.next_filled()) {
      words_ = lines_.line();
      if (!read_solid()) return tl::unexpected(std::move(error_));
    }
    return merger_.take();
  }

 private:
  bool read_solid() {
    if (!is(take_word(words_), "solid")) return fail("a solid does not begin with \"solid\"");
    for (;;) {
      if (!next()) return false;
      const std::string_view word = take_word(words_);
      if (is(word, "endsolid")) return true;
      if (!is(word, "facet")) return fail("there is " + quoted(word) + " where \"facet\" or \"endsolid\" should be");
      if (!read_facet()) return false;
    }
  }

  bool read_facet() {
    if (!expect("normal")) return false;
    for (int axis = 0; axis < 3; ++axis) {  // ignored, and often not a number if the triangle is flat
      const std::string_view word = take_word(words_);
      if (!parse_number(word)) return fail(quoted(word) + " is not a number");
    }
    if (!end_line() || !next() || !expect("outer") || !expect("loop") || !end_line()) return false;
    for (int corner = 0; corner < 3; ++corner)
      if (!next() || !expect("vertex") || !read_corner() || !end_line()) return false;
    return next() && expect("endloop") && end_line() && next() && expect("endfacet") && end_line();
  }

  bool read_corner() {
    Vector<double, 3> point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = take_word(words_);
      if (word.empty()) return fail("a vertex has three coordinates, and there are " + std::to_string(axis));
      const auto value = parse_coordinate(word);
      if (!value) return fail(value.error());
      point[axis] = *value;
    }
    if (merger_.full()) return fail(std::string(kTooManyPoints));
    merger_.add(point);
    return true;
  }

  static bool is(std::string_view word, std::string_view keyword) { return lower_case(word) == keyword; }

  bool next() {
    if (!lines_.next_filled()) return fail("the file ends within a solid");
    words_ = lines_.line();
    return true;
  }
  bool expect(std::string_view keyword) {
    const std::string_view word = take_word(words_);
    return is(word, keyword) || fail("there is " + quoted(word) + " where " + quoted(keyword) + " should be");
  }
  bool end_line() {
    const std::string_view word = take_word(words_);
    return word.empty() || fail("there is " + quoted(word) + " where the line should end");
  }
  bool fail(std::string what) {
    error_ = at_line(lines_.number(), std::move(what)).value();
    return false;
  }

  Lines lines_;
  std::string_view words_;
  CornerMerger merger_;
  InputError error_;
};

}  // namespace

Read<PointFile> read_stl_text(std::string_view text) { return StlTextReader(text).read(); }

}  // namespace snug::io
