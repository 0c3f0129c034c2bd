// SPDX-License-Identifier: LGPL-2.1-or-later
// How the time of an intersection grows with the number of spans and of threads.

#pragma once

#include <string>

namespace blossom::bench {

/// Height fields of 8 x 8 to 64 x 64 spans that cross along one curve; of 2 x 2 to 16 x 16 faces;
/// and of 2 to 128 loops on 64 x 64 spans: a line each, and the exponents of processor time against
/// all there is and against what of it the curves run through and their poles.
/// csv   a file for the same lines, for growth_plot.py; empty for none
void print_growth(const std::string& csv = {});

/// The largest of them with 1 and 2 threads, beside multiply-adds with 1 and 2 threads.
void print_threads();

}  // namespace blossom::bench
