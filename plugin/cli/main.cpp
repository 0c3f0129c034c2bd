// SPDX-License-Identifier: LGPL-2.1-or-later
// The program `blossom`: chooses the command and turns errors into messages and exit codes.

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes.h"
#include "core/base/errors.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/reading.h"
#include "plugin/cli/supervision.h"

namespace blossom::cli {
namespace {

int failed(const std::exception& error, int code) {
  std::cerr << "blossom: " << error.what() << '\n';
  return code;
}

bool is_command(const CLI::App& app, const std::string& name) {
  return std::ranges::any_of(app.get_subcommands({}),
                             [&](const CLI::App* command) { return command->get_name() == name; });
}

int misused(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const bool no_such_command = error.get_name() == "RequiredError" && argc > 1 &&
                               argv[1][0] != '-' && !is_command(app, argv[1]) &&
                               std::string(error.what()) == "A subcommand is required";
  const std::string message =
      no_such_command ? "there is no command '" + std::string(argv[1]) + "'" : error.what();
  std::cerr << "blossom: " << message << "\n'blossom --help' shows what there is\n";
  return kExitBadInput;
}

int run(int argc, char** argv) {
  CLI::App app;
  int code = kExitComplete;
  add_commands(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help and --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return misused(app, error, argc, argv);
  }
  return stated_exit_code(code);
}

int run_guarded(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Interrupted& error) {
    return failed(error, kExitInterrupted);
  } catch (const UsageError& error) {
    return failed(error, kExitBadInput);
  } catch (const InvalidInput& error) {
    return failed(error, kExitBadInput);
  } catch (const occt::BadModel& error) {
    return failed(error, kExitBadInput);
  } catch (const std::exception& error) {
    return failed(error, kExitFailure);
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    std::cerr << "blossom: internal error: " << occt::current_failure_text() << '\n';
    return kExitFailure;
  }
}

}  // namespace
}  // namespace blossom::cli

int main(int argc, char** argv) {
  blossom::occt::quiet_messages();
  return blossom::cli::supervised([&] { return blossom::cli::run_guarded(argc, argv); });
}
