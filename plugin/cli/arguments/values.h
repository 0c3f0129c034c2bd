// SPDX-License-Identifier: LGPL-2.1-or-later
// What options take as values.
//
// The messages of the checks go on after the option's name: "--tolerance takes a positive number,
// not '0'".

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "plugin/reports/text/number_text.h"
#include "plugin/reports/text/vectors.h"
#include "plugin/reports/text/words.h"

namespace blossom::cli {

CLI::Validator positive_number();

/// Finite and not below 0.
CLI::Validator number_not_negative();

/// Not nan and not infinite.
CLI::Validator finite_number();

CLI::Validator whole_number(long from, long to);

/// An option that takes degrees, more than 0 and at most 180, for an angle in radians: so do all
/// angles of the command line.
/// what   for the help text, which shows the value that `radians` has as the default
CLI::Option* add_angle(CLI::App& command, const std::string& name, double& radians,
                       const std::string& what);

/// Limits an option to some words, which its help shows as "{cut,common,split}".
void limit_to(CLI::Option& option, const std::vector<std::string>& words);

using reports::finite_value;
using reports::listed;
using reports::nearest_word;
using reports::number_text;
using reports::rounded;
using reports::seconds_text;

}  // namespace blossom::cli
