#include <algorithm>
#include <array>

#include "io/formats.hpp"

namespace snug::io {
namespace {

constexpr std::string_view kKeywords[] = {
    "v",      "vt",     "vn",   "vp",     "cstype", "deg",  "bmat",  "step",     "p",          "l",
    "f",      "fo",     "curv", "curv2",  "surf",   "parm", "trim",  "hole",     "scrv",       "sp",
    "end",    "con",    "g",    "s",      "mg",     "o",    "bevel", "c_interp", "d_interp",   "lod",
    "usemtl", "mtllib", "call", "maplib", "usemap", "csh",  "ctech", "stech",    "shadow_obj", "trace_obj"};

/// Statements of a keyword and a name. The name may end in a backslash, because exporters write Windows folders there.
constexpr std::string_view kNamed[] = {"o", "g", "mtllib", "usemtl", "maplib", "usemap", "shadow_obj", "trace_obj"};

/// Splits the text into statements. Lines joined by a backslash are one statement, with the first line's number. A
/// comment ends a line before it can be joined, and a name is not continued.
class Statements {
 public:
  explicit Statements(std::string_view text) : lines_(text) {}

  bool next() {
    if (!lines_.next()) return false;
    number_ = lines_.number();
    statement_ = without_comment(lines_.line());
    lost_ = false;
    if (goes_on(statement_) && !is_named(statement_)) join();
    return true;
  }
  [[nodiscard]] std::string_view statement() const { return statement_; }
  [[nodiscard]] std::int64_t line() const { return number_; }
  /// Whether a line that was joined begins a statement of its own, which would be lost.
  [[nodiscard]] bool loses_one() const { return lost_; }

 private:
  static bool goes_on(std::string_view line) { return !line.empty() && line.back() == '\\'; }
  static bool is_named(std::string_view line) {
    const std::string_view keyword = take_word(line);
    return std::find(std::begin(kNamed), std::end(kNamed), keyword) != std::end(kNamed);
  }

  void join() {
    joined_ = statement_;
    while (goes_on(joined_)) {
      joined_.back() = ' ';
      if (!lines_.next()) break;
      std::string_view next = lines_.line();
      lost_ = lost_ || is_obj_keyword(take_word(next));
      joined_.append(without_comment(lines_.line()));
    }
    statement_ = joined_;
  }
  Lines lines_;
  std::string_view statement_;
  std::string joined_;
  std::int64_t number_ = 0;
  bool lost_ = false;
};

class ObjReader {
 public:
  explicit ObjReader(const Wanted& wanted) : wanted_(wanted) {}

  Read<PointFile> read(std::string_view text) {
    for (Statements statements(text); statements.next();) {
      std::string_view rest = statements.statement();
      const std::string_view keyword = take_word(rest);
      if (keyword.empty()) continue;
      line_ = statements.line();
      if (statements.loses_one())
        return at_line(line_, "the line ends in a backslash, and the next line is a statement of its own");
      std::string wrong;
      if (keyword == "v") wrong = add_vertex(rest);
      if (keyword == "f") wrong = add_face(rest);
      if (keyword == "f" && !wanted_.faces && !wrong.empty()) pass_over(file_, Passed::kDamaged);
      else if (!wrong.empty()) return at_line(line_, wrong);
      if (is_obj_keyword(keyword)) continue;
      if (unknown_.what.empty()) unknown_ = at_line(line_, quoted(keyword) + " is not a statement of OBJ").value();
      pass_over(file_, Passed::kStatements);
    }
    if (file_.points.empty() && !unknown_.what.empty()) return tl::unexpected(unknown_);
    if (!wanted_.faces) {
      file_.triangles.clear();
      pass_over(file_, Passed::kDamaged,
                std::count_if(ahead_.begin(), ahead_.end(), [&](auto largest) { return largest > vertices(); }));
    } else if (largest_ > vertices()) {
      return at_line(line_of_largest_, out_of_range(largest_));
    }
    return std::move(file_);
  }

 private:
  [[nodiscard]] std::int64_t vertices() const { return static_cast<std::int64_t>(file_.points.size()); }

  [[nodiscard]] std::string out_of_range(std::int64_t reference) const {
    return "the face names vertex " + std::to_string(reference) + ", and there " + (vertices() == 1 ? "is " : "are ") +
           std::to_string(vertices());
  }

  /// Reads x y z, and perhaps a weight or a colour, which are passed over. Returns what is wrong, or an empty text.
  std::string add_vertex(std::string_view rest) {
    Vector<double, 3> point;
    int count = 0;
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      if (count >= 3) continue;
      const auto value = parse_coordinate(word, wanted_.skip_nan);
      if (!value) return value.error();
      point[count] = *value;
    }
    if (count < 3) return "a vertex has three coordinates, and there are " + counted(count, "number");
    if (file_.points.size() == kMostPoints) return std::string(kTooManyPoints);
    if (count > 3) pass_over(file_, Passed::kColumns);
    file_.points.push_back(point);
    return {};
  }

  /// Returns what is wrong, or an empty text.
  std::string add_face(std::string_view rest) {
    std::array<Index, 3> corners{};
    int count = 0;
    Index largest = 0;
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      const auto index = index_of(word);
      if (!index) return index.error();
      largest = std::max(largest, *index);
      corners[std::min(count, 2)] = *index;
      if (count < 2) continue;
      file_.triangles.push_back(corners);
      corners[1] = corners[2];
    }
    if (count < 3) pass_over(file_, Passed::kFaces);
    if (largest >= vertices() && !wanted_.faces) ahead_.push_back(std::int64_t{largest} + 1);
    return {};
  }

  /// The vertex that "v", "v/vt", "v//vn" or "v/vt/vn" names. It may still be to come: that is checked at the end.
  tl::expected<Index, std::string> index_of(std::string_view word) {
    const auto reference = parse_integer(word.substr(0, word.find('/')));
    if (!reference) return tl::unexpected(quoted(word) + " does not name a vertex");
    if (*reference == 0) return tl::unexpected(std::string("the face names vertex 0, and counting starts at 1"));
    if (*reference < -vertices() || *reference > static_cast<std::int64_t>(kMostPoints))
      return tl::unexpected(out_of_range(*reference));
    if (*reference < 0) return static_cast<Index>(vertices() + *reference);
    if (*reference > largest_) {
      largest_ = *reference;
      line_of_largest_ = line_;
    }
    return static_cast<Index>(*reference - 1);
  }

  Wanted wanted_;
  PointFile file_;
  std::int64_t line_ = 0;
  std::int64_t largest_ = 0;
  std::int64_t line_of_largest_ = 0;
  std::vector<std::int64_t> ahead_;  // for each face that names vertices still to come, the last of them
  InputError unknown_;               // the first statement that is not OBJ's
};

}  // namespace

bool is_obj_keyword(std::string_view word) {
  return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
}

Read<PointFile> read_obj(std::string_view text, const Wanted& wanted) { return ObjReader(wanted).read(text); }

}  // namespace snug::io
