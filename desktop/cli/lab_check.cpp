#include "desktop/cli/lab_check.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "desktop/cli/confined.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/temporary_folder.hpp"
#include "write/shape.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

constexpr std::array kLabs{
    Lab{"overlap", "overlap-min-max", "two axis-aligned boxes",
        "Two axis-aligned boxes are apart if their intervals along one of the axes are."},
    Lab{"ritter", "grow-sphere", "Ritter’s growing step",
        "Ritter’s sphere grows to each point that lies outside, and no more than it has to."},
    Lab{"sat", "sat", "the separating axis test",
        "Two oriented boxes are apart if one of fifteen axes separates them."},
    Lab{"pvertex", "p-and-n-vertex", "p-vertex and n-vertex",
        "To place a box beside a plane, two of its eight vertices are enough: the signs of the normal choose them."},
    Lab{"quickhull", "farthest-from-edge", "the farthest point from an edge",
        "Quickhull grows an edge to the point that lies farthest to its left, which is a vertex of the hull."},
    Lab{"welzl", "smallest-sphere", "the smallest enclosing sphere",
        "Welzl’s algorithm finds the smallest sphere that contains all points, in expected linear time."},
};

/// The first three lines in which the compiler names an error.
std::string errors_in(const std::string& text) {
  std::string found;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size() && count < 3;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (line.find("error") != std::string::npos && line.find("gmake") == std::string::npos)
      found += (count++ > 0 ? "; " : "") + line;
    at = end + 1;
  }
  return found.empty() ? text.substr(0, 300) : found;
}

/// What the machine lacks, by what CMake says of it.
std::string lacking(const std::string& text) {
  for (const auto& [says, means] : {std::pair{"CMAKE_MAKE_PROGRAM is not set", "make is not installed"},
                                    std::pair{"No CMAKE_CXX_COMPILER", "no compiler of C++ is installed (g++)"},
                                    std::pair{"snugConfig", "the core is not installed (libsnug-dev)"}})
    if (text.find(says) != std::string::npos) return means;
  return errors_in(text);
}

/// Where the core is installed, for CMake: beside this program, if it is, and where the environment says.
std::string prefix() {
  const fs::path own = data_folder().parent_path().parent_path();  // PREFIX/share/snug
  const char* given = std::getenv("CMAKE_PREFIX_PATH");
  return own.string() + (given != nullptr ? ';' + std::string(given) : "");
}

tl::expected<std::string, InputError> build(const Lab& lab, const std::string& source, const std::string& shop) {
  const Limits limits{.seconds = 300, .bytes = 4LL << 30, .confined = false};
  const fs::path from = data_folder() / "lab", to = shop;
  std::error_code error;
  for (const auto& [what, name] :
       {std::pair{from / "check.cmake", std::string("CMakeLists.txt")},
        std::pair{from / "driver.hpp", std::string("driver.hpp")},
        std::pair{from / lab.name / "driver.cpp", std::string("driver.cpp")},
        std::pair{from / lab.name / (std::string(lab.name) + ".hpp"), std::string(lab.name) + ".hpp"}}) {
    fs::copy_file(what, to / name, error);
    if (error) return tl::unexpected(InputError{.what = error.message(), .file = what.string()});
  }
  const fs::path own = fs::absolute(source, error);
  const Ended configured = run_within(
      limits,
      {"cmake", "-S", shop, "-B", shop + "/build", "-DSOURCE=" + own.string(), "-DCMAKE_PREFIX_PATH=" + prefix()}, "");
  if (configured.how == Ended::How::kDone && configured.status == 127)
    return tl::unexpected(InputError{.what = "cmake is not installed: the lab needs it, and a compiler"});
  if (configured.how != Ended::How::kDone || configured.status != 0)
    return tl::unexpected(
        InputError{.what = "the lab could not be set up: " + lacking(configured.err + configured.out)});
  const Ended built = run_within(limits, {"cmake", "--build", shop + "/build"}, "");
  if (built.how != Ended::How::kDone || built.status != 0) {
    const std::string says = built.how == Ended::How::kTime ? "it took too long" : errors_in(built.out + built.err);
    return tl::unexpected(InputError{.what = "it does not compile: " + says, .file = source});
  }
  return shop + "/build/check";
}

/// The line of the student's file that a sanitizer names first; empty if it names none.
std::string line_in(const std::string& text, const std::string& source) {
  const std::string name = fs::path(source).filename().string() + ':';
  const std::size_t at = text.find('/' + name);
  if (at == std::string::npos) return {};
  const std::size_t from = at + 1, digits = from + name.size();
  return text.substr(from, text.find_first_not_of("0123456789", digits) - from);
}

