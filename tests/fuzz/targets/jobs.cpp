// SPDX-License-Identifier: LGPL-2.1-or-later
// A list of jobs is read, a file of results, and what users type: shards and names of inputs.
#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/batch/job_list.h"
#include "plugin/cli/batch/outcome.h"
#include "plugin/cli/exit_code.h"
#include "tests/fuzz/support/files.h"

namespace blossom::fuzz {
namespace {

template <class Work>
void unless_refused(const Work& work) try {
  work();
} catch (const cli::UsageError&) {
} catch (const occt::BadModel&) {
}

}  // namespace

void try_input(Bytes input) {
  if (input.empty()) return;
  const Bytes rest = input.subspan(1);
  const std::string text(rest.begin(), rest.end());
  switch (input.front() % 4) {
    case 0:
      return unless_refused([&] {
        cli::JobList list = cli::JobList::of_file(file_of(rest, ".jsonl"), {});
        for (std::size_t i = 0; i < list.size(); ++i) {
          const cli::Job job = list.at(i);
          const cli::Result result =
              cli::parse_result(cli::result_line(job, {.out = text, .err = text}), "a result");
          require(result.arguments == cli::hash_of(job.arguments),
                  "a result is of other arguments than its job");
        }
      });
    case 1: return unless_refused([&] { cli::parse_result(text, "results.jsonl:1"); });
    case 2: return unless_refused([&] { cli::parse_shard(text); });
    default: unless_refused([&] { cli::parse_input(text); }); cli::filled_in(text, "parts/a.step");
  }
}

}  // namespace blossom::fuzz
