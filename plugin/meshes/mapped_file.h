// SPDX-License-Identifier: LGPL-2.1-or-later
// The bytes of a file without a copy in memory: the system reads what is looked at, and may give it
// up again. Files of scanned triangles have gigabytes.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace blossom::meshes {

/// A regular file, open for reading as long as this is there. Who cuts it off meanwhile ends the
/// program, as with every file that is mapped.
class MappedFile {
 public:
  /// throws   BadContent if it is no regular file, is empty or cannot be read
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(start_), size_}; }

 private:
  void* start_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace blossom::meshes
