#include "desktop/cli/completions.hpp"

#include <sstream>
#include <string_view>
#include <vector>

#include "desktop/cli/definitions.hpp"
#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

std::string shell_word(const std::string& text) { return '\'' + replaced(text, "'", "'\\''") + '\''; }
std::string fish_word(const std::string& text) {
  return '\'' + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + '\'';
}

/// A description in one line.
std::string one_line(const std::string& description) { return replaced(description, "\n", " "); }

/// The calls of all commands below snug, each as one word of the shell.
std::string calls(const std::vector<Defined>& all, const char* between) {
  std::vector<std::string> words;
  for (std::size_t i = 1; i < all.size(); ++i) words.push_back(shell_word(all[i].call));
  return joined(words, between);
}

std::string bash(const std::vector<Defined>& all) {
  std::ostringstream out;
  out << "# bash completion for snug: made by `snug completions bash`\n"
         "_snug() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=snug i offered=\n"
         "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
         "    case \"$command ${COMP_WORDS[i]}\" in\n      "
      << calls(all, " | ") << ") command+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n  case $command in\n";
  for (const Defined& command : all) {
    std::vector<std::string> words;
    for (const CLI::App* sub : subcommands_of(*command.app)) words.push_back(sub->get_name());
    out << "    " << shell_word(command.call) << ")\n      case $before in\n";
    for (const CLI::Option* option : options_of(*command.app)) {
      const auto names = names_of(*option);
      words.insert(words.end(), names.begin(), names.end());
      if (takes_value(*option))
        out << "        " << joined(names, " | ") << ") offered=" << shell_word(joined(values_of(*option), " "))
            << " ;;\n";
    }
    out << "        *) offered=" << shell_word(joined(words, " ")) << " ;;\n      esac ;;\n";
  }
  out << "  esac\n"
         "  COMPREPLY=($(compgen -W \"$offered\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _snug snug\n";
  return out.str();
}

/// An option as zsh's _arguments takes it, a word for each of its names.
std::string zsh_option(const CLI::Option& option) {
  std::string words;
  const auto says = replaced(replaced(one_line(option.get_description()), "[", "\\["), "]", "\\]");
  for (const std::string& name : names_of(option)) {
    std::string word = name + '[' + replaced(says, ":", "\\:") + ']';
    if (takes_value(option)) {
      const auto values = values_of(option);
      word += values.empty() ? ":value:_files" : ":value:(" + joined(values, " ") + ')';
    }
    words += "\n        " + shell_word(word);
  }
  return words;
}

std::string zsh(const std::vector<Defined>& all) {
  std::ostringstream out;
  out << "#compdef snug\n"
         "# zsh completion for snug: made by `snug completions zsh`\n"
         "_snug() {\n"
         "  local command=snug i\n"
         "  local -a commands options\n"
         "  for ((i = 2; i < CURRENT; i++)); do\n"
         "    case \"$command ${words[i]}\" in\n      "
      << calls(all, " | ") << ") command+=\" ${words[i]}\" ;;\n    esac\n  done\n  case $command in\n";
  for (const Defined& command : all) {
    out << "    " << shell_word(command.call) << ")\n      commands=(";
    for (const CLI::App* sub : subcommands_of(*command.app))
      out << "\n        " << shell_word(sub->get_name() + ':' + one_line(sub->get_description()));
    out << ")\n      options=(";
    for (const CLI::Option* option : options_of(*command.app)) out << zsh_option(*option);
    out << ") ;;\n";
  }
  out << "  esac\n"
         "  (( $#commands )) && [[ ${words[CURRENT]} != -* ]] && _describe command commands\n"
         "  _arguments $options '*:file:_files'\n"
         "}\n"
         "_snug \"$@\"\n";
  return out.str();
}

std::string fish_option(const CLI::Option& option) {
  std::string words;
  for (const std::string& name : option.get_snames()) words += " -s " + name;
  for (const std::string& name : option.get_lnames()) words += " -l " + name;
  if (takes_value(option)) {
    const auto values = values_of(option);
    words += values.empty() ? " -r -F" : " -x -a " + fish_word(joined(values, " "));
  }
  return words + " -d " + fish_word(one_line(option.get_description()));
}

std::string fish(const std::vector<Defined>& all) {
  std::ostringstream out;
  out << "# fish completion for snug: made by `snug completions fish`\n"
         "function __snug_at\n"
         "    set -l command snug\n"
         "    for word in (commandline -opc)[2..]\n"
         "        contains -- \"$command $word\" "
      << calls(all, " ")
      << "\n            and set command \"$command $word\"\n"
         "    end\n"
         "    test \"$command\" = \"$argv\"\n"
         "end\n";
  for (const Defined& command : all) {
    const std::string here = "complete -c snug -n " + fish_word("__snug_at " + command.call);
    for (const CLI::App* sub : subcommands_of(*command.app))
      out << here << " -a " << sub->get_name() << " -d " << fish_word(one_line(sub->get_description())) << '\n';
    for (const CLI::Option* option : options_of(*command.app)) out << here << fish_option(*option) << '\n';
  }
  return out.str();
}

}  // namespace

std::string completions_of(const CLI::App& snug, const std::string& shell) {
  const auto all = all_commands(snug);
  return shell == "bash" ? bash(all) : shell == "zsh" ? zsh(all) : fish(all);
}

}  // namespace snug::desktop
