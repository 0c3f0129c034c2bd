// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/docs/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/docs/commands.h"
#include "plugin/cli/version.h"

namespace blossom::cli {
namespace {

// Text as roff: a dash is a dash to be copied, a backslash is one, and no line starts a request.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += "\\&";
    if (c == '-')
      result += "\\-";
    else if (c == '\\')
      result += "\\e";
    else
      result += c;
  }
  return result;
}

std::string page_name(const CLI::App& command) { return called(command, "-"); }

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// The usage without its label, "blossom intersect [OPTIONS] A B".
std::string synopsis(const CLI::App& command) {
  const std::string usage = CLI::Formatter().make_usage(&command, called(command, " "));
  const std::size_t start = usage.find(' ') + 1;
  return usage.substr(start, usage.find('\n', start) - start);
}

void add_options(std::ostream& page, const std::vector<const CLI::Option*>& options) {
  const CLI::Formatter formatter;
  for (const CLI::Option* option : options)
    page << ".TP\n\\fB" << roff(formatter.make_option_name(option, option->get_positional()))
         << "\\fR" << roff(formatter.make_option_opts(option)) << '\n'
         << roff(option->get_description()) << '\n';
}

void add_subcommands(std::ostream& page, const CLI::App& command) {
  for (const CLI::App* below : subcommands(command))
    page << ".TP\n\\fB" << roff(page_name(*below)) << "\\fR(1)\n"
         << roff(below->get_description()) << '\n';
}

// The pages above and beside.
void add_see_also(std::ostream& page, const CLI::App& command) {
  page << ".SH SEE ALSO\n";
  if (const CLI::App* above = command.get_parent()) {
    page << ".BR " << roff(page_name(*above)) << " (1)";
    for (const CLI::App* beside : subcommands(*above))
      if (beside != &command) page << ",\n.BR " << roff(page_name(*beside)) << " (1)";
    page << '\n';
  } else {
    page
        << "The README, schemas of the reports and examples are in\n.IR /usr/share/doc/blossom .\n";
  }
}

}  // namespace

std::string man_page(const CLI::App& command) {
  std::ostringstream page;
  page << ".TH " << upper_case(roff(page_name(command))) << " 1 \"\" \"Blossom " << version_number()
       << "\" \"Blossom\"\n.SH NAME\n"
       << roff(page_name(command)) << " \\- " << roff(command.get_description())
       << "\n.SH SYNOPSIS\n.B " << roff(synopsis(command)) << '\n';
  if (const auto found = arguments(command); !found.empty()) {
    page << ".SH ARGUMENTS\n";
    add_options(page, found);
  }
  page << ".SH OPTIONS\n";
  add_options(page, options(command));
  if (!subcommands(command).empty()) {
    page << ".SH COMMANDS\n";
    add_subcommands(page, command);
  }
  if (!command.get_footer().empty())
    page << ".SH NOTES\n.nf\n" << roff(command.get_footer()) << "\n.fi\n";
  add_see_also(page, command);
  return page.str();
}

}  // namespace blossom::cli
