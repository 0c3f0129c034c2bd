// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/model_bytes.h"

#include <mutex>
#include <utility>
#include <vector>

#include "adapters/occt/exact/exact_bytes.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/modules.h"
#include "adapters/occt/exchange/value_bytes.h"

namespace blossom::occt {
namespace {

struct CountBeside {
  std::string kind;
  int count = 0;
};

struct PartNames {
  std::string part;
  std::vector<std::string> named;
};

/// A model without its file; `shapes` are of a document, or else of parts, each before those in it
/// that are named.
struct ModelValues {
  std::string unit;
  bool raised = false;
  ReadingReport reading;
  std::vector<CountBeside> beside;
  bool has_document = false;
  std::vector<PartNames> parts;
  std::string shapes;
};

template <class Way>
void each_member(Way& way, CountBeside& beside) {
  way(beside.kind), way(beside.count);
}

template <class Way>
void each_member(Way& way, PartNames& names) {
  way(names.part), way(names.named);
}

template <class Way>
void each_member(Way& way, ModelValues& model) {
  way(model.unit), way(model.raised), way(model.beside);
  each_member(way, model.reading);
  way(model.has_document), way(model.parts), way(model.shapes);
}

std::optional<std::string> bytes_of_parts(const PlainParts& parts, std::vector<PartNames>& names) {
  std::vector<TopoDS_Shape> shapes;
  for (const PlainPart& part : parts) {
    PartNames& own = names.emplace_back(PartNames{part.name, {}});
    shapes.push_back(part.shape);
    for (const NamedShape& named : part.named) {
      own.named.push_back(named.name);
      shapes.push_back(named.shape);
    }
  }
  for (const TopoDS_Shape& shape : shapes)
    if (shape.IsNull()) return std::nullopt;
  return exact_bytes(shapes);
}

PlainParts parts_of_bytes(const ModelValues& values) {
  const std::vector<TopoDS_Shape> shapes = shapes_of_exact_bytes(values.shapes);
  PlainParts parts;
  std::size_t next = 0;
  for (const PartNames& names : values.parts) {
    PlainPart& part = parts.emplace_back(PlainPart{shapes.at(next++), names.part});
    for (const std::string& name : names.named) part.named.push_back({shapes.at(next++), name});
  }
  return parts;
}

}  // namespace

std::optional<std::string> ModelBytes::of(const Model& model) {
  const Model::Impl& own = *model.impl_;
  ModelValues values;
  values.unit = own.unit;
  values.raised = own.stated == StatedTolerances::Raised;
  values.reading = own.reading;
  for (const auto& [kind, count] : own.beside) values.beside.push_back({kind, count});
  values.has_document = own.document != nullptr;
  std::optional<std::string> shapes =
      values.has_document ? document_bytes(*own.document) : bytes_of_parts(own.parts, values.parts);
  if (!shapes) return std::nullopt;
  values.shapes = std::move(*shapes);
  return value_bytes(std::move(values));
}

Model ModelBytes::model(const std::string& bytes, const std::filesystem::path& file) {
  const std::lock_guard guard(exchange_lock());
  const auto values = value_of<ModelValues>(bytes);
  Model model;
  Model::Impl& own = *model.impl_;
  own.unit = values.unit;
  own.stated = values.raised ? StatedTolerances::Raised : StatedTolerances::Kept;
  own.reading = values.reading;
  for (const CountBeside& each : values.beside) own.beside[each.kind] = each.count;
  if (values.has_document)
    own.document = document_of_bytes(values.shapes);
  else
    own.parts = parts_of_bytes(values);
  own.refresh();
  own.file = file;
  return model;
}

}  // namespace blossom::occt
