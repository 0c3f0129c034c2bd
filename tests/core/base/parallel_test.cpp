// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/parallel.h"

#include <atomic>
#include <cstddef>
#include <thread>

#include <gtest/gtest.h>

#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace blossom {
namespace {

// Short tasks, some of them within others, as an intersection has them.
std::size_t tasks_done() {
  std::atomic<std::size_t> done{0};
  parallel_for(8, 1, [&](std::size_t) { parallel_for(16, 1, [&](std::size_t) { ++done; }); });
  return done;
}

#if defined(__unix__)
// Of a child made now: 0 if it does the same, and knows that it is alone.
int status_of_child() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(20);  // a signal ends it where it waits for threads that are not there
    ::_exit(tasks_done() == 128 && !threads_can_help() ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

TEST(Threads, ThatAreLostInAForkAreNotWaitedFor) {
  EXPECT_TRUE(threads_can_help());
  std::atomic<bool> enough{false};
  std::thread other([&] {
    while (!enough) tasks_done();
  });
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(tasks_done(), 128u);
    const int status = status_of_child();
    EXPECT_EQ(status, 0) << "fork " << i;
    if (status != 0) break;
  }
  enough = true;
  other.join();
}
#endif

}  // namespace
}  // namespace blossom
