// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/model_files.h"

#include <algorithm>
#include <string>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {
namespace {

// Assemblies of real products are some ten deep, and each level has a session of Open CASCADE.
constexpr std::size_t kDeepestFile = 50;

// More than the largest machines have different parts that are exchanged so.
constexpr std::size_t kMostFiles = 100'000;

void list_other(Reading& reading, const std::filesystem::path& file, const std::string& cause) {
  reading.report.add({"part", cause, true, 1, {file.filename().string()}});
}

/// Numbers of entities are those of the other file.
void list_losses_of(const ReadingReport& other, const std::string& name, ReadingReport& report) {
  for (const std::string& note : other.notes) report.notes.push_back(name + ": " + note);
  for (Loss loss : other.losses) {
    if (loss.belongs_to.empty()) loss.belongs_to.push_back("'" + name + "'");
    report.add(loss);
  }
}

/// What is wrong with a file, without its name.
std::string words_of(const BadModel& error, const std::filesystem::path& file) {
  const std::string words = error.what(), name = file.string() + ": ";
  return words.starts_with(name) ? words.substr(name.size()) : words;
}

}  // namespace

std::shared_ptr<Model> ModelFiles::other(Reading& reading, const std::filesystem::path& file) {
  reading.asking = true;  // what the caller throws there ends all
  ReadOptions options = reading.options.other ? reading.options.other(file) : reading.options;
  if (!options.other) options.other = reading.options.other;
  if (options.left_out) throw BadModel("cannot be read: Open CASCADE crashes, or never ends");
  auto model = std::make_shared<Model>(read(file, options));
  reading.asking = false;
  document_of(contents_of(*model));
  list_losses_of(model->reading(), file.filename().string(), reading.report);
  for (const auto& [kind, count] : contents_of(*model).beside)
    reading.contents.beside[kind] += count;
  return model;
}

void ModelFiles::read_others(Reading& reading) {
  way_.push_back(std::filesystem::weakly_canonical(reading.file));
  for (OtherFile& other_file : reading.others) {
    const std::filesystem::path file = std::filesystem::weakly_canonical(other_file.file);
    if (std::ranges::find(way_, file) != way_.end())
      list_other(reading, file, "its file has it in itself: files name each other in a circle");
    else if (way_.size() > kDeepestFile || models_.size() >= kMostFiles)
      list_other(reading, file, "its file is not followed: too many files name each other");
    else if (const auto known = models_.find(file); known != models_.end())
      other_file.model = known->second;
    else
      try {
        other_file.model = models_[file] = other(reading, file);
      } catch (const BadModel& error) {
        reading.asking = false;
        list_other(reading, file, "its file " + words_of(error, file));
      }
  }
  way_.pop_back();
}

}  // namespace blossom::occt
