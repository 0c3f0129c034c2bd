// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder of models that were read before, for programs that read the same files again and again.
//
// A model is there under its content and whatever else its reading depends on, so that a file that
// was moved or packed is found, and one that was changed is not. Reading Open CASCADE's binary form
// takes about a hundredth of the time that STEP takes.
//
// What comes out of the folder is what the file gives, bit for bit: a model is put there only if it
// is the same when it is taken out again (see exact/exact_bytes.h), and read from its file ever
// after if not. It has names and assembly, but no colours, layers and dimensions, so it is used
// where these are not asked for (ReadOptions::looks), and must not be changed.
//
// Any number of processes may use a folder at the same time. Entries are put in place whole and
// end with a check sum; one that is damaged counts as none. When they take more than kKeptBytes,
// those that were not used for longest go.

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace blossom::occt {

inline constexpr std::uintmax_t kKeptBytes = 4'000'000'000;  ///< of all models in a folder

/// From now on this process keeps models in a folder, which is made if it is not there.
///
/// folder   empty: nowhere, which is how every process begins
/// reader   what tells this program from others that read differently, its version, say
/// throws   Failure if the folder cannot be made or written
void keep_models_in(const std::filesystem::path& folder, const std::string& reader);

}  // namespace blossom::occt
