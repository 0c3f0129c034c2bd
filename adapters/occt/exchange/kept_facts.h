// SPDX-License-Identifier: LGPL-2.1-or-later
// What a model answers beside its shape, as values and as bytes. For this folder only.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/reading.h"

namespace blossom::occt {

struct KeptFacts {
  std::string unit;     ///< see Contents
  bool raised = false;  ///< whether tolerances are StatedTolerances::Raised
  ReadingReport reading;
  std::vector<std::string> names;      ///< of faces, by number - 1
  std::vector<std::string> paths;      ///< likewise, of their parts
  std::vector<std::string> parts;      ///< likewise, the parts' own names
  std::vector<AssemblyNode> assembly;  ///< as Model has it
};

std::string bytes_of(const KeptFacts& facts);

/// throws   std::ios_base::failure if these are not what `bytes_of` made
KeptFacts facts_of(const std::string& bytes);

/// A shape with the answers that it had. It cannot be changed or written.
std::shared_ptr<DocumentInterface> kept_document(const TopoDS_Shape& shape, KeptFacts facts);

}  // namespace blossom::occt
