// SPDX-License-Identifier: LGPL-2.1-or-later
// Four numbers at a time.

#pragma once

// Before a function: one version of it for each vector width; 512 bits measured no faster. What it
// calls has to be always_inline to follow. Sanitizers do not get on with the loader's choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BLOSSOM_HOT __attribute__((target_clones("avx2", "default")))
#else
#define BLOSSOM_HOT
#endif

namespace blossom {

/// Four doubles that the compiler keeps in one vector register where there is one.
using Four = double __attribute__((vector_size(32)));

}  // namespace blossom
