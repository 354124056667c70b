#include "desktop/cli/measured_points.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "desktop/cli/timing.hpp"
#include "desktop/cli/words.hpp"
#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"

namespace snug::desktop {
namespace {

/// More points would take minutes, and more memory than some machines have.
constexpr Index kMostMeasured = 2'000'000;

tl::unexpected<InputError> refused(std::string what, std::string file = {}) {
  return tl::unexpected(InputError{.what = std::move(what), .file = std::move(file)});
}

tl::expected<MeasuredPoints, InputError> generated(const PointsChoice& choice) {
  const std::size_t colon = choice.generate.find(':');
  const std::string kind = choice.generate.substr(0, colon);
  const std::string count = colon == std::string::npos ? "" : choice.generate.substr(colon + 1);
  const auto known = generator_kinds();
  if (std::find(known.begin(), known.end(), kind) == known.end())
    return refused("there is no kind of points \"" + kind + "\"; known: " + joined(generator_kinds()));
  Index n = 0;
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), n);
  if (error != std::errc{} || end != count.data() + count.size() || n < 1 || n > kMostMeasured)
    return refused("--generate takes KIND:N with a whole number N from 1 to " + std::to_string(kMostMeasured));
  const int dim = choice.dim == 0 ? 3 : choice.dim;
  return MeasuredPoints{choice.generate, kind,
                        cost::PointStock(kind, dim, choice.scalar == "float", choice.seed).of(n)};
}

/// Sets the format by the file's ending; standard output and .txt leave it to the flags.
std::optional<InputError> set_format(TableOutput& output) {
  const std::string ending = is_standard_output(output.file) ? "" : ending_of(output.file);
  if (ending != "csv" && ending != "json") {
    if (ending.empty() || ending == "txt") return std::nullopt;
    return InputError{.what = "has none of the endings .csv, .json and .txt, which say the format",
                      .file = output.file};
  }
  if (ending == "csv" ? output.json : output.csv)
    return InputError{.what = "ends in ." + ending + ", and another format was asked for", .file = output.file};
  (ending == "csv" ? output.csv : output.json) = true;
  return std::nullopt;
}

}  // namespace

void add_points(CLI::App& command, PointsChoice& choice) {
  command.add_option("--generate", choice.generate, "N points of a kind, KIND:N; kinds: " + joined(generator_kinds()));
  command.add_option("FILE", choice.file, "Point file, as for snug fit; - is xyz on standard input");
  add_reading(command, choice.reading);
  command.add_option("--scalar", choice.scalar, "Number type: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", choice.dim, "2 or 3; by default that of the file, or 3")->transform(whole_number(2, 3));
  command.add_option("--seed", choice.seed, "Seed of the points and of random orders")
      ->transform(whole_number(0, std::numeric_limits<std::int64_t>::max()))
      ->capture_default_str();
}

tl::expected<MeasuredPoints, InputError> points_of(const PointsChoice& choice) {
  if (choice.generate.empty() == choice.file.empty()) return refused("give either --generate KIND:N or FILE");
  if (!choice.generate.empty()) return generated(choice);
  auto points = read_point_file(choice.file, choice.reading).and_then([&](const io::PointFile& file) {
    return io::to_point_set(file, choice.file, choice.dim, choice.scalar == "float");
  });
  if (!points) return tl::unexpected(points.error());
  if (fit::count_of(*points) > kMostMeasured)
    return refused("there are " + std::to_string(fit::count_of(*points)) +
                       " points, and costs are measured on at most " + std::to_string(kMostMeasured),
                   choice.file);
  return MeasuredPoints{choice.file, "", std::move(*points)};
}

cost::Provenance provenance_of(const PointsChoice& choice, const MeasuredPoints& points) {
  cost::Provenance provenance = native_provenance();
  provenance.points = points.name;
  provenance.scalar = choice.scalar;
  provenance.dim = fit::dim_of(points.points);
  provenance.seed = static_cast<std::int64_t>(choice.seed);
  return provenance;
}

void add_output(CLI::App& command, TableOutput& output) {
  command.add_flag("--json", output.json, "Print one JSON object");
  command.add_flag("--csv", output.csv, "Print CSV");
  command.add_option("-o", output.file, "File to write, in the format of its ending; - is standard output");
}

CommandResult write_table(TableOutput output,
                          const std::function<tl::expected<Printed, InputError>(const TableOutput&)>& measure) {
  if (auto wrong = set_format(output)) return bad_input(std::move(*wrong));
  if (output.csv && output.json) return bad_input("give only one of --json and --csv");
  std::optional<NewFile> file;
  if (!output.file.empty() && !is_standard_output(output.file)) {
    auto created = NewFile::create(output.file);
    if (!created) return bad_input(created.error());
    file.emplace(std::move(*created));
  }
  auto done = measure(output);
  if (!done) return bad_input(done.error());
  if (!file) return std::move(*done);
  file->write(done->text);
  if (const auto placed = file->put_in_place(); !placed) return bad_input(placed.error());
  return Printed{"", done->status};
}

}  // namespace snug::desktop
