#include "desktop/cli/manual.hpp"

#include <sstream>

#include "desktop/cli/definitions.hpp"

namespace snug::desktop {
namespace {

/// Text as roff prints it unchanged.
std::string plain(const std::string& text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
    begins = c == '\n';
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fP"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fP"; }

/// Lines that stay as they are.
std::string as_written(const std::string& text) { return text.empty() ? "" : ".PP\n.nf\n" + plain(text) + "\n.fi\n"; }

std::string option_text(const CLI::Option& option) {
  std::string text = ".TP\n";
  const auto names = names_of(option);
  for (const std::string& name : names) text += (&name == &names.front() ? "" : ", ") + bold(name);
  if (takes_value(option)) {
    const std::string& type = option.get_type_name();
    text += ' ' + italic(type.substr(0, type.find(':')));
  }
  text += '\n' + plain(option.get_description());
  if (!option.get_default_str().empty()) text += " (" + plain(option.get_default_str()) + " by default)";
  return text + '\n';
}

std::string places_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) {
      const std::string name = italic(option->get_name(true));
      text += option->get_required() ? ' ' + name : " [" + name + ']';
    }
  return text;
}

std::string arguments_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional())
      text += ".TP\n" + italic(option->get_name(true)) + '\n' + plain(option->get_description()) + '\n';
  for (const CLI::Option* option : options_of(app)) text += option_text(*option);
  return text;
}

constexpr const char* kFiles = R"(.SH FILES
.TP
.I ~/.local/state/snug/course.json
What the window keeps: answers, and the place in each lesson.
.TP
.I ~/.config/snug/snug.toml, /etc/xdg/snug/snug.toml, /usr/share/snug/snug.toml
What everybody of a class begins with: lessons, theme, first_lesson, page, results. The first that exists counts.
.SH ENVIRONMENT
.TP
.B SNUG_THEME
The window's and the pictures' look at the start: light, dark, contrast or projector.
.TP
.B SNUG_STATE
A file that the window replaces by its state, one JSON object, whenever a frame shows something new.
.TP
.B NO_COLOR
If it is set, and not empty, nothing is printed in colour.
.TP
.B XDG_STATE_HOME
The folder in place of ~/.local/state.
.TP
.B XDG_CONFIG_HOME, XDG_CONFIG_DIRS
The folder in place of ~/.config, and those in place of /etc/xdg, with colons between them.
)";

}  // namespace

std::string manual_of(const CLI::App& snug) {
  std::ostringstream page;
  page << ".TH SNUG 1 \"\" \"snug " << SNUG_VERSION << "\" \"User Commands\"\n"
       << ".SH NAME\nsnug \\- bounding volumes: fitted, tested, measured and taught\n"
       << ".SH SYNOPSIS\n.B snug\n[" << italic("options") << "]" << places_of(snug) << "\n.br\n.B snug\n"
       << italic("command") << " [" << italic("options") << "] ...\n"
       << ".SH DESCRIPTION\n"
       << plain(snug.get_description()) << "\n.SH OPTIONS\n"
       << arguments_of(snug) << ".SH COMMANDS\n";
  for (const Defined& command : all_commands(snug)) {
    if (command.app == &snug) continue;
    const bool has_commands = !subcommands_of(*command.app).empty();
    page << ".SS " << plain(command.call) << (has_commands ? " " + italic("command") : places_of(*command.app)) << '\n'
         << plain(command.app->get_description()) << ".\n"
         << arguments_of(*command.app) << as_written(command.app->get_footer());
  }
  page << ".SH \"STREAMS AND EXIT STATUS\"\n" << as_written(snug.get_footer()) << kFiles;
  return page.str();
}

}  // namespace snug::desktop
