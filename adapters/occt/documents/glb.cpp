// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles as GLB.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include <Message_ProgressRange.hxx>
#include <RWGltf_CafWriter.hxx>
#include <TColStd_IndexedDataMapOfStringString.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/listening.h"
#include "adapters/occt/documents/files.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetre = 1e-3;  // in metres

/// Open CASCADE writes into files alone, the lists of numbers into one beside.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    name_ = (fs::temp_directory_path(error) / "blossom-XXXXXX").string();
    if (error || ::mkdtemp(name_.data()) == nullptr)
      throw Failure("the folder for temporary files cannot be written to");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(name_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const char* name) const { return fs::path(name_) / name; }

 private:
  std::string name_;
};

}  // namespace

std::string glb_bytes(const Document& document) {
  const TemporaryFolder folder;
  const fs::path file = folder / "model.glb";
  const Listening listening;  // it tells of each part without faces
  RWGltf_CafWriter writer(file.c_str(), Standard_True);
  writer.ChangeCoordinateSystemConverter().SetInputLengthUnit(kMillimetre);
  writer.ChangeCoordinateSystemConverter().SetInputCoordinateSystem(RWMesh_CoordinateSystem_Zup);
  const TColStd_IndexedDataMapOfStringString no_remarks;
  if (!writer.Perform(document.handle(), no_remarks, Message_ProgressRange()))
    throw Failure("Open CASCADE cannot write the model as GLB");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  if (bytes.empty()) throw Failure("there are no triangles to be written as GLB");
  return bytes;
}

}  // namespace blossom::occt
