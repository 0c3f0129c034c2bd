// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/inputs.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <memory>
#include <set>
#include <system_error>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/nets/net_json.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/text/words.h"

namespace blossom::cli {
namespace {

// Face numbers of one entry, "3" or "5-9".
std::pair<int, int> face_range(const std::string& entry, const std::string& input) {
  const auto bad = [&]() {
    return UsageError("input '" + input + "': '" + entry +
                      "' is no face number and no range such as 5-9");
  };
  const char* const end = entry.data() + entry.size();
  int first = 0;
  auto read = std::from_chars(entry.data(), end, first);
  if (read.ec != std::errc{} || first < 1) throw bad();
  int last = first;
  if (read.ptr != end) {
    if (*read.ptr != '-') throw bad();
    read = std::from_chars(read.ptr + 1, end, last);
    if (read.ec != std::errc{} || read.ptr != end || last < first) throw bad();
  }
  return {first, last};
}

// Of an entry that may be a piece of a name.
bool is_face_range(const std::string& entry) {
  return !entry.empty() && entry.find_first_not_of("0123456789-") == std::string::npos;
}

bool exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

// Of files that are in use.
std::shared_ptr<occt::Model> model_of(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::weak_ptr<occt::Model>> known;
  std::error_code missing;  // told by reading
  const std::filesystem::path canonical = std::filesystem::canonical(file, missing);
  if (missing) return std::make_shared<occt::Model>(read_and_report(file));
  if (std::shared_ptr<occt::Model> model = known[canonical].lock()) return model;
  auto model = std::make_shared<occt::Model>(read_and_report(file));
  known[canonical] = model;
  return model;
}

constexpr const char* kTakesEdges =
    "; 'intersect' of two models, 'trim --solid', 'query distance' and 'query plane' take edges";

// Each once, in increasing order.
std::vector<int> chosen_numbers(const InputName& name, const TopoDS_Shape& all, int count,
                                Faces need) {
  if (count == 0 && need == Faces::Required)
    throw occt::BadModel(name.file.string() + ": there is no face in it" +
                         (TopExp_Explorer(all, TopAbs_EDGE).More() ? kTakesEdges : ""));
  std::set<int> wanted;
  for (const auto& [first, last] : name.faces) {
    if (last > count)
      throw occt::BadModel(name.file.string() + ": there is no face " +
                           std::to_string(first > count ? first : last) + " in it, it has " +
                           counted(static_cast<std::size_t>(count), "face"));
    for (int number = first; number <= last; ++number) wanted.insert(number);
  }
  if (name.is_whole())
    for (int number = 1; number <= count; ++number) wanted.insert(number);
  return {wanted.begin(), wanted.end()};
}

// A name has letters; what has none is meant as numbers.
bool is_name(const std::string& entry) {
  return std::ranges::any_of(entry, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalpha(byte) != 0;
  });
}

// The same, with names that have commas as one.
InputName with_whole_names(InputName name, const std::string& text, const occt::Model& model) {
  name.faces.clear();
  name.words.clear();
  for (const std::string& word : reports::words_in(model, name.list))
    if (is_name(word))
      name.words.push_back(word);
    else
      name.faces.push_back(face_range(word, text));
  return name;
}

// What words name, beside the faces that numbers do.
void select(const InputName& name, Faces need, Input& input) {
  const reports::Selection selection = reports::selection_of(input.model, name.words);
  reports::choose(selection, input);
  if (need == Faces::Required && !input.edges.empty())
    throw UsageError("input '" + input.name + "': an edge is named where faces are wanted" +
                     kTakesEdges);
}

// A limit of 0 leaves faces loose, and so does what Open CASCADE fails on, or breaks down on:
// commands can use them.
void sew(const std::filesystem::path& file, occt::Sewable which, occt::Model& model, Input& input) {
  const std::optional<double>& within = reading_policy().sew;
  if (within == 0) return;
  const bool first = !model.is_sewn();
  const bool done = watched_checks(file)("sewing the loose faces", [&] {
    input.sewing = model.sew(within, stop_if_interrupted, which);
  });
  if (!done) input.sewing.failed = "Open CASCADE's sewing of them crashes or never ends";
  if (!first) return;
  for (const std::string& line : reports::words_of(input.sewing, "--sew-gap"))
    note(file.string() + ": " + line);
}

void tell(const occt::Repairs& repairs, const std::filesystem::path& file) {
  if (repairs.empty()) return;
  note(file.string() + ": " + reports::summary_of(repairs));
  for (const std::string& line : reports::details_of(repairs)) detail("  " + line);
}

// what   the faces have
void note_left_out(const std::string& file, const std::vector<int>& faces,
                   const std::string& what) {
  if (faces.empty()) return;
  std::vector<std::string> numbers;
  for (const int face : faces) numbers.push_back(std::to_string(face));
  const bool one = faces.size() == 1;
  note(file + (one ? ": face " : ": faces ") + reports::listed(numbers, "and") +
       (one ? " has " : " have ") + what + (one ? " and is" : " and are") + " left out");
}

}  // namespace

