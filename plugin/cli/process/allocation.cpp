// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory that is refused is noted, whatever becomes of it: Open CASCADE's repairs catch their own
// want of memory and go on with less, its parser calls the file unreadable. The functions stand
// before those of glibc, for all libraries of the process, and hand on to them. Noted are malloc,
// calloc and realloc, by which Open CASCADE and `new` have their memory, and aligned_alloc,
// memalign and posix_memalign, by which what is aligned more comes. Other libraries of C than glibc
// offer nothing to hand on to.

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include "plugin/cli/process/supervision.h"

// Sanitizers have their own.
#if defined(BLOSSOM_NOTES_ALLOCATIONS) && defined(__GLIBC__)

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): what glibc calls them
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* memory, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
// NOLINTEND(bugprone-reserved-identifier)
}

namespace blossom::cli {
namespace {

void* noted(void* memory, std::size_t size) {
  if (memory == nullptr && size > 0) report_lack_of_memory();
  return memory;
}

// An alignment that is none is refused, too, and no lack.
void* noted_aligned(std::size_t alignment, std::size_t size) {
  void* const memory = __libc_memalign(alignment, size);
  return noted(memory, std::has_single_bit(alignment) ? size : 0);
}

}  // namespace
}  // namespace blossom::cli

extern "C" {

void* malloc(std::size_t size) noexcept { return blossom::cli::noted(__libc_malloc(size), size); }

void* calloc(std::size_t count, std::size_t size) noexcept {
  return blossom::cli::noted(__libc_calloc(count, size), count > 0 ? size : 0);
}

void* realloc(void* memory, std::size_t size) noexcept {
  return blossom::cli::noted(__libc_realloc(memory, size), size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return blossom::cli::noted_aligned(alignment, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return blossom::cli::noted_aligned(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || !std::has_single_bit(alignment)) return EINVAL;
  const int before = errno;  // which the standard leaves as it is
  void* const made = blossom::cli::noted_aligned(alignment, size);
  errno = before;
  if (made == nullptr) return ENOMEM;
  *memory = made;
  return 0;
}
}

#endif
