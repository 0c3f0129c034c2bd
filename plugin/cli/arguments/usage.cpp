// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/usage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

using Options = std::vector<const CLI::Option*>;

// The command that the user has named so far.
const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

// "query ray"; empty for the program itself.
std::string command_name(const CLI::App& command) {
  if (command.get_parent() == nullptr) return {};
  const std::string parent = command_name(*command.get_parent());
  return parent.empty() ? command.get_name() : parent + " " + command.get_name();
}

std::string program_and(const CLI::App& command) {
  const std::string name = command_name(command);
  return name.empty() ? "blossom" : "blossom " + name;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

Options options_where(const CLI::App& command, bool (*wanted)(const CLI::Option&)) {
  Options found;
  for (const CLI::Option* option : command.get_options())
    if (wanted(*option)) found.push_back(option);
  return found;
}

bool is_input(const CLI::Option& option) { return option.get_positional(); }

bool is_needed_input(const CLI::Option& option) {
  return option.get_positional() && option.get_required();
}

bool is_missing(const CLI::Option& option) { return option.get_required() && option.count() == 0; }

// What a positional argument is, as its description begins: "model, or some of its faces".
std::string noun_of(const CLI::Option& input) {
  return input.get_description().substr(0, input.get_description().find(','));
}

// The command, from the program downwards, that was given what it does not know.
const CLI::App& refusing_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (command->remaining().empty() && !command->get_subcommands().empty())
    command = command->get_subcommands().front();
  return *command;
}

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& words,
                         const std::string& dashes = "") {
  const std::string near = nearest_word(typed, words);
  return near.empty() ? "" : "; did you mean '" + dashes + near + "'?";
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

// All commands below one, by name; of those that have commands of their own these.
void add_commands(const CLI::App& app, std::vector<const CLI::App*>& commands) {
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_subcommands({}).empty()) commands.push_back(command);
    add_commands(*command, commands);
  }
}

// Where a command of that name is, at another place; or, if it is no command at all, what it is
// about, or an option of: "section" is what 'query plane' makes.
std::string command_elsewhere(const CLI::App& app, const std::string& typed) {
  constexpr std::size_t kShortest = 3;  // letters of a word that says enough
  const CLI::App* root = &app;
  while (root->get_parent() != nullptr) root = root->get_parent();
  std::vector<const CLI::App*> commands;
  add_commands(*root, commands);
  const auto hint = [](const CLI::App& command, const std::string& option = {}) {
    return "; there is 'blossom " + command_name(command) + option +
           "': " + command.get_description();
  };
  for (const CLI::App* command : commands)
    if (command->get_name() == typed) return hint(*command);
  if (typed.size() < kShortest) return {};
  for (const CLI::App* command : commands)
    if (has_word(command->get_description(), typed)) return hint(*command);
  for (const CLI::App* command : commands)
    if (command->get_option_no_throw("--" + typed) != nullptr) return hint(*command, " --" + typed);
  for (const CLI::App* command : commands)
    if (has_word(command->get_description(), typed + "s")) return hint(*command);
  return {};
}

std::string no_such_command(const CLI::App& parent, const std::string& typed) {
  const std::vector<std::string> names = names_of_commands(parent);
  const std::string parent_name = command_name(parent);
  const std::string full = parent_name.empty() ? typed : parent_name + " " + typed;
  std::string near = did_you_mean(typed, names);
  if (near.empty()) near = command_elsewhere(parent, typed);
  return "there is no command '" + full + "'" +
         (near.empty() ? "; there are " + listed(names, "and") : near);
}

std::string no_such_option(const CLI::App& command, const std::string& typed) {
  const std::string option = typed.substr(0, typed.find('='));
  std::vector<std::string> names;
  for (const CLI::Option* known : command.get_options())
    for (const std::string& name : known->get_lnames()) names.push_back(name);
  const std::size_t word = option.find_first_not_of('-');
  std::string near = word < 2 ? "" : did_you_mean(option.substr(word), names, "--");
  if (command.get_parent() == nullptr)
    return "there is no option '" + option + "' before the command" +
           (near.empty() ? "; options come after it" : near);
  const Options missing = options_where(
      command, [](const CLI::Option& each) { return is_missing(each) && !each.get_positional(); });
  if (near.empty() && !missing.empty())
    near = "; it needs " + missing.front()->get_name() + " " + missing.front()->get_type_name();
  return command_name(command) + " has no option '" + option + "'" + near;
}

std::string needs_command(const CLI::App& command) {
  const std::string name = command_name(command);
  const std::string kinds = listed(names_of_commands(command), "and");
  return name.empty() ? "no command is given; there are " + kinds
                      : name + " needs one of its commands: " + kinds;
}

std::string needs_input(const CLI::App& command, const CLI::Option& missing) {
  static constexpr std::array kPlaces{"first", "second"};
  const Options inputs = options_where(command, is_needed_input);
  const std::string needs = command_name(command) + " needs ";
  const std::string noun = noun_of(*inputs.front());
  if (inputs.size() == 1) return needs + "a " + noun + "; none is given";
  if (noun_of(*inputs.back()) != "likewise")
    return needs + "a " + noun + ", and " + noun_of(*inputs.back()) + "; " +
           missing.get_type_name() + " is missing";
  const auto place = std::ranges::find(inputs, &missing) - inputs.begin();
  return needs + "two " + noun + "s; " +
         (place == 0
              ? "none is given"
              : std::string("the ") + kPlaces.at(static_cast<std::size_t>(place)) + " is missing");
}

