// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plugin/meshes/formats/mesh_formats.h"

namespace blossom::meshes {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status {};
  const bool regular = opened >= 0 && ::fstat(opened, &status) == 0 && S_ISREG(status.st_mode);
  if (regular && status.st_size > 0) {
    size_ = static_cast<std::size_t>(status.st_size);
    start_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, opened, 0);
  }
  if (opened >= 0) ::close(opened);
  if (regular && size_ == 0) throw BadContent("the file is empty");
  if (!regular || start_ == MAP_FAILED)
    throw BadContent("there is no such file, or it cannot be read");
  ::madvise(start_, size_, MADV_SEQUENTIAL);  // what was read is given up first
}

MappedFile::~MappedFile() { ::munmap(start_, size_); }

}  // namespace blossom::meshes
