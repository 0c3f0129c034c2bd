// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether this build has AddressSanitizer or ThreadSanitizer: GCC says so by a macro, clang by a
// feature.

#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define BLOSSOM_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOSSOM_ADDRESS_SANITIZER
#endif
#endif

#if defined(__SANITIZE_THREAD__)
#define BLOSSOM_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define BLOSSOM_THREAD_SANITIZER
#endif
#endif
