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

/// A function of bash and zsh that prints the algorithms of a volume, or of all.
std::string algorithms_function() {
  std::string text = "_snug_algorithms() {\n  case $1 in\n";
  for (const auto& [volume, algorithms] : algorithms_by_volume())
    text += "    " + volume + ") echo " + shell_word(joined(algorithms, " ")) + " ;;\n";
  return text + "  esac\n}\n";
}

std::string bash_ids(const std::string& kinds) { return kinds.empty() ? "" : " ids=" + shell_word(kinds); }

std::string bash(const std::vector<Defined>& all) {
  std::ostringstream out;
  // The shell takes = and what stands before a colon for words of their own, unless COMP_WORDBREAKS lacks them.
  out << "# bash completion for snug: made by `snug completions bash`\n"
      << algorithms_function()
      << "_snug() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=snug first=1 i\n"
         "  local offered= options= ids= volume= glued= start=\n"
         "  if [[ $word == = ]]; then word=\n"
         "  elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  elif [[ $word == --*=* ]]; then before=${word%%=*} word=${word#*=} glued=$before=\n"
         "  fi\n"
         "  [[ ${COMP_WORDS[1]} != help || $COMP_CWORD == 1 || $word == -* ]] || first=2\n"
         "  for ((i = first; i < COMP_CWORD; i++)); do\n"
         "    case ${COMP_WORDS[i]} in\n"
         "      --volume) volume=${COMP_WORDS[i + 1]}; [[ $volume != = ]] || volume=${COMP_WORDS[i + 2]} ;;\n"
         "      --volume=*) volume=${COMP_WORDS[i]#*=} ;;\n"
         "    esac\n"
         "    case \"$command ${COMP_WORDS[i]}\" in\n      "
      << calls(all, " | ") << ") command+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n  case $command in\n";
  for (const Defined& command : all) {
    std::vector<std::string> words, options;
    for (const CLI::App* sub : subcommands_of(*command.app)) words.push_back(sub->get_name());
    out << "    " << shell_word(command.call) << ")\n      case $before in\n";
    for (const CLI::Option* option : options_of(*command.app)) {
      const auto names = names_of(*option);
      options.insert(options.end(), names.begin(), names.end());
      if (!takes_value(*option)) continue;
      out << "        " << joined(names, " | ") << ") offered="
          << (is_of_volume(command, *option) ? "$(_snug_algorithms \"$volume\")"
                                             : shell_word(joined(values_of(*option), " ")))
          << bash_ids(ids_of(command, *option)) << " ;;\n";
    }
    // Beside the commands lessons are offered after a letter, for they are many; so are options, after a dash.
    out << "        *) offered=" << shell_word(joined(words, " ")) << " options=" << shell_word(joined(options, " "))
        << bash_ids(ids_in_place(command)) << (words.empty() ? "" : "; [[ $word ]] || ids=") << " ;;\n      esac ;;\n";
  }
  out << "  esac\n"
         "  ((first == 1)) || options= ids=\n"
         "  [[ $word != -* || -z $options ]] || offered=$options\n"
         "  if [[ $COMP_WORDBREAKS == *:* ]]; then\n"
         "    for ((i = COMP_CWORD; i > 1; i--)); do\n"
         "      [[ ${COMP_WORDS[i]} == : || ${COMP_WORDS[i - 1]} == : ]] || break\n"
         "      start=${COMP_WORDS[i - 1]}$start\n"
         "    done\n"
         "    if [[ $word == : ]]; then start+=: word=; fi\n"
         "  fi\n"
         "  if [[ $ids && $word != -* ]]; then\n"
         "    offered+=\" $(\"${COMP_WORDS[0]/#\\~/$HOME}\" ids $ids 2>/dev/null)\"\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$offered\" -- \"$start$word\"))\n"
         "  COMPREPLY=(\"${COMPREPLY[@]#\"$start\"}\")\n"
         "  COMPREPLY=(\"${COMPREPLY[@]/#/\"$glued\"}\")\n"
         "}\n"
         "complete -o default -F _snug snug\n";
  return out.str();
}

/// An option as zsh's _arguments takes it, a word for each of its names.
std::string zsh_option(const Defined& command, const CLI::Option& option) {
  std::string words;
  const auto says = replaced(replaced(one_line(option.get_description()), "[", "\\["), "]", "\\]");
  for (const std::string& name : names_of(option)) {
    const bool is_long = name.starts_with("--");
    std::string word = name + (is_long && takes_value(option) ? "=" : "") + '[' + replaced(says, ":", "\\:") + ']';
    if (is_of_volume(command, option)) word += ":value: _snug_of_volume";
    else if (takes_value(option)) {
      const auto values = values_of(option);
      const std::string ids = ids_of(command, option);
      word += !ids.empty()     ? ":value: _snug_ids " + ids
              : values.empty() ? ":value:_files"
                               : ":value:(" + joined(values, " ") + ')';
    }
    words += "\n        " + shell_word(word);
  }
  return words;
}

