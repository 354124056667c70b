#include "lesson/decide.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace snug::lesson {

double extent_of(const Subject& subject) {
  if (subject.size() == 0) return 1;
  Point3 least = subject.at(0), greatest = least;
  for (Index i = 1; i < subject.size(); ++i)
    least = least.cwiseMin(subject.at(i)), greatest = greatest.cwiseMax(subject.at(i));
  const double length = (greatest - least).norm();
  return length > 0 ? length : 1;
}

double no_tie(const Asked&, const Run&) { return std::numeric_limits<double>::infinity(); }

int Scores::greatest() const { return of[std::max_element(values.begin(), values.end()) - values.begin()]; }
int Scores::least() const { return of[std::min_element(values.begin(), values.end()) - values.begin()]; }

std::vector<int> Scores::all_greatest() const {
  const double most = *std::max_element(values.begin(), values.end());
  std::vector<int> all;
  for (std::size_t i = 0; i < of.size(); ++i)
    if (values[i] == most) all.push_back(of[i]);
  return all;
}

double Scores::lead() const {
  if (values.size() < 2) return std::numeric_limits<double>::infinity();
  std::vector<double> sorted = values;
  std::partial_sort(sorted.begin(), sorted.begin() + 2, sorted.end(), std::greater<>());
  return sorted[0] - sorted[1];
}

SeveralChoices by_every_choice(const Asked& asked) {
  std::vector<int> all(asked.choices.size());
  std::iota(all.begin(), all.end(), 0);
  return {std::move(all)};
}

std::string choice_words(const Asked& asked, const std::vector<int>& choices) {
  std::string words;
  for (const int choice : choices) words += (words.empty() ? "" : ", ") + asked.choices[choice];
  return words;
}

SeveralHandles by_handles(std::vector<Index> handles) {
  std::sort(handles.begin(), handles.end());
  handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
  return {std::move(handles)};
}

}  // namespace snug::lesson