InputName parse_input(const std::string& text) {
  if (text.empty()) throw UsageError("the name of an input is empty");
  if (text == "-") throw UsageError("inputs are files; nothing is read from stdin");
  const std::size_t mark = selection_mark(text);
  if (mark == std::string::npos || exists(text)) return {text, {}, {}};

  InputName name{text.substr(0, mark), {}, {}, text.substr(mark + 1)};
  const bool named = is_name(name.list);
  for (std::size_t begin = 0, comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = name.list.find(',', begin);
    const std::string entry = name.list.substr(begin, comma - begin);
    if (is_name(entry) || (named && !is_face_range(entry)))
      name.words.push_back(entry);
    else
      name.faces.push_back(face_range(entry, text));
  }
  return name;
}

void refuse_special(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status) ||
      std::filesystem::is_directory(status))
    return;
  throw UsageError(file.string() + ": is a " +
                   (std::filesystem::is_fifo(status) ? "pipe" : "device") +
                   ", only regular files are read and written");
}

Input read_input(const std::string& text, Faces need, reports::Repairing repair,
                 reports::LooseFaces loose) {
  InputName name = parse_input(text);
  if (nets::is_net_file(name.file) && cli::exists(name.file))
    throw occt::BadModel(name.file.string() +
                         ": is of nets (.json), which only subdivide and convert take; "
                         "`blossom convert` makes a model of them");
  if (meshes::is_mesh_file(name.file) && cli::exists(name.file))
    throw occt::BadModel(
        name.file.string() +
        ": is of triangles, which only info, check, intersect, query plane, query distance, "
        "blend fill and convert take");
  const bool is_written_only =
      (meshes::is_written_mesh_file(name.file) || meshes::is_glb_file(name.file)) &&
      !meshes::is_mesh_file(name.file);
  if (is_written_only && cli::exists(name.file))
    throw occt::BadModel(name.file.string() +
                         ": .3mf and .glb are written only; triangles are read from .stl, .ply, "
                         ".obj and .off");
  const std::shared_ptr<occt::Model> model = model_of(name.file);
  Input input{text, model, *model};
  if (loose == reports::LooseFaces::Sewn || !name.words.empty() || reading_policy().sew)
    sew(name.file, occt::Sewable::All, *model, input);
  else if (loose == reports::LooseFaces::OpenSewn)
    sew(name.file, occt::Sewable::Open, *model, input);
  if (!name.words.empty()) name = with_whole_names(std::move(name), text, *model);
  input.shape = model->shape();
  input.numbers = chosen_numbers(name, input.shape, model->face_count(), need);
  if (!name.words.empty()) select(name, need, input);
  for (const int number : input.numbers) input.faces.push_back(model->face(number));
  if (repair == reports::Repairing::None) return input;
  enter(Phase::Working, "repairing " + name.file.string());
  input.repairs = name.is_whole() ? model->repair(stop_if_interrupted)
                                  : model->repair(input.numbers, stop_if_interrupted);
  tell(input.repairs, name.file);
  return input;
}

Input read_usable_input(const std::string& text, Faces need, reports::Repairing repair,
                        reports::LooseFaces loose) {
  Input input = read_input(text, need, repair, loose);
  const auto [open, lines] = reports::drop_unusable_faces(input);
  note_left_out(text, open, "lost a border");
  note_left_out(text, lines, "no width");
  if (!open.empty() || !lines.empty()) leave_faces_out();
  return input;
}

std::string other_parts_text(const Input& input, OtherParts fate, const std::set<int>& tools) {
  std::set<int> named(input.numbers.begin(), input.numbers.end());
  named.insert(tools.begin(), tools.end());
  std::size_t others = 0;
  const auto look = [&](const occt::AssemblyNode& node, const auto& self) -> void {
    if (!node.faces.empty() &&
        std::ranges::none_of(node.faces, [&](int face) { return named.contains(face); }))
      ++others;
    for (const occt::AssemblyNode& part : node.parts) self(part, self);
  };
  for (const occt::AssemblyNode& root : input.model.assembly()) look(root, look);
  if (others == 0) return {};
  const bool one = others == 1;
  return "  " + counted(others, "other part") + (one ? " is " : " are ") +
         (fate == OtherParts::LeftOut ? "left out"
          : one                       ? "written as it was"
                                      : "written as they were") +
         "\n";
}

}  // namespace blossom::cli