std::string zsh(const std::vector<Defined>& all) {
  std::ostringstream out;
  out << "#compdef snug\n"
         "# zsh completion for snug: made by `snug completions zsh`\n"
      << algorithms_function()
      << "_snug_of_volume() {\n"
         "  local i volume\n"
         "  for ((i = 2; i < CURRENT; i++)); do\n"
         "    case ${words[i]} in\n"
         "      --volume) volume=${words[i + 1]} ;;\n"
         "      --volume=*) volume=${words[i]#*=} ;;\n"
         "    esac\n"
         "  done\n"
         "  local -a algorithms=($(_snug_algorithms \"$volume\"))\n"
         "  compadd -a algorithms\n"
         "}\n"
         "_snug_ids() {\n"
         "  local -a ids=(${(f)\"$(${~words[1]} ids $@ 2>/dev/null)\"})\n"
         "  compadd -a ids\n"
         "  _files\n"
         "}\n"
         "_snug() {\n"
         "  local command=snug first=2 i place='*:file:_files'\n"
         "  local -a commands options\n"
         "  [[ ${words[2]} != help || $CURRENT == 2 || ${words[CURRENT]} == -* ]] || first=3\n"
         "  for ((i = first; i < CURRENT; i++)); do\n"
         "    case \"$command ${words[i]}\" in\n      "
      << calls(all, " | ") << ") command+=\" ${words[i]}\" ;;\n    esac\n  done\n  case $command in\n";
  for (const Defined& command : all) {
    out << "    " << shell_word(command.call) << ")\n      commands=(";
    for (const CLI::App* sub : subcommands_of(*command.app))
      out << "\n        " << shell_word(sub->get_name() + ':' + one_line(sub->get_description()));
    out << ")\n      options=(";
    for (const CLI::Option* option : options_of(*command.app)) out << zsh_option(command, *option);
    out << ')';
    if (const std::string ids = ids_in_place(command); !ids.empty())
      out << "\n      place=" << shell_word("*:id: _snug_ids " + ids);
    out << " ;;\n";
  }
  out << "  esac\n"
         "  if (( first == 3 )); then _describe command commands; return; fi\n"
         "  (( $#commands )) && [[ ${words[CURRENT]} != -* ]] && _describe command commands\n"
         "  [[ $command != snug || -n ${words[CURRENT]} ]] || place='*:file:_files'\n"
         "  _arguments $options $place\n"
         "}\n"
         "_snug \"$@\"\n";
  return out.str();
}

/// What prints the ids of these kinds, by the program whose line is completed.
std::string fish_ids(const std::string& kinds) { return "(__snug_ids " + kinds + ")"; }

std::string fish_option(const Defined& command, const CLI::Option& option) {
  std::string words;
  for (const std::string& name : option.get_snames()) words += " -s " + name;
  for (const std::string& name : option.get_lnames()) words += " -l " + name;
  if (takes_value(option)) {
    const auto values = values_of(option);
    const std::string ids = ids_of(command, option);
    words += !ids.empty()                    ? " -x -a " + fish_word(fish_ids(ids))
             : is_of_volume(command, option) ? " -x -a '(__snug_algorithms)'"
             : values.empty()                ? " -r -F"
                                             : " -x -a " + fish_word(joined(values, " "));
  }
  return words + " -d " + fish_word(one_line(option.get_description()));
}

std::string fish(const std::vector<Defined>& all) {
  std::ostringstream out;
  out << "# fish completion for snug: made by `snug completions fish`\n"
         "function __snug_command\n"
         "    set -l command snug\n"
         "    for word in $argv\n"
         "        contains -- \"$command $word\" "
      << calls(all, " ")
      << "\n            and set command \"$command $word\"\n"
         "    end\n"
         "    echo $command\n"
         "end\n"
         "function __snug_at\n"
         "    test (__snug_command (commandline -opc)[2..]) = \"$argv\"\n"
         "end\n"
         "function __snug_help_at\n"
         "    set -l words (commandline -opc)\n"
         "    test \"$words[2]\" = help; and test (__snug_command $words[3..]) = \"$argv\"\n"
         "end\n"
         "function __snug_algorithms\n"
         "    switch (string replace -fr '.*--volume[= ]+(\\w+).*' '$1' -- (commandline -cp); or echo)\n";
  for (const auto& [volume, algorithms] : algorithms_by_volume())
    out << "        case " << fish_word(volume) << "\n            printf '%s\\n' " << joined(algorithms, " ") << '\n';
  out << "    end\n"
         "end\n"
         "function __snug_ids\n"
         "    set -l program (string replace -r '^~' $HOME (commandline -opc)[1])\n"
         "    $program ids $argv 2>/dev/null\n"
         "end\n";
  for (const Defined& command : all) {
    const std::string here = "complete -c snug -n " + fish_word("__snug_at " + command.call);
    const std::string or_help = fish_word("__snug_at " + command.call + "; or __snug_help_at " + command.call);
    for (const CLI::App* sub : subcommands_of(*command.app))
      out << "complete -c snug -n " << or_help << " -a " << sub->get_name() << " -d "
          << fish_word(one_line(sub->get_description())) << '\n';
    for (const CLI::Option* option : options_of(*command.app)) out << here << fish_option(command, *option) << '\n';
    if (const std::string ids = ids_in_place(command); !ids.empty()) {
      const bool beside_commands = !subcommands_of(*command.app).empty();  // then once a letter is there
      const std::string when =
          "__snug_at " + command.call + (beside_commands ? "; and string length -q -- (commandline -ct)" : "");
      out << "complete -c snug -n " << fish_word(when) << " -a " << fish_word(fish_ids(ids)) << '\n';
    }
  }
  return out.str();
}

}  // namespace

std::string completions_of(const CLI::App& snug, const std::string& shell) {
  const auto all = all_commands(snug);
  return shell == "bash" ? bash(all) : shell == "zsh" ? zsh(all) : fish(all);
}

}  // namespace snug::desktop
