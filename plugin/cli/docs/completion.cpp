// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/docs/completion.h"

#include <algorithm>
#include <sstream>

#include "plugin/cli/docs/commands.h"

namespace blossom::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// The words an option is limited to, which its type shows as {one,two}; empty if it is not.
std::string choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  std::string words = type.substr(open + 1, close - open - 1);
  std::ranges::replace(words, ',', ' ');
  return words;
}

// A function that sets what may follow the words of a command: its commands and options.
void add_words(std::ostream& script, const CLI::App& program) {
  script << "_" << program.get_name() << "_words() {\n  case \"$command\" in\n";
  for (const CLI::App* command : with_subcommands(program)) {
    std::vector<std::string> commands, dashed;
    for (const CLI::App* below : subcommands(*command)) commands.push_back(below->get_name());
    for (const CLI::Option* option : options(*command))
      for (const std::string& name : names(*option)) dashed.push_back(name);
    script << "    '" << called(*command, " ") << "')\n      commands='" << joined(commands, " ")
           << "'\n      options='" << joined(dashed, " ") << "' ;;\n";
  }
  script << "  esac\n}\n";
}

// What may follow an option: only its own words, where it has any.
void add_values(std::ostream& script, const CLI::App& program) {
  script << "  case \"$command $before\" in\n";
  for (const CLI::App* command : with_subcommands(program))
    for (const CLI::Option* option : options(*command))
      if (const std::string words = choices(*option); !words.empty())
        for (const std::string& name : names(*option))
          script << "    '" << called(*command, " ") << ' ' << name << "') values='" << words
                 << "' ;;\n";
  script << "  esac\n";
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::ostringstream script;
  script << "# bash completion of " << name << ", made from its options\n";
  add_words(script, program);
  script << "_" << name << "() {\n"
         << "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         << "  local command=" << name << " commands='' options='' values='' word\n"
         << "  COMPREPLY=()\n"
         << "  _" << name << "_words\n"
         << "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         << "    if [[ -n $word && \" $commands \" == *\" $word \"* ]]; then\n"
         << "      command=\"$command $word\"\n"
         << "      _" << name << "_words\n"
         << "    fi\n"
         << "  done\n";
  add_values(script, program);
  script << "  if [ -n \"$values\" ]; then\n"
         << "    mapfile -t COMPREPLY < <(compgen -W \"$values\" -- \"$current\")\n"
         << "  elif [ -n \"$commands\" ] || [[ $current == -* ]]; then\n"
         << "    mapfile -t COMPREPLY < <(compgen -W \"$commands $options\" -- \"$current\")\n"
         << "  fi\n"
         << "}\n"
         << "complete -o default -F _" << name << ' ' << name << '\n';
  return script.str();
}

}  // namespace blossom::cli
