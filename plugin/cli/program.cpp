// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/program.h"

#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/cli/arguments/usage.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/process/supervision.h"

namespace blossom::cli {
namespace {

int failed(const std::exception& error, int code) {
  std::cerr << "blossom: " << error.what() << '\n';
  return code;
}

int lacking_memory() {
  report_lack_of_memory();
  std::cerr << "blossom: there is not enough memory for " << doing() << '\n';
  return kExitFailure;
}

int misused(const CLI::App& app, const std::string& message) {
  std::cerr << "blossom: " << message << '\n' << help_line(app) << '\n';
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
    return misused(app, usage_message(app, error));
  } catch (const UsageError& error) {
    return misused(app, error.what());
  }
  return stated_exit_code(is_file_unwritten() ? exit_code_unwritten(code) : code);
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Interrupted& error) {
    return failed(error, kExitInterrupted);
  } catch (const InvalidInput& error) {
    return failed(error, kExitBadInput);
  } catch (const occt::BadModel& error) {
    return failed(error, kExitBadInput);
  } catch (const std::bad_alloc&) {
    return lacking_memory();
  } catch (const std::logic_error& error) {
    std::cerr << "blossom: internal error while " << doing() << ": " << error.what()
              << "; please report it with the command and its inputs\n";
    return kExitFailure;
  } catch (const std::exception& error) {
    return failed(error, kExitFailure);
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    if (occt::is_lack_of_memory()) return lacking_memory();
    std::cerr << "blossom: broke off while " << doing() << ": " << occt::current_failure_text()
              << '\n';
    return kExitFailure;
  }
}

}  // namespace blossom::cli
