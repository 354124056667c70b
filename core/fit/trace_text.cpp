// A trace as text: the names of its facts, its hash and its lines of JSON, all from the fields that facts list.
#include <array>

#include "fit/catalogue.hpp"
#include "fit/field_hash.hpp"
#include "fit/update/updates.hpp"
#include "geometry/volume_fields.hpp"
#include "trace/json.hpp"

namespace snug::fit {
namespace {

using Fact = Step3::Fact;

template <std::size_t... kAt>
constexpr auto names_of(std::index_sequence<kAt...>) {
  return std::array<std::string_view, sizeof...(kAt)>{std::variant_alternative_t<kAt, Fact>::kName...};
}
constexpr auto kFactNames = names_of(std::make_index_sequence<std::variant_size_v<Fact>>{});

/// The fields of a step and its volume, by name.
class Json {
 public:
  explicit Json(int dim) : dim_(dim) { writer_.open_object(); }

  void operator()(std::string_view name, const auto& value) {
    writer_.key(name);
    put(value);
  }

  void put(std::string_view value) { writer_.text(value); }
  void put(int value) { writer_.number(value); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put(Enum value) { put(static_cast<int>(value)); }
  void put(bool value) { writer_.flag(value); }
  void put(double value) { writer_.number(value); }
  void put(const Support& support) {
    put_list(support.size(), [&](int i) { put(support[i]); });
  }
  template <class Item>
  void put(const std::vector<Item>& items) {
    put_list(static_cast<int>(items.size()), [&](int i) { put(items[i]); });
  }
  void put(const std::array<Index, 3>& indices) {
    put_list(dim_, [&](int i) { put(indices[i]); });
  }
  void put(const Vector<double, 3>& v) {
    put_list(dim_, [&](int i) { put(v[i]); });
  }
  void put(const Matrix<double, 3>& m) {
    put_list(dim_, [&](int row) { put_list(dim_, [&](int column) { put(m(row, column)); }); });
  }
  template <class VolumeType>
  auto put(const VolumeType& volume) -> decltype(fields_of(volume, *this)) {
    writer_.open_object();
    fields_of(volume, *this);
    writer_.close_object();
  }

  [[nodiscard]] std::string finish() {
    writer_.close_object();
    return writer_.take();
  }

 private:
  template <class Item>
  void put_list(int n, Item&& item) {
    writer_.open_list();
    for (int i = 0; i < n; ++i) item(i);
    writer_.close_list();
  }
  JsonWriter writer_;
  int dim_;
};

/// Writes one eigenvector in each row; in 2-D without the added axis, which lift puts first.
void put_axes(Json& json, const AxesFound<double, 3>& fact, int dim) {
  Matrix<double, 3> rows = Matrix<double, 3>::Zero();
  Vector<double, 3> variances = Vector<double, 3>::Zero();
  rows.topRows(dim) = fact.axes.rightCols(dim).transpose();
  variances.head(dim) = fact.variances.tail(dim);
  json("mean", fact.mean);
  json("axes", rows);
  json("variances", variances);
}

std::string_view volume_key(const Volume3& volume) {
  return std::holds_alternative<Sphere3>(volume) ? "ball" : kVolumeNames[volume.index()];
}

/// The fields that every step begins with.
Json json_of_step(std::string_view name, int line, const Volume3* volume, int dim) {
  Json json(dim);
  json("step", name);
  json("line", line);
  if (volume != nullptr) std::visit([&](const auto& kind) { json(volume_key(*volume), kind); }, *volume);
  return json;
}

}  // namespace

std::string_view name_of(const Step3& step) { return kFactNames[step.fact.index()]; }

std::span<const std::string_view> fact_names() { return kFactNames; }

std::uint64_t hash_of(std::span<const Recorder<Step3>::Entry> steps) { return hash_of_steps(steps); }

std::string json_of(const Step3& step, int dim) {
  Json json = json_of_step(name_of(step), step.line, step.has_volume ? &step.volume : nullptr, dim);
  if (const auto* axes = std::get_if<AxesFound<double, 3>>(&step.fact)) put_axes(json, *axes, dim);
  else std::visit([&](const auto& fact) { see_fields(fact, json); }, step.fact);
  return json.finish();
}

std::string json_of(const UpdateStep3& step, int dim) {
  const std::string_view name = std::visit([](const auto& fact) { return std::string_view(fact.kName); }, step.fact);
  Json json = json_of_step(name, step.line, step.has_volume ? &step.volume : nullptr, dim);
  std::visit([&](const auto& fact) { see_fields(fact, json); }, step.fact);
  return json.finish();
}

}  // namespace snug::fit
