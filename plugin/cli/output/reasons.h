// SPDX-License-Identifier: LGPL-2.1-or-later
// Why an answer is not proven, in summaries.

#pragma once

#include <string>
#include <vector>

#include "core/results/result.h"

namespace blossom::cli {

/// Whether the contacts that reasons speak of are listed beside them.
enum class Contacts { Listed, NotListed };

/// The reasons of a certificate as they are told.
std::vector<std::string> reported_reasons(const Certificate& certificate, Contacts contacts);

}  // namespace blossom::cli
