// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenMesh's readers fill a list of triangles here, not a mesh of half-edges, which would leave out
// what is no manifold. What headers promise is compared with the size of the file first.

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "adapters/openmesh/silence.h"
#include "adapters/openmesh/triangles.h"

namespace blossom::openmesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;
constexpr std::uint64_t kOffCounts = 12, kOffVertex = 12, kOffTriangle = 16;  // binary, at least
constexpr std::uint64_t kOffWords = 4;           // before the vertices: its name and three counts
constexpr std::size_t kHeaderBytes = 64 * 1024;  // that PLY and OFF may take for theirs
// Bytes that a vertex or a polygon takes at least, in text or binary.
constexpr std::uint64_t kLeastVertex = 6;
constexpr std::uint64_t kLeastPolygon = 4;

[[noreturn]] void refuse(const fs::path& file, const std::string& cause) {
  throw BadMesh(file.string() + ": " + cause);
}

class Collector : public OpenMesh::IO::BaseImporter {
 public:
  using Vertex = OpenMesh::VertexHandle;
  using HalfEdge = OpenMesh::HalfedgeHandle;
  using Polygon = OpenMesh::FaceHandle;

  TriangleSoup soup;
  bool names_nothing = false;  // a polygon has a vertex that is not there

  Vertex add_vertex(const OpenMesh::Vec3f& p) override { return added({p[0], p[1], p[2]}); }
  Vertex add_vertex(const OpenMesh::Vec3d& p) override { return added({p[0], p[1], p[2]}); }
  Vertex add_vertex() override { return added({}); }
  void set_point(Vertex vertex, const OpenMesh::Vec3f& p) override {
    soup.points.at(static_cast<std::size_t>(vertex.idx())) = {p[0], p[1], p[2]};
  }
  Polygon add_face(const VHandles& corners) override {
    for (const Vertex corner : corners)
      if (corner.idx() < 0 || static_cast<std::size_t>(corner.idx()) >= soup.points.size()) {
        names_nothing = true;
        return Polygon(static_cast<int>(polygons_++));
      }
    for (std::size_t k = 2; k < corners.size(); ++k)
      soup.triangles.push_back({corners[0].idx(), corners[k - 1].idx(), corners[k].idx()});
    return Polygon(static_cast<int>(polygons_++));
  }
  std::size_t n_vertices() const override { return soup.points.size(); }
  std::size_t n_faces() const override { return polygons_; }
  std::size_t n_edges() const override { return 0; }

