// SPDX-License-Identifier: LGPL-2.1-or-later
// How the time of an intersection grows with the number of spans and of threads.

#pragma once

namespace blossom::bench {

/// Height fields of 8 x 8 to 64 x 64 spans that cross along one curve: a line each, and the
/// exponent of processor time against spans and against spans that the curve runs through.
void print_growth();

/// The largest of them with 1 and 2 threads, beside multiply-adds with 1 and 2 threads.
void print_threads();

}  // namespace blossom::bench