std::string needs_option(const CLI::App& command, const CLI::Option& missing) {
  return command_name(command) + " needs " + missing.get_name() + " " + missing.get_type_name() +
         " (" + missing.get_description() + ")";
}

std::string too_many_inputs(const CLI::App& command, const std::string& extra) {
  std::string takes;
  for (const CLI::Option* input : options_where(command, is_input))
    takes += " " + input->get_type_name();
  if (takes.empty()) return command_name(command) + " takes no '" + extra + "'";
  return "'" + extra + "' is one too many; " + command_name(command) + " takes no more than" +
         takes + (finite_value(extra) ? ", and points are one word: X,Y,Z" : "");
}

// The option that a message is about: the longest whose name is in it.
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
  const CLI::Option* found = nullptr;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (message.find(name) == std::string::npos) continue;
    if (found == nullptr || found->get_name().size() < name.size()) found = option;
  }
  return found;
}

std::string wrong_count(const CLI::App& command, const std::string& message) {
  const CLI::Option* const option = option_in(command, message);
  if (option == nullptr) return message;
  const int takes = option->get_items_expected_max();
  if (takes == 0) return option->get_name() + " takes no value";
  if (takes > 1) {
    const bool any = takes >= CLI::detail::expected_max_vector_size;
    return option->get_name() + " takes " + (any ? "" : std::to_string(takes) + " ") +
           "numbers: " + option->get_type_name();
  }
  return option->get_name() +
         (option->count() > 1 ? " is given twice" : " needs a value: " + option->get_type_name());
}

// "--quiet excludes --verbose", as the parser puts it.
std::string not_together(const std::string& message) {
  const std::string word = " excludes ";
  const std::size_t at = message.find(word);
  if (at == std::string::npos) return message;
  return message.substr(0, at) + " and " + message.substr(at + word.size()) + " do not go together";
}

// "--gap requires --continuity", as the parser puts it.
std::string needs_other(std::string message) {
  const std::string word = " requires ";
  const std::size_t at = message.find(word);
  return at == std::string::npos ? message : message.replace(at, word.size(), " needs ");
}

// "--tolerance: takes a positive number, not '0'": the name and what a check of values.h says.
std::string wrong_value(const std::string& message) {
  const std::size_t colon = message.find(": takes");
  return colon == std::string::npos ? message
                                    : message.substr(0, colon) + message.substr(colon + 1);
}

std::string missing_part(const CLI::App& command, const std::string& message) {
  const Options missing = options_where(command, is_missing);
  if (missing.empty())
    return command.get_require_subcommand_min() > 0 ? needs_command(command) : message;
  const CLI::Option& first = *missing.front();
  return first.get_positional() ? needs_input(command, first) : needs_option(command, first);
}

// An option that is not known, if there is one: a value that follows it is not known either. But
// where the command itself is not known, options behind it may be right.
std::string unknown_word(const CLI::App& command, const std::vector<std::string>& extras) {
  const auto is_option = [](const std::string& text) { return text.size() > 1 && text[0] == '-'; };
  const bool lacks_command = command.get_require_subcommand_min() > 0;
  if (lacks_command && !is_option(extras.front())) return no_such_command(command, extras.front());
  const auto option = std::ranges::find_if(extras, is_option);
  if (option != extras.end()) return no_such_option(command, *option);
  return lacks_command ? no_such_command(command, extras.front())
                       : too_many_inputs(command, extras.front());
}

// Whether words behind -- are left over as --each has more than a pattern: files, of which the
// shell makes a pattern that is not in quotes.
bool is_pattern_without_quotes(const CLI::App& command) {
  const CLI::Option* const each = command.get_option_no_throw("--each");
  const CLI::Option* const jobs = command.get_option_no_throw("jobs");
  return each != nullptr && each->count() > 0 && jobs != nullptr && jobs->count() > 0;
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  if (!app.remaining().empty() && is_pattern_without_quotes(chosen_command(app)))
    return "--each takes one pattern, and the shell has made names of files of it; put it in "
           "quotes: --each '*.step'";
  const CLI::App& command = refusing_command(app);
  const std::string message = error.what();
  const std::vector<std::string> extras = command.remaining();
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::RequiredError:
    case CLI::ExitCodes::ExtrasError:
      return extras.empty() ? missing_part(command, message) : unknown_word(command, extras);
    case CLI::ExitCodes::RequiresError: return needs_other(message);
    case CLI::ExitCodes::ExcludesError: return not_together(message);
    case CLI::ExitCodes::ValidationError: return wrong_value(message);
    default: return wrong_count(command, message);
  }
}

std::string help_line(const CLI::App& app) {
  return "see '" + program_and(chosen_command(app)) + " --help'";
}

std::string help_text(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    const auto commands = command->get_subcommands({});
    const auto found = std::ranges::find(commands, word, &CLI::App::get_name);
    if (found == commands.end()) throw UsageError(no_such_command(*command, word));
    command = *found;
  }
  return command->get_formatter()->make_help(command, program_and(*command),
                                             CLI::AppFormatMode::Normal);
}

}  // namespace blossom::cli
