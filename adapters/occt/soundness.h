// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a shape: validity, gaps measured beside the tolerances that it states, wires,
// and how faces hang together.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

class KeptForms;

/// Something that is wrong.
struct Problem {
  std::string what;             ///< the same words for all of a kind
  std::optional<Vec3> place{};  ///< model units
  double gap = 0;               ///< model units; 0: it is no gap
  double tolerance = 0;         ///< that the gap exceeds

  /// Where it is, or how large; empty if there is nothing to say.
  std::string figure() const;
  std::string text() const { return what + figure(); }
};

/// Checks of Open CASCADE crash on some shapes and never end on others. Who survives that does the
/// work and says true, or leaves it out and says false.
/// what   "checking face 3"
using CheckRunner = std::function<bool(const std::string& what, const std::function<void()>& work)>;

/// What is said of a face, shell or solid whose check was left out.
inline constexpr const char* kUnchecked = "its check crashes or takes too long";

/// What a face's geometry and Open CASCADE's BRepCheck say against it, in words; none if valid.
/// forms   where the form that the face was converted to is kept for later
std::vector<std::string> face_problems(const TopoDS_Face& face, KeptForms* forms = nullptr);

/// Of these the one that BRepCheck does not see: that its surface cannot be converted.
std::vector<std::string> conversion_problems(const TopoDS_Face& face, KeptForms* forms = nullptr);

/// The same in one line; empty if the face is valid.
std::string face_fault(const TopoDS_Face& face);

/// The same of several faces, by their numbers: one by one, or, if they are many, all in threads as
/// one check unless the runner leaves that out.
std::vector<std::vector<std::string>> face_problems(const std::vector<TopoDS_Face>& faces,
                                                    const std::vector<int>& numbers,
                                                    const CheckRunner& run,
                                                    KeptForms* forms = nullptr);

/// Where the wires of a face are degenerate (they enclose nothing but what their edges' tolerances
/// cover) or meet themselves or each other but in a vertex of both edges.
std::vector<Problem> wire_problems(const TopoDS_Face& face);

/// Whether a wire that bounds the face ends somewhere, so that it encloses nothing. Edges inside of
/// the face may end.
bool has_open_wire(const TopoDS_Face& face);

/// Whether a face without a wire is all of a surface that has no end.
bool is_endless(const TopoDS_Face& face);

/// Whether the wires of a face have no width in the parameters of its surface, as where they go to
/// and fro along one line: nothing of it can be searched.
bool has_no_width(const TopoDS_Face& face);

/// Lengths in model units; gaps as in `EdgeGaps`, the largest over all uses of the edge.
struct EdgeSoundness {
  int number = 0;  ///< 1-based, in the order of TopExp::MapShapes
  TopoDS_Edge edge;
  std::vector<int> faces;  ///< numbers of the faces that use it, once for each use
  double tolerance = 0;    ///< that the shape states
  double gap = 0;
  double same_parameter = 0;
  double vertex_gap = 0;  ///< of the end that misses its vertex most, in tolerances of the vertex
  double vertex_tolerance = 0;
  bool free = false;  ///< used once in its shell
  bool crowded =
      false;  ///< used more than twice in its shell: no problem where a solid touches itself
  std::vector<Problem> problems;
};

struct FaceSoundness {
  int number = 0;  ///< 1-based, in the order of TopExp::MapShapes
  std::vector<int> edges;
  std::vector<Problem> problems;
};

struct Soundness {
  std::vector<FaceSoundness> faces;
  std::vector<EdgeSoundness> edges;
  std::vector<std::string> problems;  ///< of shells and solids
};

/// Looks at all of a shape.
///
/// A gap is a problem when it exceeds the stated tolerance by more than rounding; the gap at the
/// same parameter only where the edge claims to have none. A free edge is one in a solid, which has
/// to be closed; sheets may end. Faces outside of shells count as one shell. A check that was left
/// out is a problem.
Soundness soundness(const TopoDS_Shape& shape, const CheckRunner& run = {});

/// The same for faces of a shape, by number: their edges alone, nothing about shells and solids but
/// whether these edges are free or crowded.
Soundness soundness(const TopoDS_Shape& shape, const std::vector<int>& faces,
                    const CheckRunner& run = {});

/// The first problem of each face and its wires, if there is one; gaps of edges are not measured.
/// valid   whether it is known that BRepCheck finds nothing in them, which takes most of the time
std::vector<std::optional<Problem>> face_faults(const std::vector<TopoDS_Face>& faces,
                                                bool valid = false);

}  // namespace blossom::occt
