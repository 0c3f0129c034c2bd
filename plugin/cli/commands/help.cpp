// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom help COMMAND`: the same as `blossom COMMAND --help`.

#include <memory>
#include <string>
#include <vector>

#include "plugin/cli/arguments/usage.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

void add_help(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("help", "how a command is used");
  const auto words = std::make_shared<std::vector<std::string>>();
  command->add_option("command", *words, "as in 'blossom help query ray'; all commands without it")
      ->type_name("COMMAND");
  command->callback([&app, words, &exit_code] {
    print(help_text(app, *words));
    exit_code = kExitComplete;
  });
}

}  // namespace blossom::cli
