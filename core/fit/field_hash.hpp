// A hash over the fields that facts and volumes list: every bit of every number of a trace.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fit/fit.hpp"
#include "geometry/volume_fields.hpp"
#include "number/bits.hpp"
#include "number/fnv.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// Hashes each of the listed fields.
struct FieldHash : Fnv1a {
  void operator()(std::string_view, const auto& value) { add(value); }

  void add(std::int64_t value) { add_bits(static_cast<std::uint64_t>(value)); }
  void add(int value) { add(std::int64_t{value}); }
  void add(std::uint32_t value) { add(std::int64_t{value}); }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) { add(static_cast<std::int64_t>(value)); }
  void add(bool value) { add(std::int64_t{value}); }
  void add(double value) { add_bits(bits_of(value)); }
  void add(const Support& support) {
    add(support.size());
    for (const Index i : support) add(i);
  }
  template <class Item>
  void add(const std::vector<Item>& items) {
    add(static_cast<std::int64_t>(items.size()));
    for (const Item& item : items) add(item);
  }
  template <class VolumeType>
  auto add(const VolumeType& volume) -> decltype(fields_of(volume, *this)) {
    fields_of(volume, *this);
  }
  void add(const std::array<Index, 3>& indices) {
    for (const Index i : indices) add(i);
  }
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      for (Eigen::Index row = 0; row < matrix.rows(); ++row) add(static_cast<double>(matrix(row, column)));
  }
};

/// A hash over every number of every step, in order. entries: from a Recorder whose steps have a line and a variant of
/// facts, and may have a volume.
template <class Entry>
std::uint64_t hash_of_steps(std::span<const Entry> entries) {
  FieldHash hash;
  for (const Entry& entry : entries) {
    const auto& step = entry.step;
    hash.add(static_cast<std::int64_t>(step.fact.index()));
    hash.add(step.line);
    if constexpr (requires { step.volume; }) {
      hash.add(step.has_volume);
      std::visit([&](const auto& volume) { hash.add(volume); }, step.volume);
    }
    std::visit([&](const auto& fact) { see_fields(fact, hash); }, step.fact);
  }
  return hash.value();
}

}  // namespace snug::fit