  // What is no part of the triangles.
  HalfEdge add_edge(Vertex, Vertex) override { return HalfEdge(); }
  Polygon add_face(HalfEdge) override { return Polygon(); }
  void add_face_texcoords(Polygon, Vertex, const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(Polygon, Vertex, const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(Polygon, int) override {}
  void set_halfedge(Vertex, HalfEdge) override {}
  void set_normal(Vertex, const OpenMesh::Vec3f&) override {}
  void set_normal(Vertex, const OpenMesh::Vec3d&) override {}
  void set_color(Vertex, const OpenMesh::Vec3uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec4uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec3f&) override {}
  void set_color(Vertex, const OpenMesh::Vec4f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec2f&) override {}
  void set_status(Vertex, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_next(HalfEdge, HalfEdge) override {}
  void set_face(HalfEdge, Polygon) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfEdge, const OpenMesh::Vec2f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec3f&) override {}
  void set_texcoord(HalfEdge, const OpenMesh::Vec3f&) override {}
  void set_status(HalfEdge, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_normal(Polygon, const OpenMesh::Vec3f&) override {}
  void set_normal(Polygon, const OpenMesh::Vec3d&) override {}
  void set_color(Polygon, const OpenMesh::Vec3uc&) override {}
  void set_color(Polygon, const OpenMesh::Vec4uc&) override {}
  void set_color(Polygon, const OpenMesh::Vec3f&) override {}
  void set_color(Polygon, const OpenMesh::Vec4f&) override {}
  void set_status(Polygon, const OpenMesh::Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  Vertex added(const Vec3& p) {
    soup.points.push_back(p);
    return Vertex(static_cast<int>(soup.points.size()) - 1);
  }

  std::size_t polygons_ = 0;
};

std::string first_bytes(const fs::path& file, std::size_t count) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

void compare(const fs::path& file, std::uint64_t size, std::uint64_t vertices,
             std::uint64_t polygons) {
  // In steps, so that no product is too large for the type.
  if (vertices > size / kLeastVertex || polygons > size / kLeastPolygon)
    refuse(file, "its header promises " + std::to_string(vertices) + " vertices and " +
                     std::to_string(polygons) + " faces, more than its " + std::to_string(size) +
                     " bytes can hold: it is cut off or damaged");
}

bool is_text_stl(const std::string& head) {
  return head.starts_with("solid") && head.find("facet") != std::string::npos;
}

// Each returns how many polygons the header promises; 0 if it does not say.
std::uint64_t check_stl(const fs::path& file, std::uint64_t size) {
  const std::string head = first_bytes(file, 1024);
  if (is_text_stl(head)) return 0;
  if (head.size() < kStlHeader) refuse(file, "is too short for STL");
  std::uint32_t count = 0;
  std::memcpy(&count, head.data() + kStlHeader - sizeof count, sizeof count);  // little-endian
  const std::uint64_t room = (size - kStlHeader) / kStlFacet;
  if (count > room)
    refuse(file, "its header promises " + std::to_string(count) + " facets, it has room for " +
                     std::to_string(room) + ": it is cut off or no STL file");
  return count;
}

std::uint64_t check_ply(const fs::path& file, std::uint64_t size) {
  const std::string head = first_bytes(file, kHeaderBytes);
  const std::size_t end = head.find("end_header");
  if (!head.starts_with("ply") || end == std::string::npos) refuse(file, "has no header of PLY");
  std::istringstream lines(head.substr(0, end));
  std::uint64_t vertices = 0, polygons = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string element, name;
    std::uint64_t count = 0;
    if (!(words >> element >> name >> count) || element != "element") continue;
    (name == "vertex" ? vertices : polygons) = count;
  }
  compare(file, size, vertices, polygons);
  return polygons;
}

std::uint64_t words_in(const fs::path& file) {
  std::ifstream stream(file);
  std::uint64_t count = 0;
  for (std::string word; stream >> word;) ++count;
  return count;
}

std::uint64_t check_off(const fs::path& file, std::uint64_t size) {
  const std::string head = first_bytes(file, kHeaderBytes);
  std::istringstream lines(head);
  std::string line;
  std::getline(lines, line);
  if (line.find("OFF") == std::string::npos) refuse(file, "has no header of OFF");
  if (line.find("BINARY") != std::string::npos) {
    std::array<std::uint32_t, 2> counts{};
    const auto at = static_cast<std::size_t>(lines.tellg());
    if (head.size() < at + sizeof counts) refuse(file, "is too short for OFF");
    std::memcpy(counts.data(), head.data() + at, sizeof counts);
    compare(file, size, counts[0], counts[1]);
    if (size < at + kOffCounts + kOffVertex * std::uint64_t{counts[0]} +
                   kOffTriangle * std::uint64_t{counts[1]})
      refuse(file, "is shorter than its header says: it is cut off");
    return counts[1];
  }
  while (std::getline(lines, line)) {
    if (line.empty() || line[0] == '#' || line[0] == '\r') continue;
    std::istringstream words(line);
    std::uint64_t vertices = 0, polygons = 0;
    if (!(words >> vertices >> polygons)) refuse(file, "does not say how many vertices it has");
    compare(file, size, vertices, polygons);
    if (words_in(file) < kOffWords + 3 * vertices + 4 * polygons)
      refuse(file, "has fewer numbers than its header says: it is cut off");
    return polygons;
  }
  refuse(file, "does not say how many vertices it has");
}

std::string ending_of(const fs::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool ends_as_text_stl(const fs::path& file, std::uint64_t size) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(size > 200 ? size - 200 : 0));
  std::string tail(std::istreambuf_iterator<char>(stream), {});
  return tail.find("endsolid") != std::string::npos;
}

void check_content(const fs::path& file, const TriangleSoup& soup) {
  for (std::size_t k = 0; k < soup.points.size(); ++k)
    for (const double x : soup.points[k].coordinates)
      if (!std::isfinite(x))
        refuse(file, "vertex " + std::to_string(k + 1) + " has a coordinate that is no number");
  if (soup.triangles.empty()) refuse(file, "there is no triangle in it");
}

}  // namespace

TriangleSoup read_triangles(const fs::path& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  if (error || !std::ifstream(file)) refuse(file, "there is no such file, or it cannot be read");
  if (size == 0) refuse(file, "the file is empty");
  const std::string ending = ending_of(file);
  if (!is_mesh_ending(ending)) refuse(file, "is no mesh by its ending");
  const std::uint64_t promised = ending == ".stl"   ? check_stl(file, size)
                                 : ending == ".ply" ? check_ply(file, size)
                                 : ending == ".off" ? check_off(file, size)
                                                    : 0;
  const Silence silence;
  Collector collector;
  OpenMesh::IO::Options options;
  bool done = false;
  try {
    done = OpenMesh::IO::IOManager().read(file.string(), collector, options);
  } catch (const std::exception&) {
    done = false;  // told below
  }
  if (!done) refuse(file, "cannot be read as " + ending.substr(1) + ": it is damaged or cut off");
  if (collector.names_nothing) refuse(file, "a face names a vertex that is not there");
  // OpenMesh's readers end without a word where a file does.
  if (collector.n_faces() < promised)
    refuse(file, "ends after " + std::to_string(collector.n_faces()) + " of " +
                     std::to_string(promised) + " faces: it is cut off");
  if (ending == ".stl" && is_text_stl(first_bytes(file, 1024)) && !ends_as_text_stl(file, size))
    refuse(file, "has no end: it is cut off");
  check_content(file, collector.soup);
  return std::move(collector.soup);
}

}  // namespace blossom::openmesh
