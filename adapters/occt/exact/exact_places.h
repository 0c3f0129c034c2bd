// SPDX-License-Identifier: LGPL-2.1-or-later
// The places of instances to the last bit. Open CASCADE's binary form has them as matrices that it
// makes rotations once more when it reads them.

#pragma once

#include <string>

#include <BinTools_LocationSet.hxx>
#include <BinTools_ShapeSet.hxx>

namespace blossom::occt {

/// All places of a set as they are in memory, in its order.
std::string bytes_of(const BinTools_LocationSet& places);

/// Reads a set of shapes whose places are these, whatever the stream says about them.
class ExactPlacesSet : public BinTools_ShapeSet {
 public:
  /// places   what `bytes_of` made of the set that was written; has to live as long as this
  explicit ExactPlacesSet(const std::string& places) : places_(places) {}

  /// Comes after the places and before the shapes.
  /// throws   std::ios_base::failure if there are not as many places
  void ReadGeometry(Standard_IStream& in, const Message_ProgressRange& range) override;

 private:
  const std::string& places_;
};

}  // namespace blossom::occt
