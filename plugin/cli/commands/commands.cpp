// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/commands.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/version.h"

namespace blossom::cli {

void add_commands(CLI::App& app, int& exit_code) {
  app.name("blossom");
  app.description("Intersect, trim and blend free-form surfaces of CAD models");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(
      "An input is FILE, or something in it: faces FILE#3,5-9 (numbers as in 'info'), parts "
      "FILE#Shaft,\n"
      "FILE#Shaft/Face3, FILE#Face3, FILE#Solid2 or FILE#Edge12.\n");

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
}

}  // namespace blossom::cli
