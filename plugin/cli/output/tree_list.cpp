// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/tree_list.h"

#include <cstddef>
#include <vector>

#include "plugin/reports/models/input.h"

namespace blossom::cli {
namespace {

using occt::AssemblyNode;
using reports::given_name;

// "solids 2-4, 7"; numbers increase.
std::string numbers_text(const std::string& noun, const std::vector<int>& numbers) {
  if (numbers.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return noun + (numbers.size() == 1 ? " " : "s ") + text;
}

Json node_json(const AssemblyNode& node) {
  Json json = {{"name", given_name(node.name)}, {"product", given_name(node.product)},
               {"path", given_name(node.path)}, {"solids", node.solids},
               {"faces", node.faces},           {"parts", Json::array()}};
  for (const AssemblyNode& part : node.parts) json["parts"].push_back(node_json(part));
  return json;
}

void add_lines(const AssemblyNode& node, std::size_t depth, std::string& text) {
  const std::string name = given_name(node.name), product = given_name(node.product);
  std::string line = name.empty() ? "(no name)" : name;
  if (!product.empty() && product != name) line += " (" + product + ")";
  std::string holds = numbers_text("solid", node.solids);
  if (const std::string faces = numbers_text("face", node.faces); !faces.empty())
    holds += (holds.empty() ? "" : ", ") + faces;
  text += std::string(2 * depth + 2, ' ') + line + (holds.empty() ? "" : ": " + holds) + "\n";
  for (const AssemblyNode& part : node.parts) add_lines(part, depth + 1, text);
}

}  // namespace

TreeList tree_list(const occt::Model& model) {
  TreeList list{Json::array(), "  assembly\n"};
  for (const AssemblyNode& node : model.assembly()) {
    list.json.push_back(node_json(node));
    add_lines(node, 1, list.text);
  }
  return list;
}

}  // namespace blossom::cli
