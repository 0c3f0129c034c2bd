// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/fuzz/support/files.h"

#include <unistd.h>

#include <fstream>

namespace blossom::fuzz {
namespace {

/// Goes with the process.
struct Folder {
  Folder() {
    const std::filesystem::path memory = "/dev/shm";
    path =
        (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
        ("blossom-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    if (owner == getpid()) std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path path;
  pid_t owner = getpid();  // not that of children
};

}  // namespace

std::filesystem::path file_of(Bytes bytes, const std::string& ending) {
  static const Folder folder;
  std::filesystem::path file = folder.path / ("input" + ending);
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  for (const std::uint8_t byte : bytes) out.put(static_cast<char>(byte));
  require(out.good(), "the input cannot be written as a file");
  return file;
}

}  // namespace blossom::fuzz
