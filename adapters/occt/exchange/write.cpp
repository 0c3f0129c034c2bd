// SPDX-License-Identifier: LGPL-2.1-or-later
// Models to files. All formats are made as text in memory, so that one place writes to the disk and
// knows why it cannot.

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <BRepTools.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/listening.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/repair/closed_corners.h"
#include "adapters/occt/repair/missing_curves.h"
#include "adapters/occt/repair/polar_faces.h"
#include "adapters/occt/repair/spline_hyperbolas.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;

/// Version 1 without triangles: every Open CASCADE reads it.
std::string version_1_text(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out, false, false, TopTools_FormatVersion_VERSION_1);
  return std::move(out).str();
}

[[noreturn]] void fail(const fs::path& file, const std::string& what, int error) {
  throw Failure(file.string() + ": " + what + ": " + std::strerror(error));
}

/// An open file that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(int number) {
    if (number_ >= 0) ::close(number_);
    number_ = number;
    return *this;
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

void write_all(int descriptor, std::string_view text, const fs::path& file) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(file, "cannot be written", written < 0 ? errno : EIO);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A file that is gone again unless it is moved to its target. Where the file system can, it has no
/// name until it is whole, so that nothing of it stays even if the program is killed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : target_(target),
        descriptor_(::open(target.parent_path().c_str(), O_TMPFILE | O_WRONLY, 0600)) {
    if (!descriptor_.is_open() || !fs::exists(self())) make_named();
    if (!descriptor_.is_open()) fail(target, "its folder cannot be written to", errno);
  }
  ~TemporaryFile() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view text) {
    write_all(descriptor_.number(), text, target_);
    if (::fsync(descriptor_.number()) != 0) fail(target_, "cannot be written", errno);
  }

  void move_to_target(mode_t mode) {
    if (::fchmod(descriptor_.number(), mode) != 0 || !has_name() || !descriptor_.close() ||
        ::rename(name_.c_str(), target_.c_str()) != 0)
      fail(target_, "cannot be put in place", errno);
    name_.clear();
    const Descriptor folder(::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY));
    // The data are safe; a folder that cannot be synchronized is no reason to fail.
    if (folder.is_open()) ::fsync(folder.number());
  }

 private:
  /// Its link in the table of open files, by which it can be given a name.
  std::string self() const { return "/proc/self/fd/" + std::to_string(descriptor_.number()); }

  std::string beside(const std::string& ending) const {
    return (target_.parent_path() / ("." + target_.filename().string() + "." + ending)).string();
  }

  void make_named() {
    name_ = beside("XXXXXX");
    descriptor_ = ::mkstemp(name_.data());
    if (!descriptor_.is_open()) name_.clear();
  }

  /// Gives the file a name of its own if it has none: a link cannot replace the target at once.
  bool has_name() {
    constexpr int kMaxNames = 100;  // tried until one is free
    for (int i = 0; i < kMaxNames && name_.empty(); ++i) {
      const std::string name = beside(std::to_string(::getpid()) + "-" + std::to_string(i));
      if (::linkat(AT_FDCWD, self().c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
        name_ = name;
      else if (errno != EEXIST)
        break;
    }
    return !name_.empty();
  }

  fs::path target_;
  std::string name_;  // empty while the file has none
  Descriptor descriptor_;
};

/// The rights of the file that is there, or those that a new file gets.
mode_t rights_for(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// A device or pipe: there is nothing to keep, and nothing to rename.
void write_through(const std::string& text, const fs::path& file) {
  Descriptor target(::open(file.c_str(), O_WRONLY));
  if (!target.is_open()) fail(file, "cannot be opened for writing", errno);
  write_all(target.number(), text, file);
  if (!target.close()) fail(file, "cannot be written", errno);
}

}  // namespace

bool keeps_internal_edges(const std::filesystem::path& file) {
  return format_of(file) == Format::Brep;
}

bool keeps_names(const std::filesystem::path& file) { return format_of(file) != Format::Brep; }

void write_text(const std::string& text, const std::filesystem::path& file,
                const std::function<void()>& stop) {
  std::error_code error;
  // A link stays a link: what it points to is replaced.
  const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error || target.filename().empty()) throw Failure(file.string() + ": is no file name");
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw Failure(file.string() + ": is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_through(text, file);
  if (!fs::is_directory(target.parent_path(), error))
    throw Failure(file.string() + ": the folder '" + target.parent_path().string() +
                  "' does not exist");
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) fail(file, "is protected", errno);
  TemporaryFile temporary(target);
  temporary.write(text);
  if (stop) stop();
  temporary.move_to_target(rights_for(target));
}

