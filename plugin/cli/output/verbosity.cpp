// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/verbosity.h"

#include <iostream>

#include "plugin/cli/process/supervision.h"

namespace blossom::cli {
namespace {

Verbosity current = Verbosity::Normal;

void say(const std::string& text) {
  if (is_news(text)) std::cerr << "blossom: " << text << '\n';
}

}  // namespace

Verbosity verbosity() { return current; }

void set_verbosity(Verbosity level) { current = level; }

void note(const std::string& text) {
  if (current != Verbosity::Quiet) say(text);
}

void detail(const std::string& text) {
  if (current == Verbosity::Verbose) say(text);
}

}  // namespace blossom::cli
