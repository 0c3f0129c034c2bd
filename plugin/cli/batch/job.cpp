// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/job.h"

#include <filesystem>
#include <functional>
#include <utility>

#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/reports/text/nesting.h"

namespace blossom::cli {
namespace {

constexpr const char* kBatch = "batch";

// Where it does not say what it means to say.
[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw UsageError(place + ": " + what);
}

Json parsed(const std::string& line, const std::string& place) {
  if (line.size() > kMaxJobLine)
    refuse(place, "the line has more than " + std::to_string(kMaxJobLine) + " bytes");
  if (!reports::is_nested_soundly(line))
    refuse(place,
           "lists in it are nested more than " + std::to_string(reports::kMaxNesting) + " deep");
  Json json = Json::parse(line, nullptr, false);
  constexpr const char* kExample = R"({"id": "name", "arguments": ["info", "a.step"]})";
  if (json.is_discarded()) refuse(place, std::string("is no JSON, as a job is: ") + kExample);
  if (!json.is_object()) refuse(place, std::string("is no job: ") + kExample);
  for (const auto& [name, value] : json.items())
    if (name != "id" && name != "arguments")
      refuse(place, "'" + name + "' is no member of a job; it has \"id\" and \"arguments\"");
  return json;
}

std::string id_of(const Json& json, const std::string& place) {
  if (!json.contains("id")) refuse(place, "the job has no \"id\"");
  const Json& id = json["id"];
  if (!id.is_string() || id.get_ref<const std::string&>().empty())
    refuse(place, "the job's \"id\" is no text, or an empty one");
  if (id.get_ref<const std::string&>().size() > kMaxJobId)
    refuse(place, "the job's \"id\" has more than " + std::to_string(kMaxJobId) + " bytes");
  return id;
}

std::vector<std::string> arguments_of(const Json& json, const std::string& place) {
  if (!json.contains("arguments") || !json["arguments"].is_array() || json["arguments"].empty())
    refuse(place, R"(the job has no "arguments", a list such as ["info", "a.step"])");
  std::vector<std::string> words;
  for (const Json& word : json["arguments"]) {
    if (!word.is_string()) refuse(place, "an argument is " + word.dump() + ", which is no text");
    words.push_back(word);
    if (words.back().find('\0') != std::string::npos)
      refuse(place, "an argument has a zero byte in it");
  }
  check_command(words, place);
  return words;
}

}  // namespace

void check_command(const std::vector<std::string>& arguments, const std::string& place) {
  if (arguments.size() > kMaxJobArguments)
    refuse(place, "the job has more than " + std::to_string(kMaxJobArguments) + " arguments");
  if (arguments.front() == kBatch) refuse(place, "a job cannot be a batch");
}

Job parse_job(const std::string& line, const std::string& place) {
  const Json json = parsed(line, place);
  return {id_of(json, place), arguments_of(json, place)};
}

std::string filled_in(const std::string& argument, const std::string& file) {
  const std::filesystem::path path = file;
  const std::pair<const char*, std::string> marks[] = {{"{}", file},
                                                       {"{.}", path.parent_path() / path.stem()},
                                                       {"{/}", path.filename()},
                                                       {"{/.}", path.stem()}};
  std::string text;
  for (std::size_t at = 0; at < argument.size();) {
    std::size_t length = 1;
    std::string part = argument.substr(at, 1);
    for (const auto& [mark, value] : marks)
      if (argument.compare(at, std::string(mark).size(), mark) == 0) {
        length = std::string(mark).size();
        part = value;
      }
    text += part;
    at += length;
  }
  return text;
}

std::size_t hash_of(const std::vector<std::string>& arguments) {
  std::string all;
  for (const std::string& word : arguments) all += word + '\0';
  return std::hash<std::string>{}(all);
}

}  // namespace blossom::cli
