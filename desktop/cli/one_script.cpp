#include "desktop/cli/one_script.hpp"

#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

constexpr std::string_view kOf = "modules";  // what the modules export, by their paths

bool take(std::string_view& rest, std::string_view word) {
  if (!rest.starts_with(word)) return false;
  rest.remove_prefix(word.size());
  return true;
}

std::string_view take_until(std::string_view& rest, std::string_view end) {
  const std::size_t at = rest.find(end);
  const std::string_view part = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + end.size());
  return part;
}

std::string in_quotes(std::string_view path) { return '"' + std::string(path) + '"'; }

class Linker {
 public:
  explicit Linker(const SiteFiles& files) : files_(files) {}

  tl::expected<void, InputError> add(const std::string& path) {
    if (done_.count(path) != 0) return {};
    if (!open_.insert(path).second) return wrong(path, 0, "imports itself by way of others");
    const auto found = files_.find(path);
    if (found == files_.end()) return wrong(path, 0, "is imported, and is not there");
    std::istringstream lines(found->second);
    std::string line, body, exported;
    for (int number = 1; std::getline(lines, line); ++number) {
      const auto own = line_of(path, number, line, exported);
      if (!own) return tl::unexpected(own.error());
      body += *own + '\n';
    }
    script_ +=
        std::string(kOf) + '[' + in_quotes(path) + "] = (() => {\n" + body + "return { " + exported + "};\n})();\n";
    done_.insert(path);
    return {};
  }

  [[nodiscard]] std::string script() const { return "const " + std::string(kOf) + " = {};\n" + script_; }

 private:
  static tl::unexpected<InputError> wrong(const std::string& path, int line, const char* what) {
    return tl::unexpected(InputError{what, path, line > 0 ? InputError::Unit::kLine : InputError::Unit::kNone, line});
  }

  /// A line as it stands in the one script. exported: gets the names that it exports.
  tl::expected<std::string, InputError> line_of(const std::string& path, int number, const std::string& line,
                                                std::string& exported) {
    std::string_view rest = line;
    if (take(rest, "import {")) {
      const std::string names(take_until(rest, "} from \"./"));
      const std::string from(take_until(rest, "\";"));
      if (from.empty() || !rest.empty()) return wrong(path, number, "has an import that is not on one line");
      return add(from).map([&] {
        return "const {" + replaced(names, " as ", ": ") + "} = " + std::string(kOf) + '[' + in_quotes(from) + "];";
      });
    }
    if (take(rest, "export default ")) {
      exported += "default: " + std::string(take_until(rest, ";")) + ", ";
      return std::string();
    }
    if (take(rest, "export ")) {
      std::string_view declared = rest;
      take(declared, "async ");
      if (!take(declared, "function ") && !take(declared, "class ") && !take(declared, "const "))
        return wrong(path, number, "exports something that is not declared there");
      std::size_t end = 0;
      while (end < declared.size() && (std::isalnum(static_cast<unsigned char>(declared[end])) || declared[end] == '_'))
        ++end;
      exported += std::string(declared.substr(0, end)) + ", ";
      return later(path, number, std::string(rest));
    }
    constexpr std::string_view kPacked = "export{";  // libraries' files end in it
    if (const std::size_t at = line.rfind(kPacked); at != std::string::npos && line.ends_with("};")) {
      std::string_view names(line.data() + at + kPacked.size(), line.size() - at - kPacked.size() - 2);
      while (!names.empty()) {
        std::string_view by = take_until(names, ",");
        const std::string own(take_until(by, " as "));
        exported += by.empty() ? own + ", " : std::string(by) + ": " + own + ", ";
      }
      return later(path, number, line.substr(0, at));
    }
    if (take(rest, "import ") || take(rest, "import{")) return wrong(path, number, "has an import that is not by name");
    return later(path, number, line);
  }

  /// What is loaded later by a name that stands there is in the script, if the package has it.
  tl::expected<std::string, InputError> later(const std::string& path, int number, std::string line) {
    constexpr std::string_view kLater = "import(\"./";
    for (std::size_t at = 0; (at = line.find(kLater, at)) != std::string::npos;) {
      const std::size_t end = line.find("\")", at);
      if (end == std::string::npos) return wrong(path, number, "has an import that is not on one line");
      const std::string from = line.substr(at + kLater.size(), end - at - kLater.size());
      if (files_.count(from) == 0) return line;  // the package never asks for it
      if (const auto added = add(from); !added) return tl::unexpected(added.error());
      const std::string by = "Promise.resolve(" + std::string(kOf) + '[' + in_quotes(from) + "])";
      line.replace(at, end + 2 - at, by);
      at += by.size();
    }
    return line;
  }

  const SiteFiles& files_;
  std::set<std::string> open_, done_;
  std::string script_;
};

}  // namespace

tl::expected<std::string, InputError> one_script(const SiteFiles& files, const std::string& path) {
  Linker linker(files);
  return linker.add(path).map([&] { return linker.script(); });
}

}  // namespace snug::desktop
