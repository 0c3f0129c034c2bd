// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes the manual pages and the bash completion of the program `blossom`, made from its options,
// so that they say what the program does.
//
// usage: blossom_docs FOLDER    writes FOLDER/man/*.1.gz and FOLDER/bash/blossom

#include <zlib.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <CLI/App.hpp>

#include "plugin/cli/commands/commands.h"
#include "plugin/cli/docs/commands.h"
#include "plugin/cli/docs/completion.h"
#include "plugin/cli/docs/man_page.h"

namespace blossom::cli {
namespace {

// As `gzip -9n`: without name and time, so that the same text gives the same bytes.
void write_compressed(const std::string& text, const std::filesystem::path& file) {
  const gzFile out = gzopen(file.c_str(), "wb9");
  const bool written = out && gzwrite(out, text.data(), static_cast<unsigned>(text.size())) ==
                                  static_cast<int>(text.size());
  if (!out || gzclose(out) != Z_OK || !written)
    throw std::runtime_error(file.string() + ": cannot be written");
}

void write_docs(const std::filesystem::path& folder) {
  CLI::App program("", "blossom");
  int exit_code = 0;
  add_commands(program, exit_code);

  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "man");
  std::filesystem::create_directories(folder / "bash");
  for (const CLI::App* command : with_subcommands(program))
    write_compressed(man_page(*command), folder / "man" / (called(*command, "-") + ".1.gz"));
  std::ofstream completion(folder / "bash" / "blossom");
  completion << bash_completion(program);
  if (!completion.flush()) throw std::runtime_error("the completion cannot be written");
}

}  // namespace
}  // namespace blossom::cli

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: blossom_docs FOLDER\n";
    return 2;
  }
  try {
    blossom::cli::write_docs(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "blossom_docs: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
