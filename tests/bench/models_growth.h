// SPDX-License-Identifier: LGPL-2.1-or-later
// How the time of an intersection grows with the number of spans and of threads.

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace blossom::bench {

/// Height fields of 8 x 8 to 64 x 64 spans that cross along one curve; of 2 x 2 to 16 x 16 faces;
/// and of 2 to 128 loops on 64 x 64 spans: a line each, and the exponents of processor time against
/// all there is and against what of it the curves run through and their poles.
/// csv   a file for the same lines, for growth_plot.py; empty for none
void print_growth(const std::string& csv = {});

/// Work that takes a number of threads.
struct ThreadJob {
  std::string name;
  std::function<void(int threads)> work;
};

/// The largest fields, and these jobs, with 1 and 2 threads, beside multiply-adds in the same
/// rounds: the least times of the clock, and what part of their gain each job gains.
void print_threads(const std::vector<ThreadJob>& more);

}  // namespace blossom::bench
