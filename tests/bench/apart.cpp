// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/apart.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>

#include <Standard_Failure.hxx>

namespace blossom::bench {
namespace {

bool write_all(int to, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t done = write(to, data, size);
    if (done <= 0) return false;
    data += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool read_all(int from, char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t done = read(from, data, size);
    if (done <= 0) return false;
    data += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// In the child: time that was spent before does not count.
[[noreturn]] void work_and_report(int pipe, double limit, const std::function<void()>& work,
                                  const void* answer, std::size_t size) {
  const auto most = static_cast<rlim_t>(std::ceil(processor_seconds() + limit));
  const rlimit bounds{most, most + 1};
  setrlimit(RLIMIT_CPU, &bounds);
  try {
    work();
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.GetMessageString());
    _exit(1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(1);
  }
  _exit(write_all(pipe, static_cast<const char*>(answer), size) ? 0 : 1);
}

}  // namespace

double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

Ending work_apart(double limit, const std::function<void()>& work, void* answer, std::size_t size) {
  int ends[2];
  if (pipe(ends) != 0) return Ending::Died;
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) work_and_report(ends[1], limit, work, answer, size);
  close(ends[1]);
  const bool answered = child > 0 && read_all(ends[0], static_cast<char*>(answer), size);
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (answered) return Ending::Done;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? Ending::OutOfTime : Ending::Died;
}

}  // namespace blossom::bench
