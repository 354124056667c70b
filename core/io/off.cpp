#include "io/formats.hpp"

namespace snug::io {
namespace {

/// Reads "OFF" (which may be missing), "the counts of vertices, faces and edges, the vertices, the faces", word by
/// word.
class OffReader {
 public:
  OffReader(std::string_view text, const Wanted& wanted) : lines_(text), wanted_(wanted) {}

  Read<PointFile> read() {
    skip_keyword();
    if (!take_count(vertices_) || !take_count(faces_)) return tl::unexpected(error_);
    rest_ = {};  // the count of edges is not used, and may be missing
    if (vertices_ > most()) return at_line(lines_.number(), claims(vertices_, "vertices"));
    if (faces_ > most()) return at_line(lines_.number(), claims(faces_, "faces"));
    file_.points.reserve(static_cast<std::size_t>(vertices_));
    for (std::int64_t i = 0; i < vertices_; ++i)
      if (!read_vertex()) return tl::unexpected(error_);
    for (std::int64_t i = 0; i < faces_; ++i)
      if (!read_face()) return tl::unexpected(error_);
    if (!wanted_.faces) file_.triangles.clear();
    while (next_line()) pass_over(file_, Passed::kLines);
    return std::move(file_);
  }

 private:
  void skip_keyword() {
    if (!next_line()) return;
    std::string_view after = rest_;
    if (lower_case(take_word(after)) == "off") rest_ = after;
  }
  [[nodiscard]] std::int64_t most() const { return static_cast<std::int64_t>(lines_.rest().size()) / 2 + 1; }
  static std::string claims(std::int64_t n, std::string_view what) {
    return "the file claims " + std::to_string(n) + " " + std::string(what) + ", and is too short for that";
  }

  bool next_line() {
    while (lines_.next_filled()) {
      rest_ = trim(without_comment(lines_.line()));
      if (!rest_.empty()) return true;
    }
    return false;
  }
  bool take(std::string_view& word) {
    if (trim(rest_).empty() && !next_line()) return fail("the file ends before all that it claims");
    word = take_word(rest_);
    return true;
  }
  bool take_count(std::int64_t& count) {
    std::string_view word;
    if (!take(word)) return false;
    const auto value = parse_integer(word);
    if (!value || *value < 0) return fail(quoted(word) + " is not a count");
    count = *value;
    return true;
  }

  bool read_vertex() {
    Vector<double, 3> point;
    for (int axis = 0; axis < 3; ++axis) {
      std::string_view word;
      if (!take(word)) return false;
      const auto value = parse_coordinate(word, wanted_.skip_nan);
      if (!value) return fail(value.error());
      point[axis] = *value;
    }
    if (!trim(rest_).empty()) return fail("there is more on the line than a vertex's three coordinates");
    if (file_.points.size() == kMostPoints) return fail(std::string(kTooManyPoints));
    file_.points.push_back(point);
    return true;
  }

  /// The rest of a face's line may be a colour, which is not used.
  bool read_face() {
    std::int64_t count = 0;
    if (!take_count(count)) return false;
    std::array<Index, 3> corners{};
    std::string wrong;
    for (std::int64_t i = 0; i < count; ++i) {
      std::string_view word;
      if (!take(word)) return false;
      const auto index = parse_integer(word);
      if (!index) wrong = quoted(word) + " does not name a vertex";
      else if (*index < 0 || *index >= vertices_)
        wrong = "the face names vertex " + std::to_string(*index) + ", counted from 0, and there are " +
                std::to_string(vertices_);
      if (!wrong.empty() && wanted_.faces) return fail(wrong);
      if (!wrong.empty()) continue;
      corners[static_cast<std::size_t>(i < 2 ? i : 2)] = static_cast<Index>(*index);
      if (i < 2) continue;
      file_.triangles.push_back(corners);
      corners[1] = corners[2];
    }
    if (!wrong.empty()) pass_over(file_, Passed::kDamaged);
    else if (count < 3) pass_over(file_, Passed::kFaces);
    rest_ = {};
    return true;
  }

  bool fail(std::string what) {
    error_ = at_line(lines_.number(), std::move(what)).value();
    return false;
  }

  Lines lines_;
  Wanted wanted_;
  std::string_view rest_;
  std::int64_t vertices_ = 0, faces_ = 0;
  PointFile file_;
  InputError error_;
};

}  // namespace

Read<PointFile> read_off(std::string_view text, const Wanted& wanted) { return OffReader(text, wanted).read(); }

}  // namespace snug::io
