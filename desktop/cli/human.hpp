// JSON Lines as people read them: a table, or for one object a list of its values.
#pragma once

#include <string>
#include <string_view>

namespace snug::desktop {

/// lines: objects, one a line; any other text comes back as it is. width: letters that a line may have: the widest
/// texts are cut to it, ids never; where that leaves them too little, columns such as "file" are left out, and a line
/// says how many. color: whether names stand out.
[[nodiscard]] std::string human_text(const std::string& lines, int width, bool color);

}  // namespace snug::desktop
