#include "lesson/subjects/pair/axis_rows.hpp"

#include <algorithm>

#include "lesson/subjects/pair/pair.hpp"

namespace snug::lesson {
namespace {

/// Collects the terms of a row's formulas, and the numbers in them.
class RowTerms {
 public:
  RowTerms(int dim, const AxisName& axis) : dim_(dim) {
    if (axis.kind == query::AxisKind::kFaceA) face_a(axis.i);
    else if (axis.kind == query::AxisKind::kFaceB) face_b(axis.j);
    else edges(axis.i, axis.j);
  }

  RowFormulas formulas;
  RowEntries entries;

 private:
  static std::string indexed(char letter, int i) { return std::string(1, letter) + '_' + std::to_string(i + 1); }
  std::string t(int i) {
    entries.translation |= static_cast<std::uint8_t>(1 << i);
    return indexed('t', i);
  }
  std::string half(char box, int i) {
    (box == 'a' ? entries.half_a : entries.half_b) |= static_cast<std::uint8_t>(1 << i);
    return indexed(box, i);
  }
  std::string r(int i, int j) {
    entries.rotation |= static_cast<std::uint16_t>(1 << (3 * i + j));
    return "R_{" + std::to_string(i + 1) + std::to_string(j + 1) + '}';
  }
  /// The absolute value of an entry, in the formula of a radius. of: the entries that this radius takes.
  std::string size(int i, int j, std::uint16_t& of) {
    of |= static_cast<std::uint16_t>(1 << (3 * i + j));
    return "|" + r(i, j) + "|";
  }
  static void add(std::string& sum, const std::string& term) { sum += (sum.empty() ? "" : " + ") + term; }

  void face_a(int i) {
    formulas.distance = "|" + t(i) + "|";
    formulas.radius_a = half('a', i);
    for (int j = 0; j < dim_; ++j) add(formulas.radius_b, half('b', j) + size(i, j, entries.rotation_b));
  }
  void face_b(int j) {
    std::string sum;
    for (int i = 0; i < dim_; ++i) add(sum, t(i) + r(i, j));
    formulas.distance = "|" + sum + "|";
    for (int i = 0; i < dim_; ++i) add(formulas.radius_a, half('a', i) + size(i, j, entries.rotation_a));
    formulas.radius_b = half('b', j);
  }
  void edges(int i, int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const int j1 = std::min((j + 1) % 3, (j + 2) % 3), j2 = std::max((j + 1) % 3, (j + 2) % 3);
    formulas.distance = "|" + t(i2) + r(i1, j) + " - " + t(i1) + r(i2, j) + "|";
    const int low = std::min(i1, i2), high = std::max(i1, i2);
    std::uint16_t &a = entries.rotation_a, &b = entries.rotation_b;
    formulas.radius_a = half('a', low) + size(high, j, a) + " + " + half('a', high) + size(low, j, a);
    formulas.radius_b = half('b', j1) + size(i, j2, b) + " + " + half('b', j2) + size(i, j1, b);
  }

  int dim_;
};

RowTerms terms_of(int dim, int place) { return {dim, axis_names(dim)[place]}; }

}  // namespace

RowEntries row_entries(int dim, int place) { return terms_of(dim, place).entries; }
RowFormulas row_formulas(int dim, int place) { return terms_of(dim, place).formulas; }

int axis_of_mark(int dim, std::string_view mark) {
  const auto names = axis_names(dim);
  const auto found = std::find_if(names.begin(), names.end(), [&](const AxisName& name) { return name.text == mark; });
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

bool is_axis_mark(const Subject& subject, std::string_view mark) {
  return as<PairSubject>(subject) != nullptr && axis_of_mark(subject.dim(), mark) >= 0;
}

}  // namespace snug::lesson
