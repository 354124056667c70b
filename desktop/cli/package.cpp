// snug package: a lesson, an exercise, a set or the course, for a course's site, for any host, or as one file.
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "desktop/cli/command.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/package_contents.hpp"
#include "desktop/cli/words.hpp"
#include "io/text.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

struct PackageOptions {
  std::string what, zip, folder, one_file, site;
};

/// imsmanifest.xml. Source: ADL, SCORM 1.2 Content Aggregation Model, 2001.
std::string manifest_of(const PackageContents& contents) {
  const std::string title = "<title>" + xml_text(contents.title) + "</title>";
  std::string files;
  for (const auto& [path, bytes] : contents.files) files += "      <file href=\"" + xml_text(path) + "\"/>\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<manifest identifier=\"snug." +
         contents.id +
         "\" version=\"1.0\" xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\"\n"
         "    xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\">\n"
         "  <metadata><schema>ADL SCORM</schema><schemaversion>1.2</schemaversion></metadata>\n"
         "  <organizations default=\"snug\">\n"
         "    <organization identifier=\"snug\">" +
         title +
         "\n"
         "      <item identifier=\"item\" identifierref=\"page\">" +
         title +
         "</item>\n"
         "    </organization>\n"
         "  </organizations>\n"
         "  <resources>\n"
         "    <resource identifier=\"page\" type=\"webcontent\" adlcp:scormtype=\"sco\" href=\"index.html\">\n" +
         files +
         "    </resource>\n"
         "  </resources>\n"
         "</manifest>\n";
}

/// Where ./run builds the page, or an installation keeps it.
tl::expected<std::string, InputError> site_folder(const std::string& asked) {
  if (!asked.empty()) return asked;
  for (const fs::path& folder : {data_folder() / "site", data_folder() / "../wasm/site"}) {
    std::error_code error;
    if (fs::exists(folder / "index.html", error)) return folder.lexically_normal().string();
  }
  return tl::unexpected(InputError{.what =
                                       "the page is not built here: `./run package` builds it and goes on, and --site "
                                       "FOLDER leads to one that is"});
}

/// The signal that asked the program to end, for which an unfinished folder is removed first; else 0.
volatile std::sig_atomic_t asked_to_end = 0;
extern "C" void note_signal(int signal) { asked_to_end = signal; }

/// Writes files into a new folder. Errors: what went wrong, or nothing where a signal asked to end.
tl::expected<void, std::string> write_files(const fs::path& folder, const SiteFiles& files) {
  std::error_code error;
  for (const auto& [path, bytes] : files) {
    fs::create_directories((folder / path).parent_path(), error);
    if (error) return tl::unexpected(error.message());
    std::ofstream file(folder / path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) return tl::unexpected(std::string(std::strerror(errno)));
    if (asked_to_end != 0) return tl::unexpected(std::string());
  }
  return {};
}

/// Writes to a folder beside it first, so that it is whole or not there.
tl::expected<void, InputError> write_folder(fs::path folder, const SiteFiles& files) {
  if (!folder.has_filename()) folder = folder.parent_path();  // out/: the name beside it is out's, and not in it
  fs::path part = folder;
  part += "." + std::to_string(std::random_device{}()) + ".part";  // a name of nobody's
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  std::error_code error, ignored;
  auto written = write_files(part, files);
  if (written) fs::rename(part, folder, error);
  if (error) written = tl::unexpected(error.message());
  if (!written) fs::remove_all(part, ignored);
  if (asked_to_end != 0) std::signal(asked_to_end, SIG_DFL), std::raise(asked_to_end);
  if (!written)
    return tl::unexpected(InputError{.what = "cannot be written: " + written.error(), .file = folder.string()});
  return {};
}

/// Each file with what a host sends in its place to a browser that unpacks it; some send nothing else.
SiteFiles with_packed(SiteFiles files) {
  SiteFiles all;
  for (auto& [path, bytes] : files) {
    all[path + ".gz"] = gzip_of(bytes), all[path + ".br"] = brotli_of(bytes);
    all[path] = std::move(bytes);
  }
  return all;
}

tl::expected<void, InputError> write_package(const PackageOptions& options, PackageContents contents) {
  if (!options.one_file.empty())
    return one_page_of(contents).and_then([&](const std::string& page) { return write_file(options.one_file, page); });
  if (!options.folder.empty()) return write_folder(options.folder, with_packed(std::move(contents.files)));
  contents.files["imsmanifest.xml"] = manifest_of(contents);
  return write_file(options.zip, zip_of(contents.files));
}

CommandResult run_package(const PackageOptions& options) {
  if (static_cast<int>(options.zip.empty()) + options.folder.empty() + options.one_file.empty() != 2)
    return bad_input("say where to: one of -o FILE.zip, --static FOLDER and --single FILE.html");
  std::error_code unknown;
  if (!options.folder.empty() && fs::exists(options.folder, unknown))
    return bad_input(InputError{.what = "is there already: name a new folder", .file = options.folder});
  const PackageKind kind = !options.zip.empty()      ? PackageKind::kScorm
                           : !options.folder.empty() ? PackageKind::kFolder
                                                     : PackageKind::kOneFile;
  Printed printed;
  const auto written =
      site_folder(options.site)
          .and_then(read_site)
          .and_then([&](SiteFiles&& site) { return package_of(options.what, std::move(site), kind); })
          .and_then([&](PackageContents&& made) {
            if (made.left_out > 0)
              printed.warnings.push_back({.what = "left out " +
                                                  io::counted(static_cast<std::int64_t>(made.left_out), "exercise") +
                                                  " in which code is written: a page in one file cannot run it"});
            return write_package(options, std::move(made));
          });
  if (!written) return bad_input(written.error());
  return printed;
}

}  // namespace

void add_package(Commands& commands) {
  CLI::App& package = *commands.app.add_subcommand("package", "Package lessons and exercises for a course's site");
  package.footer("A zip is a SCORM 1.2 package, for Moodle, ILIAS, Canvas, Blackboard and others: it reports a score "
                 "from 0 to 100\n"
                 "(the mean of the exercises, each the best of its attempts), and \"completed\" once every exercise "
                 "was finished and\n"
                 "every lesson done. --static is a folder for any host, with .gz and .br beside each file for those "
                 "that send them.\n"
                 "--single is one file that opens by double click, without a server. The lesson that teaches an "
                 "exercise is in its\n"
                 "package. Functions that students write need a server: they are not in one file. The same page makes "
                 "the same\n"
                 "bytes. `./run package` builds the page first.");
  const auto options = add_command<PackageOptions>(commands, package, run_package);
  package.add_option("WHAT", options->what, "lesson:ID, exercise:ID, set:ID or course")->required();
  package.add_option("-o", options->zip, "The zip to write");
  package.add_option("--static", options->folder, "The folder to write, which must not be there yet");
  package.add_option("--single", options->one_file, "The HTML file to write");
  package.add_option("--site", options->site,
                     "The page's folder; by default the one beside the program, or built by ./run");
}

}  // namespace snug::desktop
