// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fuzzing target is: one function that takes any bytes at all.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace blossom::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Does the target's work on an input. Errors that the library promises are caught; all else, an
/// exception of another kind, a failed check, or a signal, is a finding.
void try_input(Bytes input);

/// Processor seconds that an input may take.
inline constexpr int kMaxSeconds = 10;

/// Ends the process by SIGABRT if it takes more than kMaxSeconds from now on.
void watch_time();

/// No longer: what is done between inputs is the fuzzer's own.
void stop_watching_time();

/// A check that stays in every build. Ends the process with the words on stderr.
void require(bool holds, const char* words);

}  // namespace blossom::fuzz