namespace {

std::string count_text(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string bent_text(const ClosedCorners& closed) {
  std::ostringstream text;
  text << count_text(closed.count(), "end") << " of curves in space bent by up to "
       << closed.worst() << " to meet in their vertices, since readers move whole curves for it";
  return text.str();
}

std::string halved_text(std::size_t count) {
  return count_text(count, "face") + " from pole to pole round a hole written as two halves" +
         (count == 1 ? "" : " each") + ", since readers take the hole for the face";
}

/// What the model's file has beside shapes and this one has not; empty if that is nothing. STEP
/// keeps what Open CASCADE finds on shapes that are written; of a part, all that is of others is
/// told so.
std::string lost_text(const BesideShapes& had, const BesideShapes& has, Format format) {
  std::vector<std::string> lost;
  for (const auto& [kind, count] : had) {
    const auto kept = has.find(kind);
    const int left = kept == has.end() ? count : count - kept->second;
    if (left > 0) lost.push_back(count_text(static_cast<std::size_t>(left), kind));
  }
  std::string text;
  for (std::size_t i = 0; i < lost.size(); ++i)
    text += (i == 0 ? "written without " : i + 1 < lost.size() ? ", " : " and ") + lost[i];
  if (text.empty()) return text;
  text += " of the file that was read";
  return format == Format::Step ? text + ", which touch nothing that is written" : text;
}

FileContent content_of(const Model& model, Contents& contents, Format format,
                       std::vector<WriteNote>& notes) {
  if (format == Format::Brep) return {version_1_text(model.shape())};
  if (format == Format::Glb) return {document_of(contents).content(format, contents.unit)};
  if (format == Format::Iges) {
    const SplineHyperbolas splines(model.shape());
    return document_of(contents).content(format, contents.unit);
  }
  const ClosedCorners closed(model.shape());
  if (closed.count() > 0) notes.push_back({.text = bent_text(closed), .within_tolerance = true});
  return document_of(contents).content(format, contents.unit);
}

/// Faces from pole to pole round a hole are halved.
///
/// returns   nothing if there are none
std::optional<Model> halved(const Model& model, std::vector<WriteNote>& notes) {
  if (polar_faces(model.shape()).empty()) return {};
  Model made = model.copy();
  const auto halves = polar_faces(made.shape());
  made.replace_faces(halves);
  notes.push_back({halved_text(halves.size())});
  return made;
}

/// Numbers of faces, and of their edges without a curve in the parameters of the face.
std::map<int, std::set<int>> faces_without_curves(const TopoDS_Shape& shape) {
  std::map<int, std::set<int>> found;
  const std::vector<MissingCurve> missing = missing_curves(shape);
  if (missing.empty()) return found;
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (const MissingCurve& at : missing)
    found[faces.FindIndex(at.face)].insert(edges.FindIndex(at.edge));
  return found;
}

/// "face 7, whose edge 13 has no curve in the parameters of the face"
std::string without_text(const std::map<int, std::set<int>>& faces) {
  std::string text;
  for (const auto& [face, edges] : faces) {
    text += (text.empty() ? "without face " : "; face ") + std::to_string(face) +
            (edges.size() == 1 ? ", whose edge" : ", whose edges");
    for (const int edge : edges)
      text += (edge == *edges.begin() ? " " : ", ") + std::to_string(edge);
    text += edges.size() == 1 ? " has" : " have";
    text += " no curve in the parameters of the face";
  }
  return text + ": only BREP has such faces";
}

/// Open CASCADE's writers of STEP and IGES break down on such faces.
///
/// returns   nothing if there are none
/// throws    Failure if nothing is left without them
std::optional<Model> without_odd_faces(const Model& model, const fs::path& file,
                                       std::vector<WriteNote>& notes) {
  const std::map<int, std::set<int>> odd = faces_without_curves(model.shape());
  if (odd.empty()) return {};
  Model made = model.copy();
  std::map<int, std::vector<TopoDS_Face>> none;
  for (const auto& [face, edges] : odd) none[face];
  made.replace_faces(none);
  if (made.shape().IsNull())
    throw Failure(file.string() + ": nothing would be left: " + without_text(odd));
  notes.push_back({.text = "written " + without_text(odd), .shapes_lost = true});
  return made;
}

}  // namespace

std::vector<WriteNote> write_model(const Model& given, const std::filesystem::path& file,
                                   const std::function<void()>& stop) {
  const Format format = format_of(file);
  if (given.shape().IsNull()) throw Failure(file.string() + ": the model is empty");
  std::vector<WriteNote> notes;
  std::optional<Model> changed;
  if (format == Format::Step || format == Format::Iges)
    changed = without_odd_faces(given, file, notes);
  if (format == Format::Step)
    if (auto halves = halved(changed ? *changed : given, notes)) changed = std::move(halves);
  const Model& model = changed ? *changed : given;
  FileContent content;
  try {
    const std::lock_guard guard(exchange_lock());
    const Listening listening;  // it tells of each face that its writers cannot simplify
    content = guarded("writing", [&] { return content_of(model, *model.impl_, format, notes); });
  } catch (const Failure& failure) {
    throw Failure(file.string() + ": " + failure.what());
  }
  if (format != Format::Glb)  // triangles, which are to be looked at
    if (std::string lost = lost_text(model.impl_->beside, content.beside, format); !lost.empty())
      notes.push_back({std::move(lost)});
  if (stop) stop();
  write_text(content.bytes, file, stop);
  return notes;
}

}  // namespace blossom::occt
