// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/models_measure.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <ctime>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace blossom::bench {
namespace {

// In the child: what is there already does not count.
[[noreturn]] void work_and_report(int pipe, double limit, const std::function<Outcome()>& work) {
  const double start = processor_seconds();
  const auto most = static_cast<rlim_t>(std::ceil(start + limit));
  const rlimit bounds{most, most + 1};
  setrlimit(RLIMIT_CPU, &bounds);
  Outcome outcome;
  try {
    outcome = work();
  } catch (const Standard_Failure&) {
    outcome.failed = true;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_models: %s\n", error.what());
    outcome.failed = true;
  }
  outcome.seconds = processor_seconds() - start;
  const bool written = write(pipe, &outcome, sizeof outcome) == sizeof outcome;
  _exit(written ? 0 : 1);
}

}  // namespace

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome measured(double limit, const std::function<Outcome()>& work) {
  Outcome outcome;
  int ends[2];
  if (pipe(ends) != 0) return {.failed = true};
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) work_and_report(ends[1], limit, work);
  close(ends[1]);
  const bool answered = child > 0 && read(ends[0], &outcome, sizeof outcome) == sizeof outcome;
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (answered) return outcome;
  outcome = {};
  outcome.status = Status::Stopped;
  outcome.failed = !(WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU));
  outcome.ended = outcome.failed;
  outcome.seconds = limit;
  return outcome;
}

double length_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  double sum = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (!BRep_Tool::Degenerated(edge)) sum += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
  }
  return sum;
}

}  // namespace blossom::bench
