// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/libraries.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/exchange/modules.h"
#include "plugin/meshes/mesh_libraries.h"

namespace blossom::cli {
namespace {

// Of FILE in FILE#FACES, in small letters, without the ending of packing.
std::filesystem::path unpacked_name(const std::string& word) {
  std::string name = word.substr(0, word.find('#'));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::filesystem::path file(name);
  const std::string ending = file.extension().string();
  if (ending == ".gz") return file.stem();
  if (ending.ends_with('z')) name.pop_back();
  return name;
}

bool is_exchanged(const std::filesystem::path& file) {
  if (file.extension() == ".zip") return true;
  try {
    return occt::format_of(file) != occt::Format::Brep;
  } catch (const occt::BadModel&) {  // most words are no files
    return false;
  }
}

bool succeeds(const std::function<void()>& load) {
  try {
    load();
    return true;
  } catch (const occt::Failure&) {  // told by the job
    return false;
  }
}

}  // namespace

Libraries libraries_for(const std::vector<std::string>& arguments) {
  Libraries wanted;
  for (const std::string& word : arguments) {
    const std::filesystem::path file = unpacked_name(word);
    wanted.exchange = wanted.exchange || is_exchanged(file);
    wanted.three_mf = wanted.three_mf || file.extension() == ".3mf";
  }
  return wanted;
}

const LibraryLoaders& own_libraries() {
  static const LibraryLoaders own{[] { occt::step_module(); }, [] { occt::document_module(); },
                                  meshes::load_three_mf};
  return own;
}

void load(const Libraries& wanted, Libraries& loaded, const LibraryLoaders& by) {
  if (wanted.exchange && !loaded.exchange) {
    const bool step = succeeds(by.step), documents = succeeds(by.documents);
    loaded.exchange = step && documents;
  }
  if (wanted.three_mf && !loaded.three_mf) loaded.three_mf = succeeds(by.three_mf);
}

}  // namespace blossom::cli
