// Reading a trace: the names of its facts, its hash, its lines of JSON. All go over the fields that facts list.
#include <array>
#include <cstdio>

#include "fit/catalogue.hpp"
#include "fit/field_hash.hpp"
#include "fit/update/updates.hpp"
#include "geometry/volume_fields.hpp"

namespace snug::fit {
namespace {

using Fact = Step3::Fact;

template <std::size_t... kAt>
constexpr auto names_of(std::index_sequence<kAt...>) {
  return std::array<std::string_view, sizeof...(kAt)>{std::variant_alternative_t<kAt, Fact>::kName...};
}
constexpr auto kFactNames = names_of(std::make_index_sequence<std::variant_size_v<Fact>>{});

class Json {
 public:
  explicit Json(int dim) : dim_(dim) {}
  std::string text;

  void operator()(std::string_view name, const auto& value) {
    text += text.empty() ? "{\"" : ",\"";
    text.append(name) += "\":";
    put(value);
  }

  void put(std::string_view value) { (text += '"').append(value) += '"'; }
  void put(int value) { text += std::to_string(value); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put(Enum value) { put(static_cast<int>(value)); }
  void put(bool value) { text += value ? "true" : "false"; }
  void put(double value) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
    text += buffer.data();
  }
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
    Json fields(dim_);
    fields_of(volume, fields);
    text += fields.text + '}';
  }

 private:
  template <class Item>
  void put_list(int n, Item&& item) {
    text += '[';
    for (int i = 0; i < n; ++i) {
      if (i > 0) text += ',';
      item(i);
    }
    text += ']';
  }
  int dim_;
};

/// Eigenvectors one a row, and in 2-D without the added axis, which lift puts first.
void put_axes(Json& json, const AxesFound<double, 3>& fact, int dim) {
  Matrix<double, 3> rows = Matrix<double, 3>::Zero();
  Vector<double, 3> variances = Vector<double, 3>::Zero();
  rows.topRows(dim) = fact.axes.rightCols(dim).transpose();
  variances.head(dim) = fact.variances.tail(dim);
  json("mean", fact.mean), json("axes", rows), json("variances", variances);
}

std::string_view volume_key(const Volume3& volume) {
  return std::holds_alternative<Sphere3>(volume) ? "ball" : kVolumeNames[volume.index()];
}

/// What every step begins with.
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
  return json.text + '}';
}

std::string json_of(const UpdateStep3& step, int dim) {
  const std::string_view name = std::visit([](const auto& fact) { return std::string_view(fact.kName); }, step.fact);
  Json json = json_of_step(name, step.line, step.has_volume ? &step.volume : nullptr, dim);
  std::visit([&](const auto& fact) { see_fields(fact, json); }, step.fact);
  return json.text + '}';
}

}  // namespace snug::fit