/// What the sanitizer found, in its words.
std::string found_in(const std::string& text) {
  for (const std::string_view mark : {"runtime error: ", "ERROR: AddressSanitizer: "})
    if (const std::size_t at = text.find(mark); at != std::string::npos) {
      const std::size_t from = at + mark.size();
      return text.substr(from, text.find_first_of(mark.front() == 'E' ? " \n" : "\n", from) - from);
    }
  return {};
}

/// How it ended; empty if it came to its end.
std::string ending(const Ended& ended, const Limits& limits, const std::string& source) {
  using How = Ended::How;
  if (ended.how == How::kDone && ended.status == 0) return {};
  if (ended.how == How::kTime)
    return "it took more than " + std::to_string(static_cast<int>(limits.seconds)) + " seconds";
  if (ended.how == How::kMemory) return "it took more than " + std::to_string(limits.bytes >> 20) + " MiB of memory";
  if (ended.how == How::kOutput) return "it printed too much";
  if (ended.how == How::kNotStarted) return "it could not be started";
  const std::string line = line_in(ended.err, source), found = found_in(ended.err);
  return "it crashed" + (line.empty() ? "" : " at " + line) + (found.empty() ? "" : ": " + found);
}

/// The built function, which is called with cases.
class Program {
 public:
  Program(std::string path, std::string source) : path_(std::move(path)), source_(std::move(source)) {}

  std::vector<write::Answered> answers(const std::vector<write::Numbers>& inputs) {
    const Ended ended = run_within(limits_, {path_}, write::number_lines(inputs),
                                   {"ASAN_OPTIONS=detect_leaks=0:abort_on_error=0:allocator_may_return_null=1",
                                    "UBSAN_OPTIONS=print_stacktrace=1"});
    ended_ = ending(ended, limits_, source_);
    std::vector<write::Answered> all = write::read_answers(ended.out, inputs.size());
    const auto answered = static_cast<std::size_t>(std::count(ended.out.begin(), ended.out.end(), '\n'));
    if (!ended_.empty() && answered < all.size()) all[answered] = tl::unexpected(ended_);
    return all;
  }
  [[nodiscard]] const std::string& ended() const { return ended_; }

 private:
  Limits limits_;
  std::string path_, source_, ended_;
};

/// Goes on to shorter inputs that fail, as long as there is one.
void shorten(const write::Function& function, Program& program, CounterExample& found) {
  constexpr int kMostRounds = 60;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<write::Numbers> inputs = write::shorter(function, found.input);
    if (inputs.empty()) return;
    const std::vector<write::Answered> answers = program.answers(inputs);
    const auto wrong = write::first_wrong(function, inputs, answers, write::shows(function, found.input, found.answer));
    if (!wrong) return;
    found.input = inputs[*wrong], found.answer = answers[*wrong];
  }
}

}  // namespace

std::span<const Lab> labs() { return kLabs; }

const Lab* find_lab(std::string_view name) {
  const auto* found = std::find_if(kLabs.begin(), kLabs.end(), [&](const Lab& one) { return one.name == name; });
  return found == kLabs.end() ? nullptr : found;
}

tl::expected<LabChecked, InputError> check_lab(const Lab& lab, const std::string& source, std::uint64_t seed,
                                               bool search) {
  const TemporaryFolder workshop;
  if (workshop.path().empty()) return tl::unexpected(InputError{.what = "there is no room for a temporary folder"});
  const auto built = build(lab, source, workshop.path());
  if (!built) return tl::unexpected(built.error());
  const write::Function& function = *write::find_function(lab.function);
  const std::vector<write::Case> cases = write::cases_of(function, seed);
  std::vector<write::Numbers> inputs;
  for (const write::Case& one : cases) inputs.push_back(one.input);
  Program program(*built, source);
  const std::vector<write::Answered> answers = program.answers(inputs);
  LabChecked checked{.judged = write::judge(function, cases, answers), .ended = program.ended()};
  if (!checked.judged.first) return checked;
  const std::size_t first = *checked.judged.first;
  checked.first = {std::string(function.kinds[static_cast<std::size_t>(cases[first].kind)].name), inputs[first],
                   answers[first]};
  if (!search) return checked;
  CounterExample shortest = *checked.first;
  shorten(function, program, shortest);
  if (shortest.input != checked.first->input) checked.shortest = std::move(shortest);
  return checked;
}

}  // namespace snug::desktop
