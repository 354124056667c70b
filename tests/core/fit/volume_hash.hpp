// A volume's numbers as one.
#pragma once

#include "fit/catalogue.hpp"

namespace snug::test {

/// The same, number by number: by what a trace's hash makes of them.
inline std::uint64_t hash_of(const fit::Volume3& volume) {
  const Recorder<fit::Step3>::Entry entry{{0, true, volume, fit::Finished{}}, {}};
  return fit::hash_of({&entry, 1});
}

}  // namespace snug::test
