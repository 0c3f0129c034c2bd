// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/commands.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/arguments/hidden.h"
#include "plugin/cli/commands/examples.h"
#include "plugin/cli/version.h"

namespace blossom::cli {
namespace {

class HelpText : public CLI::Formatter {
 public:
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    if (group == kHidden) return {};
    return CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
  }
};

}  // namespace

void add_commands(CLI::App& app, int& exit_code) {
  app.name("blossom");
  app.formatter(std::make_shared<HelpText>());
  app.description("Intersect, trim and blend free-form surfaces of CAD models");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(
      "An input is FILE, or something in it: faces FILE#3,5-9 (as info --faces numbers them), "
      "parts "
      "FILE#Shaft,\n"
      "FILE#Shaft/Face3, FILE#Face3, FILE#Solid2 or FILE#Edge12. Lengths are mm, angles "
      "degrees.\n");

  add_info(app, exit_code);
  add_check(app, exit_code);
  add_intersect(app, exit_code);
  add_self_intersect(app, exit_code);
  add_trim(app, exit_code);
  add_blend(app, exit_code);
  add_subdivide(app, exit_code);
  add_convert(app, exit_code);
  add_clash(app, exit_code);
  add_query(app, exit_code);
  add_batch(app, exit_code);
  add_help(app, exit_code);
  add_examples(app);
}

}  // namespace blossom::cli
