// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/docs/commands.h"

#include <algorithm>

#include "plugin/cli/arguments/hidden.h"
#include "plugin/cli/arguments/options.h"

namespace blossom::cli {

std::vector<const CLI::App*> subcommands(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::App*> with_subcommands(const CLI::App& command) {
  std::vector<const CLI::App*> found = {&command};
  for (const CLI::App* below : subcommands(command))
    for (const CLI::App* each : with_subcommands(*below)) found.push_back(each);
  return found;
}

std::string called(const CLI::App& command, const std::string& between) {
  const CLI::App* above = command.get_parent();
  return (above ? called(*above, between) + between : "") + command.get_name();
}

std::vector<const CLI::Option*> options(const CLI::App& command) {
  auto found = command.get_options([](const CLI::Option* option) {
    return option->nonpositional() && option->get_group() != kHidden;
  });
  std::ranges::stable_partition(
      found, [](const CLI::Option* option) { return option->get_group() != kShared; });
  return found;
}

std::vector<const CLI::Option*> arguments(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<std::string> names(const CLI::Option& option) {
  std::vector<std::string> found;
  for (const std::string& name : option.get_snames()) found.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.push_back("--" + name);
  return found;
}

}  // namespace blossom::cli
