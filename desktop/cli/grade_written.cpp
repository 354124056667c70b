#include "desktop/cli/grade_written.hpp"

#include <algorithm>

#include "desktop/cli/files.hpp"
#include "desktop/cli/lab_check.hpp"
#include "desktop/cli/temporary_folder.hpp"
#include "desktop/cli/write_js.hpp"

namespace snug::desktop {
namespace {

/// The marks of a lab's code, in a file of its own.
tl::expected<write::Judged, std::string> judge_lab(const Lab& lab, const std::string& code, std::uint64_t seed) {
  const TemporaryFolder folder;
  if (folder.path().empty()) return tl::unexpected(std::string("there is no room for a temporary folder"));
  const std::string source = folder.path() + '/' + std::string(lab.name) + ".cpp";
  const auto checked = write_file(source, code).and_then([&] { return check_lab(lab, source, seed, false); });
  if (!checked) return tl::unexpected(checked.error().what);
  return checked->judged;
}

}  // namespace

GradedCode grade_written(const Claimed& claimed, const std::string& version) {
  const std::string& id = claimed.attempt.exercise;
  const bool in_js = id.starts_with(kWritePrefix);
  const Lab* lab = in_js ? nullptr : find_lab(id.substr(std::min(id.size(), kLabPrefix.size())));
  const write::Function* function = in_js ? write::find_function(id.substr(kWritePrefix.size()))
                                    : lab ? write::find_function(lab->function)
                                          : nullptr;
  if (function == nullptr) return {"foreign", "there is no such exercise here"};
  if (write::hash_of(*function) != claimed.attempt.hash)
    return {status_of_another(version), "its cases were others when this was done"};
  const std::uint64_t seed = claimed.attempt.seed;
  const auto judged =
      in_js ? judge_js(*function, {*claimed.code}, seed).map([](const auto& all) { return all.front().judged; })
            : judge_lab(*lab, *claimed.code, seed);
  if (!judged) return {"damaged", judged.error(), 0, static_cast<int>(function->kinds.size())};
  GradedCode graded{"ok", "", static_cast<double>(judged->mark()), judged->of()};
  if (claimed.saw_solution) graded.mark = std::min(graded.mark, static_cast<double>(graded.of / 2));
  return graded;
}

}  // namespace snug::desktop
