// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP, IGES and BREP files.

#include <string>
#include <unordered_map>
#include <utility>

#include <TopoDS_Iterator.hxx>
#include <TopoDS_TShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/listening.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/kept_folder.h"
#include "adapters/occt/exchange/model_files.h"
#include "adapters/occt/exchange/modules.h"
#include "adapters/occt/exchange/numbers.h"
#include "adapters/occt/exchange/places.h"

namespace blossom::occt {
namespace {

constexpr int kDeepestShape = 1000;  // compounds in each other, of which real models have some tens

/// False for compounds of nothing but compounds, and for solids whose shells have no faces. A face
/// without a border is all of its surface.
bool holds_shapes(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_VERTEX || shape.ShapeType() == TopAbs_FACE) return true;
  for (TopoDS_Iterator it(shape, false, false); it.More(); it.Next())
    if (holds_shapes(it.Value())) return true;
  return false;
}

bool is_empty(const TopoDS_Shape& shape) { return shape.IsNull() || !holds_shapes(shape); }

/// Open CASCADE takes time by the square of the depth, and a thread's stack has an end.
///
/// seen   the deepest level at which a shape was looked into
void require_shallow(const TopoDS_Shape& shape, int level,
                     std::unordered_map<const TopoDS_TShape*, int>& seen) {
  if (shape.IsNull() || shape.ShapeType() > TopAbs_SOLID) return;
  if (level > kDeepestShape)
    throw BadModel("shapes in it are nested more than " + std::to_string(kDeepestShape) + " deep");
  int& deepest = seen[shape.TShape().get()];
  if (deepest >= level) return;
  deepest = level;
  for (TopoDS_Iterator it(shape, false, false); it.More(); it.Next())
    require_shallow(it.Value(), level + 1, seen);
}

void require_shape(const TopoDS_Shape& shape, const ReadingReport& report) {
  if (is_empty(shape)) refuse("holds no shape", report);
}

/// A document takes over where plain parts are not enough.
void read_step_file(Reading& reading, ModelFiles& files) {
  const Handle(Standard_Transient) session = step_module().read(reading);
  if (session.IsNull()) return;
  files.read_others(reading);
  document_module().add_step(session, reading);
}

void leave_out_bad_numbers(Format format, Reading& reading) {
  std::unordered_map<const TopoDS_TShape*, int> seen;
  for (PlainPart& part : reading.contents.parts) {
    require_shallow(part.shape, 1, seen);
    if (format == Format::Brep) part.shape = with_moving_places(part.shape, reading.report);
  }
  const NumberSource source(format == Format::Brep ? &reading.text : nullptr);
  if (reading.contents.document)
    reading.contents.document->leave_out_bad_faces(source, reading.report);
  else
    leave_out_bad_shapes(reading.contents.parts, source, reading.report);
}

void read_format(Format format, Reading& reading, ModelFiles& files) {
  const Listening listening;
  switch (format) {
    case Format::Step: return read_step_file(reading, files);
    case Format::Iges: return document_module().read_iges(reading);
    case Format::Brep: return read_brep(reading);
    case Format::Glb: break;  // no content is taken for it
  }
}

/// A model that is kept was read like this before.
void read_into(Reading& reading, StatedTolerances& stated, ModelFiles& files) {
  reading.begin("opening");
  FileText content = file_text(reading.file);
  reading.text = std::move(content.text);
  const KeptModel kept(reading);
  if (!content.cut && kept.take(reading, stated)) return;
  if (content.cut) reading.report.add({"the packed file", "it is damaged or cut off", true});
  for (const std::string& other : content.others)
    reading.report.add(
        {"model", "of an archive the first one alone is read, " + content.name, true, 1, {other}});
  read_format(content.format, reading, files);
  reading.begin("checking the numbers");
  leave_out_bad_numbers(content.format, reading);
  reading.contents.refresh();
  require_shape(reading.contents.shape, reading.report);
  // Only BREP files state tolerances; others have those that Open CASCADE's readers find.
  if (content.format != Format::Brep) stated = StatedTolerances::Raised;
  if (!content.cut && !reading.names_files) kept.keep(reading, stated);
}

}  // namespace

Model ModelFiles::read(const std::filesystem::path& file, const ReadOptions& options) {
  const std::lock_guard guard(exchange_lock());
  Model model;
  Model::Impl& impl = *model.impl_;
  Reading reading{impl, file, options, impl.reading};
  try {
    read_into(reading, impl.stated, *this);
  } catch (const BadModel& error) {
    throw BadModel(file.string() + ": " + error.what());
  } catch (const Failure&) {
    throw;
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    if (reading.asking) throw;
    throw BadModel(file.string() + ": " + reading.step + " fails: " + current_failure_text());
  }
  impl.file = file;
  return model;
}

Model read_model(const std::filesystem::path& file, const ReadOptions& options) {
  return ModelFiles().read(file, options);
}

}  // namespace blossom::occt
