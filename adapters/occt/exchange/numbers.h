// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces, edges and vertices whose numbers are none. For this folder and `documents` only.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/exchange/plain_parts.h"
#include "adapters/occt/exchange/rebuild.h"
#include "adapters/occt/reading.h"

namespace blossom::occt {

/// Where the shapes come from: it tells why something is missing.
class NumberSource {
 public:
  /// brep     the text of a BREP file; null for other formats. It has to live as long as this.
  explicit NumberSource(const std::string* brep) : brep_(brep) {}

  /// Whether the file names a curve wherever a shape has place for one.
  bool names_curves() const { return brep_ != nullptr; }

  /// Why a face has no surface; empty if that is not known.
  std::string without_surface() const;

  /// Whether the file has curves that Open CASCADE does not read. Found out once, since the text
  /// has to be read again for it.
  bool loses_curves() const;

 private:
  const std::string* brep_;
  mutable std::optional<bool> lost_curves_;
};

/// The bad shapes of a part: faces that have no surface, or whose surface, curves or points have
/// numbers that are none; edges and vertices likewise. Curves that a BREP text has and Open CASCADE
/// does not read count among these.
class BadShapes {
 public:
  BadShapes(const TopoDS_Shape& part, const NumberSource& source);

  bool none() const { return bad_.empty(); }

  /// The faces that are bad, or are bounded by what is bad.
  std::vector<Replacement> removals() const;

  /// Takes bad edges and vertices out that bound no face.
  TopoDS_Shape without_loose(const TopoDS_Shape& part) const;
  bool any_loose() const;

  void list(const std::string& part, ReadingReport& report) const;

 private:
  struct Bad {
    const char* kind;
    int number;
    TopoDS_Shape shape;
    std::string cause;
    bool loose = false;

    std::string label() const { return std::string(kind) + " " + std::to_string(number); }
  };

  void add(const char* kind, int number, const TopoDS_Shape& shape, const std::string& cause);
  void find_faces(const TopoDS_Shape& part);

  TopTools_IndexedMapOfShape faces_;
  std::vector<Bad> bad_;
  std::map<int, std::string> lost_;  // faces by number, and why
};

/// Takes bad shapes out of the parts, and lists them.
void leave_out_bad_shapes(PlainParts& parts, const NumberSource& source, ReadingReport& report);

}  // namespace blossom::occt
