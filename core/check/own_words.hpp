// Words of a question that are true only of the run that its author saw.
#pragma once

#include <string>
#include <string_view>

namespace snug::check {

/// The first such words of the text: "These boxes overlap", "these eight points", "780 pairs", "hundreds of". Empty for
/// none. A drag, a scatter or a mesh can make them false.
[[nodiscard]] std::string words_of_one_run(std::string_view text);

}  // namespace snug::check
