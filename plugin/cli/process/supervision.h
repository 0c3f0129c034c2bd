// SPDX-License-Identifier: LGPL-2.1-or-later
// A command works in a child process, and its parent watches it.
//
// Open CASCADE's readers crash on some files and never return from others, and its algorithms ask
// neither for a time limit nor for signals. Whatever happens in there, the parent is left to say
// what was being done, and to end the work in time. Outputs are put in place whole (see
// occt::write_text), so the work may be killed at any moment.

#pragma once

#include <functional>
#include <string>

namespace blossom::cli {

/// What the work is at, which decides how its end is told and how long it may still take.
enum class Phase {
  Starting,
  Reading,   ///< an input; a crash is the file's fault
  Optional,  ///< what can be done without: after a crash the work begins again and leaves it out
  Working,
  Writing,  ///< makes an output, nothing of which is there yet
  Placing,  ///< puts the finished output in place, whatever the time limit
};

/// Runs the work in a child process and waits for it; where no process can be made, in this one.
///
///   SIGINT, SIGTERM, SIGHUP   the work is asked to end; killed 0.8 s later, exit code 130
///   --time-limit              the work looks at it itself; killed 0.8 s later, exit code 4.
///                             Writing what was found may take a tenth of the limit instead
///   a crash                   told with the phase and its subject; exit code 2 in reading, else 1
///   memory                    no more than the machine has; asking for more is a std::bad_alloc,
///                             told even where it cannot be caught; exit code 1
///
/// returns  the exit code
int supervised(const std::function<int()>& work);

/// How supervised work came to its end, where the exit code alone does not say it.
struct Ending {
  bool crashed = false;  ///< a signal ended it that nobody had sent
  bool lacked_memory =
      false;  ///< it could not have all memory that it asked for, whatever it did then
};

/// Of the last work that was supervised in this process.
Ending last_ending();

/// Tells the parent that memory was refused.
void report_lack_of_memory();

/// A time limit for work that is supervised from now on, in seconds; what the user says to the work
/// itself can only be less.
void set_greatest_time_limit(double seconds);

/// The same; 0 if there is none.
double greatest_time_limit();

/// Tells the parent what is being done.
/// subject   the file that is read or written, or what is being done: "intersecting"
/// step      what is being done to the file, if that is known: "transferring the shapes of a.step"
void enter(Phase phase, const std::string& subject, const std::string& step = {});

/// What was entered last, in words: "reading part.step"; "starting" before that.
std::string doing();

/// The user's limit for the whole command, in seconds from the start of the program.
void set_time_limit(double seconds);

/// Seconds of the time limit that are left, at least a microsecond; 0 if there is no limit.
double seconds_left();

/// In reading and in what is optional: more processor time than that, in seconds from now, is taken
/// for work that never ends. Without effect if the user gave a time limit.
void allow_processor_time(double seconds);

/// Whether nothing like it was said yet, also before the work began again.
bool is_news(const std::string& line);

/// Whether an optional step has crashed or did not end, by what `doing` said then.
bool has_failed(const std::string& step);

}  // namespace blossom::cli
