// SPDX-License-Identifier: LGPL-2.1-or-later
// A target without libFuzzer: tries every file that is named, those in folders, and random bytes.
//
//   fuzz_surfaces FILE... FOLDER...
//   fuzz_surfaces --random 1 1000      inputs 1 to 1000, always the same
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/support/target.h"

namespace {

constexpr std::size_t kRandomBytes = 400;

// The name is known if the input ends the process.
void try_named(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  std::cout << name << std::endl;
  blossom::fuzz::watch_time();
  blossom::fuzz::try_input(bytes);
  blossom::fuzz::stop_watching_time();
}

void try_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  try_named(file.filename().string(), {std::istreambuf_iterator<char>(in), {}});
}

void try_random(unsigned long number) {
  std::mt19937_64 random(number);
  std::vector<std::uint8_t> bytes(random() % kRandomBytes);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  try_named("random " + std::to_string(number), bytes);
}

// How many there were.
int try_path(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) {
    try_file(path);
    return 1;
  }
  int tried = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
    if (entry.is_regular_file()) {
      try_file(entry.path());
      ++tried;
    }
  return tried;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() == 3 && words.front() == "--random") {
    const unsigned long last = std::stoul(words[2]);
    for (unsigned long number = std::stoul(words[1]); number <= last; ++number) try_random(number);
    return 0;
  }
  int tried = 0;
  for (const std::string& word : words) tried += try_path(word);
  if (tried == 0) std::cerr << "no input is given\n";
  return tried == 0 ? 2 : 0;
}
