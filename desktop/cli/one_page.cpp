// A package as one HTML file that opens without a server: browsers load no module and no data from beside such a file.
#include <tuple>

#include "desktop/cli/one_script.hpp"
#include "desktop/cli/package_contents.hpp"

namespace snug::desktop {
namespace {

/// The page while its links are replaced by what they lead to.
class OnePage {
 public:
  explicit OnePage(const SiteFiles& files) : files_(files), html_(files.at("index.html")) {}

  tl::expected<std::string, InputError> made() {
    for (const char* style : {"style.css", "course.css", "packaged.css"}) {
      const std::string text = with_fonts(files_.at(style));
      put("<link rel=\"stylesheet\" href=\"" + std::string(style) + "\">", "<style>" + text + "</style>");
      styles_ += ' ' + policy_hash_of(text);
    }
    const auto modules = one_script(files_, "main.js");
    if (!modules) return tl::unexpected(modules.error());
    put("<script src=\"boot.js\"></script>", script(files_.at("boot.js")) + "\n" + script(files_.at("inside.js")));
    put("<script type=\"module\" src=\"main.js\"></script>", "");
    put("href=\"icon.svg\"", "href=\"data:image/svg+xml;base64," + base64_of(files_.at("icon.svg")) + '"');
    drop_links("<link rel=\"modulepreload\"");
    drop_links("<link rel=\"preload\"");
    put("</body>", table() + script(*modules, " type=\"module\"") + "\n</body>");
    replace_policy();
    if (missing_.empty()) return std::move(html_);
    return tl::unexpected(
        InputError{.what = "cannot be put into one file: it has no " + missing_, .file = "index.html"});
  }

 private:
  void put(const std::string& what, const std::string& by) {
    const std::size_t at = html_.find(what);
    if (at == std::string::npos) missing_ = what;
    else html_.replace(at, what.size(), by);
  }

  void drop_links(std::string_view begin) {
    for (std::size_t at = 0; (at = html_.find(begin)) != std::string::npos;)
      html_.erase(at, html_.find('\n', at) + 1 - at);
  }

  /// An inline script, which the policy will name. What would end the element stands in strings alone.
  std::string script(std::string text, const char* type = "") {
    for (const std::string_view end : {"</script", "<!--"})
      for (std::size_t at = 0; (at = text.find(end, at)) != std::string::npos; at += 2) text.insert(at + 1, 1, '\\');
    scripts_ += ' ' + policy_hash_of(text);
    return std::string("<script") + type + '>' + text + "</script>";
  }

  std::string with_fonts(std::string css) const {
    constexpr std::string_view kBegin = "url(fonts/";
    for (std::size_t at = 0; (at = css.find(kBegin, at)) != std::string::npos; ++at) {
      const std::size_t end = css.find(')', at);
      const std::string path = css.substr(at + 4, end - at - 4);
      css.replace(at, end - at,
                  "url(data:font/" + path.substr(path.size() - 3) + ";base64," + base64_of(files_.at(path)));
    }
    return css;
  }

  /// What the page would fetch, for inside.js: packed, but pictures as they are.
  [[nodiscard]] std::string table() const {
    std::string table;
    for (const auto& [path, bytes] : files_) {
      const bool picture = path.ends_with(".png");
      if (path.ends_with(".js") || path.ends_with(".css") || path.ends_with(".html") || path.ends_with(".svg"))
        continue;
      table += "<script type=\"text/plain\" id=\"file:" + path + "\">" + base64_of(picture ? bytes : gzip_of(bytes)) +
               "</script>\n";
    }
    return table;
  }

  /// The page's own rules, with these scripts and styles by their hashes in the place of files.
  void replace_policy() {
    for (const auto& [what, by] : {std::pair<std::string, std::string>{"script-src 'self'", "script-src" + scripts_},
                                   {"style-src 'self'", "style-src" + styles_},
                                   {"font-src 'self'", "font-src data:"},
                                   {"img-src 'self'", "img-src data:"},
                                   {"connect-src 'self'", "connect-src 'none'"},
                                   {"frame-src 'self'", "frame-src 'none'"}})
      put(what, by);
  }

  const SiteFiles& files_;
  std::string html_, scripts_, styles_, missing_;
};

}  // namespace

tl::expected<std::string, InputError> one_page_of(const PackageContents& contents) {
  return OnePage(contents.files).made();
}

}  // namespace snug::desktop
