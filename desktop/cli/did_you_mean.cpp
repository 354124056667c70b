#include "desktop/cli/did_you_mean.hpp"

#include <algorithm>
#include <cctype>

namespace snug::desktop {
namespace {

char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// How many slips lie between two words (optimal string alignment). A capital in a small letter's place is none.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& here = least[i][j];
      if (i == 0 || j == 0) {
        here = i + j;
        continue;
      }
      const std::size_t wrong = small(a[i - 1]) == small(b[j - 1]) ? 0 : 1;
      here = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + wrong});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        here = std::min(here, least[i - 2][j - 2] + 1);
    }
  return least[a.size()][b.size()];
}

constexpr std::size_t kLongestWord = 64, kLettersOfSlip = 4;

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const auto says = [](const std::string& name) { return "; did you mean \"" + name + "\"?"; };
  if (word.size() < 2 || word.size() > kLongestWord) return {};
  const auto begins = [&](const std::string& name) { return name.starts_with(word); };
  const auto first = std::find_if(known.begin(), known.end(), begins);
  if (first != known.end() && std::count_if(first, known.end(), begins) == 1) return says(*first);
  const std::string* nearest = nullptr;
  // One letter in the place of another is no slip of it: "-x" is not meant as "-h".
  std::size_t least = std::max<std::size_t>(word.size() > 2 ? 1 : 0, word.size() / kLettersOfSlip) + 1;
  for (const std::string& name : known)
    if (const std::size_t apart = slips(word, name); apart < least) nearest = &name, least = apart;
  return nearest != nullptr ? says(*nearest) : std::string();
}

}  // namespace snug::desktop
