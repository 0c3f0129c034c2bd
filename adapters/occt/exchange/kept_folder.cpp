// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/kept_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopoDS.hxx>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exact/exact_bytes.h"
#include "adapters/occt/exchange/kept_facts.h"
#include "adapters/occt/kept_models.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".model";
constexpr std::uintmax_t kLeftBytes = kKeptBytes / 10 * 9;  // when old ones have gone

struct Folder {
  fs::path path;
  std::string reader;
};

Folder& folder() {
  static Folder folder;
  return folder;
}

// A name of 122 bits from a SHA-1 sum.
std::string name_of(const Reading& reading) {
  const boost::uuids::name_generator_sha1 content(boost::uuids::ns::oid());
  const boost::uuids::name_generator_sha1 all(content(reading.text));
  return boost::uuids::to_string(all(folder().reader + "\n" OCC_VERSION_COMPLETE "\n" +
                                     (reading.options.names ? "names" : "shapes") +
                                     (reading.options.damaged ? " of all" : "")));
}

std::uint32_t check_sum(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// Each part after its length, and a check sum of all.
std::string joined(const std::string& facts, const std::string& shape) {
  std::string bytes;
  for (const std::string* part : {&facts, &shape}) {
    const std::uint64_t length = part->size();
    bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
    bytes += *part;
  }
  const std::uint32_t sum = check_sum(bytes);
  return bytes.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
}

// throws   std::ios_base::failure if the entry is damaged
std::vector<std::string> parts_of(std::string bytes) {
  const auto damaged = [] { return std::ios_base::failure("the entry is damaged"); };
  std::uint32_t sum = 0;
  if (bytes.size() < sizeof(sum)) throw damaged();
  std::memcpy(&sum, bytes.data() + bytes.size() - sizeof(sum), sizeof(sum));
  bytes.resize(bytes.size() - sizeof(sum));
  if (sum != check_sum(bytes)) throw damaged();
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < bytes.size();) {
    std::uint64_t length = 0;
    if (bytes.size() - at < sizeof(length)) throw damaged();
    std::memcpy(&length, bytes.data() + at, sizeof(length));
    at += sizeof(length);
    if (length > bytes.size() - at) throw damaged();
    parts.push_back(bytes.substr(at, length));
    at += length;
  }
  if (parts.size() != 2) throw damaged();
  return parts;
}

// Removes those that were not used for longest, until there is room. One process at a time does it.
void make_room() {
  const int lock = ::open((folder().path / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) return;
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) {
    struct Entry {
      fs::file_time_type used;
      std::uintmax_t bytes;
      fs::path file;
    };
    std::vector<Entry> entries;
    std::uintmax_t all = 0;
    std::error_code gone;  // by another process
    for (const auto& each : fs::directory_iterator(folder().path, gone)) {
      if (each.path().extension() != kEnding) continue;
      const Entry entry{each.last_write_time(gone), each.file_size(gone), each.path()};
      if (gone) continue;
      all += entry.bytes;
      entries.push_back(entry);
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (std::size_t i = 0; all > kKeptBytes && i < entries.size(); ++i)
      for (; all > kLeftBytes && i < entries.size(); ++i) {
        fs::remove(entries[i].file, gone);
        all -= entries[i].bytes;
      }
  }
  close(lock);
}

KeptFacts facts_of(const Reading& reading, StatedTolerances stated) {
  const Contents& from = reading.contents;
  const TopTools_IndexedMapOfShape& faces = from.faces;
  const bool plain = !from.document;
  KeptFacts facts{from.unit, stated == StatedTolerances::Raised, reading.report, {}, {}, {}, {}};
  facts.names = plain ? face_names(from.parts, faces) : from.document->face_names(faces);
  facts.paths = plain ? part_paths(from.parts, faces) : from.document->part_paths(faces);
  facts.assembly =
      plain ? assembly(from.parts, from.shape, faces) : from.document->assembly(from.shape, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face& face = TopoDS::Face(faces(i));
    facts.parts.push_back(plain ? part_name(from.parts, face) : from.document->part_name(face));
  }
  return facts;
}

}  // namespace

void keep_models_in(const fs::path& path, const std::string& reader) {
  std::error_code error;
  if (!path.empty()) fs::create_directories(path, error);
  if (error || (!path.empty() && access(path.c_str(), W_OK | X_OK) != 0))
    throw Failure(path.string() + ": models cannot be kept there: " +
                  (error ? error.message() : std::strerror(errno)));
  folder() = {path.empty() ? path : fs::absolute(path), reader};
}

KeptModel::KeptModel(const Reading& reading) {
  if (!folder().path.empty() && !reading.options.looks)
    file_ = folder().path / (name_of(reading) + kEnding);
}

bool KeptModel::take(Reading& reading, StatedTolerances& stated) const {
  if (file_.empty()) return false;
  std::ifstream in(file_, std::ios::binary);
  if (!in) return false;
  try {
    const std::vector<std::string> parts = parts_of({std::istreambuf_iterator<char>(in), {}});
    KeptFacts facts = occt::facts_of(parts[0]);
    const TopoDS_Shape shape = shape_of_exact_bytes(parts[1]);
    stated = facts.raised ? StatedTolerances::Raised : StatedTolerances::Kept;
    reading.report = facts.reading;
    reading.contents.unit = facts.unit;
    reading.contents.document = kept_document(shape, std::move(facts));
    reading.contents.refresh();
    utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);  // it is in use
    return true;
  } catch (const std::ios_base::failure&) {
  } catch (const Standard_Failure&) {
  }
  std::error_code ignored;
  fs::remove(file_, ignored);
  return false;
}

void KeptModel::keep(const Reading& reading, StatedTolerances stated) const {
  if (file_.empty()) return;
  try {
    const std::optional<std::string> shape = exact_bytes(reading.contents.shape);
    if (!shape) return;
    write_text(joined(bytes_of(facts_of(reading, stated)), *shape), file_);
    make_room();
  } catch (const std::exception&) {  // the reading is done, whatever becomes of its copy
  } catch (const Standard_Failure&) {
  }
}

}  // namespace blossom::occt
