// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_list.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/hulls.h"
#include "core/base/parallel.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

// Forms are within the tolerance of faces and searched within it; wires count as far as the
// tolerance of their edges, in charts whose lengths are right to a factor.
constexpr double kReach = 2;
constexpr std::size_t kFaceGrain = 32;  // faces that one thread bounds in a row

// False too of a face that is not sound: what is wrong with it, its conversion tells.
bool has_hull(const TopoDS_Face& face, std::vector<Vec3>& points) {
  try {
    return guarded("bounding a face", [&] {
      return add_hull(TopoDS::Face(face.Located(TopLoc_Location())), points) && has_end(points);
    });
  } catch (const std::runtime_error&) {
    return false;
  }
}

// Without points if nothing is known before the face is converted.
HullBound hull_of(const TopoDS_Face& face, double tolerance) {
  std::vector<Vec3> points;
  if (!has_hull(face, points)) return {};
  HullBound hull = placed_hull(std::move(points), face.Location().Transformation());
  hull.margin += kReach * (tolerance + largest_edge_tolerance(face));
  return hull;
}

Box box_of(const HullBound& hull) {
  Box box;
  for (const Vec3& p : hull.points) box = joined(box, {p, p});
  return widened(box, hull.margin);
}

std::vector<Vec3> corners(const Box& box) {
  std::vector<Vec3> points;
  for (const double x : {box.low[0], box.high[0]})
    for (const double y : {box.low[1], box.high[1]})
      for (const double z : {box.low[2], box.high[2]}) points.push_back({x, y, z});
  return points;
}

// Stable, by counting.
//
// key   of a pair: less than `count`
template <class Key>
FacePairs sorted_by(const FacePairs& pairs, std::size_t count, Key key) {
  std::vector<std::size_t> places(count + 1);
  for (const auto& pair : pairs) ++places[static_cast<std::size_t>(key(pair)) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  FacePairs sorted(pairs.size());
  for (const auto& pair : pairs) sorted[places[static_cast<std::size_t>(key(pair))]++] = pair;
  return sorted;
}

}  // namespace

FaceList::FaceList(const std::vector<TopoDS_Face>& faces, std::string name, double tolerance,
                   Extent extent, ArcCuts cuts)
    : faces_(faces),
      name_(std::move(name)),
      tolerance_(tolerance),
      extent_(extent),
      cuts_(cuts),
      hulls_(faces.size()),
      boxes_(faces.size()),
      data_(faces.size()),
      converted_(faces.size()) {
  std::vector<char> wanted(size());
  parallel_for(size(), kFaceGrain, [&](std::size_t i) {
    hulls_[i] = hull_of(faces_[i], tolerance);
    wanted[i] = hulls_[i].points.empty();
  });
  convert(wanted);
  parallel_for(size(), kFaceGrain, [&](std::size_t i) {
    if (wanted[i]) hulls_[i].points = corners(data_[i].box);
    boxes_[i] = box_of(hulls_[i]);
  });
}

FaceList::~FaceList() {
  parallel_for(size(), kFaceGrain, [&](std::size_t i) { data_[i] = {}; });
}

BezierSurface FaceList::with_shifted_arcs(std::size_t i) const {
  return face_data(faces_[i], tolerance_, extent_, ArcCuts::Shifted).surface;
}

void FaceList::convert(const std::vector<char>& wanted) {
  std::vector<std::string> failures(size());
  parallel_for(size(), 1, [&](std::size_t i) {
    if (!wanted[i] || converted_[i]) return;
    try {
      data_[i] = guarded("converting it",
                         [&] { return face_data(faces_[i], tolerance_, extent_, cuts_); });
      converted_[i] = 1;
    } catch (const std::runtime_error& error) {
      failures[i] = error.what();
    }
  });
  for (std::size_t i = 0; i < size(); ++i) {
    if (failures[i].empty()) continue;
    const std::string place = "face " + std::to_string(i + 1);
    throw BadModel(place + (name_.empty() ? "" : " of " + name_) + ": " + failures[i]);
  }
}

FacePairs meeting_pairs(const FaceList& a, const FaceList& b) {
  FacePairs pairs;
  BoxTree(a.boxes()).for_each_meeting(BoxTree(b.boxes()),
                                      [&](int i, int j) { pairs.emplace_back(i, j); });
  pairs = sorted_by(pairs, b.size(), [](const auto& pair) { return pair.second; });
  return sorted_by(pairs, a.size(), [](const auto& pair) { return pair.first; });
}

void convert_meeting(FaceList& a, FaceList& b, FacePairs& pairs) {
  std::vector<char> in_a(a.size()), in_b(b.size());
  for (const auto& [i, j] : pairs)
    in_a[static_cast<std::size_t>(i)] = in_b[static_cast<std::size_t>(j)] = 1;
  a.convert(in_a);
  b.convert(in_b);
  std::erase_if(pairs, [&](const std::pair<int, int>& pair) {
    return !meet(a.data(static_cast<std::size_t>(pair.first)).box,
                 b.data(static_cast<std::size_t>(pair.second)).box);
  });
}

}  // namespace blossom::occt
