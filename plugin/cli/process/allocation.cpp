// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory that is refused is noted, whatever becomes of it: Open CASCADE's repairs catch their own
// want of memory and go on with less, its parser calls the file unreadable. The functions stand
// before those of glibc, for all libraries of the process, and hand on to them. Noted are malloc,
// calloc and realloc, by which Open CASCADE and `new` have their memory, and aligned_alloc,
// memalign, posix_memalign, valloc and pvalloc, by which what is aligned more comes. Other
// libraries of C than glibc offer nothing to hand on to.

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
void* __libc_valloc(std::size_t size) noexcept;
void* __libc_pvalloc(std::size_t size) noexcept;
// NOLINTEND(bugprone-reserved-identifier)
}

namespace blossom::cli {
namespace {

// What is refused for an alignment that glibc does not take is no lack, and realloc of 0 bytes
// gives nothing.
void* noted(void* memory, std::size_t size) {
  if (memory == nullptr && size > 0 && errno == ENOMEM) report_lack_of_memory();
  return memory;
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
  return blossom::cli::noted(__libc_memalign(alignment, size), size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return blossom::cli::noted(__libc_memalign(alignment, size), size);
}

void* valloc(std::size_t size) noexcept { return blossom::cli::noted(__libc_valloc(size), size); }

void* pvalloc(std::size_t size) noexcept { return blossom::cli::noted(__libc_pvalloc(size), size); }

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || !std::has_single_bit(alignment)) return EINVAL;
  const int before = errno;  // which the standard leaves as it is
  void* const made = blossom::cli::noted(__libc_memalign(alignment, size), size);
  errno = before;
  if (made == nullptr) return ENOMEM;
  *memory = made;
  return 0;
}
}

#endif
