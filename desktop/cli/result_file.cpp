#include "desktop/cli/result_file.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

constexpr double kMostSeed = 0x1p53;  // what a page's numbers can hold

/// Whether a version, numbers with dots between them, comes before another.
bool is_before(const std::string& a, const std::string& b) {
  const auto parts = [](const std::string& version) {
    std::vector<int> numbers(1);
    for (const char c : version) {
      if (c == '.') numbers.push_back(0);
      else if (c >= '0' && c <= '9' && numbers.back() < 100'000) numbers.back() = 10 * numbers.back() + (c - '0');
    }
    return numbers;
  };
  return parts(a) < parts(b);
}

}  // namespace

const char* status_of_another(const std::string& version) {
  return is_before(version, SNUG_VERSION) ? "older" : is_before(SNUG_VERSION, version) ? "newer" : "foreign";
}

tl::expected<Claimed, std::string> attempt_of(const Json& json) {
  Claimed claimed;
  if (!json.is_object()) return tl::unexpected<std::string>("an attempt is no object");
  const Json* exercise = value_at(json, "exercise");
  const Json* hash = value_at(json, "hash");
  const Json* seed = value_at(json, "seed");
  const Json* decisions = value_at(json, "decisions");
  if (exercise == nullptr || !exercise->is_string()) return tl::unexpected<std::string>("\"exercise\" is no text");
  claimed.attempt.exercise = exercise->get<std::string>();
  const std::string digits = hash != nullptr && hash->is_string() ? hash->get<std::string>() : "";
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), claimed.attempt.hash, 16);
  if (digits.size() != 16 || error != std::errc() || end != digits.data() + digits.size())
    return tl::unexpected<std::string>("\"hash\" is not 16 hexadecimal digits");
  if (seed == nullptr || !seed->is_number_integer() || seed->get<double>() < 0 || seed->get<double>() > kMostSeed)
    return tl::unexpected<std::string>("\"seed\" is no whole number from 0 to 2^53");
  claimed.attempt.seed = seed->get<std::uint64_t>();
  if (const Json* level = value_at(json, "level"); level != nullptr) {
    if (!level->is_number_integer() || level->get<double>() < 0 || level->get<double>() > lesson::kMostLevels)
      return tl::unexpected<std::string>("\"level\" is no whole number from 0 to 9");
    claimed.attempt.level = level->get<int>();
  }
  if (decisions == nullptr || !decisions->is_array()) return tl::unexpected<std::string>("\"decisions\" is no list");
  for (const Json& one : *decisions) {
    if (!one.is_string()) return tl::unexpected<std::string>("a decision is no text");
    if (is_code(claimed.attempt.exercise)) {
      std::string code = one.get<std::string>();
      claimed.saw_solution = code.starts_with('?');
      code.erase(0, claimed.saw_solution ? 1 : 0);
      if (!code.starts_with(kCodeMark)) return tl::unexpected<std::string>("a decision is no code");
      claimed.code = code.substr(1);
      continue;
    }
    auto made = lesson::made_of(one.get<std::string>());
    if (!made) return tl::unexpected(made.error().what);
    claimed.attempt.made.push_back(*std::move(made));
  }
  if (is_code(claimed.attempt.exercise) && !claimed.code) return tl::unexpected<std::string>("it has no code");
  if (const Json* mark = value_at(json, "mark"); mark != nullptr && mark->is_number())
    claimed.mark = mark->get<double>();
  return claimed;
}

tl::expected<ResultFile, NoResult> read_result(std::string_view text) {
  if (text.empty()) return tl::unexpected(NoResult{false, "is empty"});
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return tl::unexpected(NoResult{false, "is not JSON"});
  const Json* format = value_at(json, "snug_result");
  if (format == nullptr || !format->is_number_integer()) return tl::unexpected(NoResult{true, "is no result file"});
  ResultFile file;
  constexpr std::uint64_t kMostFormat =
      std::numeric_limits<std::int64_t>::max();  // a larger one would wrap to an older
  file.format = format->is_number_unsigned()
                    ? static_cast<std::int64_t>(std::min(format->get<std::uint64_t>(), kMostFormat))
                    : format->get<std::int64_t>();
  if (const Json* version = value_at(json, "version"); version != nullptr && version->is_string())
    file.version = version->get<std::string>();
  if (const Json* student = value_at(json, "student"); student != nullptr && student->is_string())
    file.student = student->get<std::string>();
  const Json* attempts = value_at(json, "attempts");
  if (attempts == nullptr || !attempts->is_array()) return tl::unexpected(NoResult{false, "\"attempts\" is no list"});
  for (const Json& one : *attempts) file.attempts.push_back(attempt_of(one));
  if (const Json* sheets = value_at(json, "sheets"); sheets != nullptr && sheets->is_array())
    for (const Json& one : *sheets) file.sheets.push_back(sheet_of(one));
  return file;
}

Json json_of(const lesson::Attempt& attempt, double mark, int of) {
  Json decisions = Json::array();
  for (const lesson::Made& made : attempt.made) decisions.push_back(text_of(made));
  Json json{{"exercise", attempt.exercise}, {"hash", hex_of(attempt.hash)}, {"seed", attempt.seed}};
  if (attempt.level > 0) json["level"] = attempt.level;
  json.update({{"decisions", std::move(decisions)},
               {"hints", attempt.hints()},
               {"mark", mark},
               {"of", of},
               {"seconds", attempt.seconds()}});
  return json;
}

std::string result_text(const std::string& student, const std::vector<Json>& attempts,
                        const std::vector<Json>& sheets) {
  Json json{{"snug_result", kResultFormat}, {"version", SNUG_VERSION}, {"student", student}, {"attempts", attempts}};
  if (!sheets.empty()) json["sheets"] = sheets;
  return line_of(json);
}

}  // namespace snug::desktop
