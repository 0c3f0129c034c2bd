// SPDX-License-Identifier: LGPL-2.1-or-later
// Packed model files: gzip, and zip archives, of which the directory at the end is read.
//
// Source: RFC 1952 (gzip); the record layouts of PKWARE's application note on ZIP files.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#define ZLIB_CONST  // it does not write into its input
#include <zlib.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {
namespace {

/// Windows of zlib: with a gzip header, or raw deflate.
enum class Wrapping { Gzip = 16 + MAX_WBITS, Raw = -MAX_WBITS };

/// Model files are packed to a tenth or so; deflate can pack what is empty to a thousandth.
constexpr std::size_t kMaxGrowth = 100;
constexpr std::size_t kAlways = 1 << 20;  // bytes that are unpacked, whatever they are packed to

/// zlib's state, ended with it.
class Inflater {
 public:
  Inflater(std::string_view bytes, Wrapping wrapping) : most_(kAlways + kMaxGrowth * bytes.size()) {
    stream_.next_in = reinterpret_cast<const Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit2(&stream_, static_cast<int>(wrapping)) != Z_OK)
      throw BadModel("cannot be unpacked");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// All that can be unpacked.
  Unpacked all() {
    Unpacked result;
    char piece[1 << 16];
    int answer = Z_OK;
    while (answer == Z_OK) {
      stream_.next_out = reinterpret_cast<Bytef*>(piece);
      stream_.avail_out = sizeof(piece);
      answer = inflate(&stream_, Z_NO_FLUSH);
      result.text.append(piece, sizeof(piece) - stream_.avail_out);
      if (result.text.size() > most_) throw BadModel("unpacks to more than 100 times its size");
    }
    result.cut = answer != Z_STREAM_END;
    return result;
  }
  std::size_t left() const { return stream_.avail_in; }

 private:
  z_stream stream_{};
  std::size_t most_;
};

/// zlib counts in 32 bits.
void require_size(std::string_view bytes) {
  if (bytes.size() > UINT32_MAX) throw BadModel("is packed, and larger than 4 GB");
}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// A gzip file may be several, one behind the other.
Unpacked gunzipped(std::string_view bytes) {
  Unpacked whole;
  while (is_gzip(bytes) && !whole.cut) {
    Inflater inflater(bytes, Wrapping::Gzip);
    const Unpacked part = inflater.all();
    whole.text += part.text;
    whole.cut = part.cut;
    bytes.remove_prefix(bytes.size() - inflater.left());
  }
  return whole;
}

/// A number of so many bytes, the least first; 0 behind the end.
std::uint32_t number_at(std::string_view bytes, std::size_t place, int size) {
  std::uint32_t number = 0;
  for (int i = size - 1; i >= 0; --i) {
    const std::size_t at = place + static_cast<std::size_t>(i);
    number = number << 8 | (at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U);
  }
  return number;
}

/// A file of an archive, as its directory tells.
struct Entry {
  std::string_view name;
  std::uint32_t method = 0, packed = 0, header = 0;
};

constexpr std::string_view kLocal = "PK\x03\x04", kCentral = "PK\x01\x02", kEnd = "PK\x05\x06";

std::vector<Entry> entries_of(std::string_view bytes) {
  const std::size_t end = bytes.rfind(kEnd);
  if (end == std::string_view::npos) throw BadModel("is a zip archive that is cut off");
  std::vector<Entry> entries;
  std::size_t place = number_at(bytes, end + 16, 4);
  while (place < bytes.size() && bytes.substr(place).starts_with(kCentral)) {
    const std::size_t name = number_at(bytes, place + 28, 2);
    if (place + 46 + name > bytes.size()) break;
    entries.push_back({bytes.substr(place + 46, name), number_at(bytes, place + 10, 2),
                       number_at(bytes, place + 20, 4), number_at(bytes, place + 42, 4)});
    place += 46 + name + number_at(bytes, place + 30, 2) + number_at(bytes, place + 32, 2);
  }
  return entries;
}

Unpacked content_of(std::string_view bytes, const Entry& entry) {
  constexpr std::uint32_t kStored = 0, kDeflated = 8;
  const std::size_t start = std::size_t{entry.header} + 30 +
                            number_at(bytes, entry.header + 26, 2) +
                            number_at(bytes, entry.header + 28, 2);
  if (start > bytes.size() || !bytes.substr(entry.header).starts_with(kLocal))
    throw BadModel("is a zip archive that is damaged");
  const std::string_view packed = bytes.substr(start, entry.packed);
  if (entry.method == kStored) return {std::string(packed), packed.size() < entry.packed};
  if (entry.method != kDeflated)
    throw BadModel("is a zip archive packed in a way that is not known");
  return Inflater(packed, Wrapping::Raw).all();
}

Unpacked first_model(std::string_view bytes) {
  std::optional<Unpacked> first;
  for (const Entry& entry : entries_of(bytes)) {
    if (entry.name.ends_with('/')) continue;
    Unpacked content = content_of(bytes, entry);
    narrow_letters(content.text);
    if (!format_of_content(content.text)) continue;
    if (first) {
      first->others.emplace_back(entry.name);
    } else {
      first = std::move(content);
      first->name = entry.name;
    }
  }
  if (!first) throw BadModel("is a zip archive without a STEP, IGES or BREP file");
  return *std::move(first);
}

}  // namespace

Unpacked unpacked(std::string bytes) {
  const bool gzip = is_gzip(bytes), zip = bytes.starts_with(kLocal) || bytes.starts_with(kEnd);
  if (!gzip && !zip) return {std::move(bytes)};
  require_size(bytes);
  return gzip ? gunzipped(bytes) : first_model(bytes);
}

}  // namespace blossom::occt
