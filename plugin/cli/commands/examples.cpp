// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/examples.h"

#include <map>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace blossom::cli {
namespace {

// By the names of commands, which are all different.
const std::map<std::string, std::string> kExamples{
    {"info", "  blossom info part.step --faces\n  blossom info 'gearbox.step#Bolt' --edges\n"},
    {"check",
     "  blossom check part.step --fail-on findings\n"
     "  blossom check part.step --continuity --angle 0.5 --picture edges.png\n"},
    {"intersect",
     "  blossom intersect hull.step deck.step -o edges.step\n"
     "  blossom intersect a.stl b.step -o curves.step\n"},
    {"self-intersect",
     "  blossom self-intersect part.step --faces\n"
     "  blossom self-intersect *.step --table faults.csv\n"},
    {"trim",
     "  blossom trim hull.step deck.step --keep below -o lower.step\n"
     "  blossom trim block.step drill.step --solid cut -o drilled.step\n"},
    {"fillet",
     "  blossom blend fillet block.step --edges convex --radius 2 -o round.step\n"
     "  blossom blend fillet 'gearbox.step#Bolt' --edges 37:0.5,39:0.2 -o round.step\n"},
    {"chamfer",
     "  blossom blend chamfer block.step --edges 5,7 --distance 2 -o cut.step\n"
     "  blossom blend chamfer block.step --edges all --distance 2:30 -o cut.step\n"},
    {"fill",
     "  blossom blend fill open.step --sew -o closed.step\n"
     "  blossom blend fill scan.stl -o whole.stl\n"},
    {"strip",
     "  blossom blend strip a.step#1 b.step#2 -o strip.step\n"
     "  blossom blend strip a.step#1 b.step#2 --continuity G2 --edge-a 3 -o strip.step\n"},
    {"subdivide",
     "  blossom subdivide part.step#3 --levels 2 -o pieces.step\n"
     "  blossom subdivide part.step#3 --rectangle 0 0.5 0 1 --whole -o half.step\n"},
    {"convert",
     "  blossom convert part.step -o part.stl --deviation 0.1 --angle 15\n"
     "  blossom convert part.step -o patches.step --to bezier\n"},
    {"clash",
     "  blossom clash machine.step --clearance 0.5 --table pairs.csv\n"
     "  blossom clash block.step drill.step -o common.step --fail-on findings\n"},
    {"plane",
     "  blossom query plane hull.step --point 0,0,5 --normal 0,0,1 -o cut.dxf\n"
     "  blossom query plane hull.step --offsets 0:100:11 -o cuts.step\n"},
    {"ray",
     "  blossom query ray part.step --from 0,0,100 --direction 0,0,-1\n"
     "  blossom query ray part.step --from 0,0,100 --direction 0,0,-1 --first\n"},
    {"point",
     "  blossom query point part.step --at 10,0,5\n"
     "  blossom query point part.step --at 10,0,5 --all\n"},
    {"distance",
     "  blossom query distance a.step b.step\n"
     "  blossom query distance scan.stl part.step --within 0.05 --fail-on findings\n"},
    {"does-intersect",
     "  blossom query does-intersect a.step b.step\n"
     "  blossom query does-intersect a.step b.step --fail-on findings || echo they meet\n"},
    {"mass",
     "  blossom query mass part.step -v\n"
     "  blossom query mass part.step --density 7850\n"},
    {"batch",
     "  blossom batch --each '*.step' -o results.jsonl -- check {} --json -\n"
     "  blossom batch jobs.jsonl -o results.jsonl -j 4\n"},
};

constexpr const char* kExitStatus =
    "Exit status:\n"
    "  0 done, and proven; 3 done, but for what is listed; 4 stopped by a limit;\n"
    "  5 there are findings (--fail-on findings); 2 bad usage or input;\n"
    "  1 failure: a result cannot be written, or nothing is left of it; 130 interrupted\n";

}  // namespace

void add_examples(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    add_examples(*command);
    const auto known = kExamples.find(command->get_name());
    if (known != kExamples.end())
      command->footer("Examples:\n" + known->second + "\n" + kExitStatus);
  }
}

}  // namespace blossom::cli
