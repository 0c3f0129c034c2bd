// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/libraries.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/modules.h"
#include "plugin/meshes/mesh_libraries.h"

namespace blossom::cli {
namespace {

constexpr std::array<std::string_view, 10> kExchanged = {
    ".step", ".stp", ".iges", ".igs", ".stepz", ".stpz", ".igesz", ".igsz", ".zip", ".glb"};

// Of FILE in FILE#FACES, without that of packing.
std::string format_ending(const std::string& word) {
  std::string name = word.substr(0, word.find('#'));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::filesystem::path file(name);
  return (file.extension() == ".gz" ? file.stem() : file).extension().string();
}

}  // namespace

Libraries libraries_for(const std::vector<std::string>& arguments) {
  Libraries wanted;
  for (const std::string& word : arguments) {
    const std::string ending = format_ending(word);
    wanted.exchange = wanted.exchange || std::ranges::find(kExchanged, ending) != kExchanged.end();
    wanted.three_mf = wanted.three_mf || ending == ".3mf";
  }
  return wanted;
}

void load(const Libraries& wanted, Libraries& loaded) {
  try {
    if (wanted.exchange && !loaded.exchange) {
      loaded.exchange = true;
      occt::step_module();
      occt::document_module();
    }
    if (wanted.three_mf && !loaded.three_mf) {
      loaded.three_mf = true;
      meshes::load_three_mf();
    }
  } catch (const occt::Failure&) {  // told by the job
  }
}

}  // namespace blossom::cli
