// SPDX-License-Identifier: LGPL-2.1-or-later
// What the programs that measure models by a list of files have in common.

#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/shapes.h"

namespace blossom::bench {

/// What those that draw pairs of a file's faces are told.
struct PairSettings {
  std::uint64_t seed = 1;
  int pairs = 6;      ///< of a kind and file
  double limit = 10;  ///< seconds for each
  bool peers = false;
  std::string keep{};  ///< a folder for what went wrong
  std::vector<std::string> files{};
};

/// Nothing if no file is named.
/// peers_word   changes whether peers run, too
inline std::optional<PairSettings> pair_settings(PairSettings settings, const char* peers_word,
                                                 int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--seed")
      settings.seed = std::strtoull(value(), nullptr, 10);
    else if (word == "--pairs")
      settings.pairs = std::atoi(value());
    else if (word == "--limit")
      settings.limit = std::atof(value());
    else if (word == "--keep")
      settings.keep = value();
    else if (word == peers_word)
      settings.peers = !settings.peers;
    else
      settings.files.push_back(word);
  }
  if (settings.files.empty()) return std::nullopt;
  return settings;
}

/// Runs with the settings of the command line; prints the usage and returns 2 if there are none.
template <class Settings>
int run_command(const std::optional<Settings>& settings, const char* usage,
                int (*run_all)(const Settings&)) {
  if (!settings) {
    std::fprintf(stderr, "%s\n", usage);
    return 2;
  }
  occt::quiet_messages();
  return run_all(*settings);
}

}  // namespace blossom::bench
