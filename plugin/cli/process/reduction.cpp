// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/reduction.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <regex>
#include <sstream>
#include <utility>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/bodies.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/nets/net_json.h"

namespace blossom::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Bodies = std::vector<std::vector<int>>;  // numbers of their faces

// A file without a name that children write to; nothing if there can be none.
class Scratch {
 public:
  Scratch() : file_(memfd_create("blossom", MFD_CLOEXEC)) {}
  ~Scratch() {
    if (file_ >= 0) close(file_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  int file() const { return file_; }

  std::string text() const {
    struct stat facts {};
    if (file_ < 0 || fstat(file_, &facts) != 0) return {};
    std::string text(static_cast<std::size_t>(facts.st_size), '\0');
    const ssize_t length = pread(file_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
    return text;
  }

 private:
  int file_;
};

// While it lives, nothing comes to stdout, and what comes to stderr goes to a file.
class Silence {
 public:
  explicit Silence(int said) : out_(dup(STDOUT_FILENO)), err_(dup(STDERR_FILENO)) {
    std::cout.flush();
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nothing, STDOUT_FILENO);
    dup2(said >= 0 ? said : nothing, STDERR_FILENO);
    close(nothing);
  }
  ~Silence() {
    dup2(out_, STDOUT_FILENO);
    dup2(err_, STDERR_FILENO);
    close(out_);
    close(err_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int out_, err_;
};

// While it lives, supervised work ends by then.
class LimitedTime {
 public:
  explicit LimitedTime(Clock::time_point until) : before_(greatest_time_limit()) {
    const double left = std::chrono::duration<double>(until - Clock::now()).count();
    set_greatest_time_limit(before_ > 0 ? std::min(before_, left) : left);
  }
  ~LimitedTime() { set_greatest_time_limit(before_); }
  LimitedTime(const LimitedTime&) = delete;
  LimitedTime& operator=(const LimitedTime&) = delete;

 private:
  double before_;
};

Bodies bodies_of_model(const occt::Model& model) {
  TopTools_IndexedMapOfShape numbers, faces;
  TopExp::MapShapes(model.shape(), TopAbs_FACE, numbers);
  Bodies bodies;
  for (const occt::Body& body : occt::bodies_of(model.shape())) {
    faces.Clear();
    TopExp::MapShapes(body.shape, TopAbs_FACE, faces);
    std::vector<int>& all = bodies.emplace_back();
    for (int i = 1; i <= faces.Extent(); ++i) all.push_back(numbers.FindIndex(faces(i)));
  }
  return bodies;
}

// By a process that may crash; none if it does, or the file is no model.
Bodies bodies_in(const std::filesystem::path& file) {
  const Scratch scratch;
  const Silence silence(-1);
  supervised([&] {
    try {
      std::string lines;
      for (const std::vector<int>& body : bodies_of_model(read_and_report(file))) {
        for (const int face : body) lines += std::to_string(face) + " ";
        lines += "\n";
      }
      return write(scratch.file(), lines.data(), lines.size()) < 0 ? 1 : 0;
    } catch (const std::exception&) {  // a law or planes, say, or triangles
      return 1;
    }
  });
  Bodies bodies;
  std::istringstream in(scratch.text());
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::vector<int>& body = bodies.emplace_back();
    for (int face = 0; words >> face;) body.push_back(face);
  }
  return bodies;
}

// What of them is selected.
Bodies chosen(const InputName& name) {
  Bodies bodies = bodies_in(name.file);
  const auto is_out = [&](int face) {
    return !name.faces.empty() && std::ranges::none_of(name.faces, [&](const auto& range) {
      return range.first <= face && face <= range.second;
    });
  };
  for (std::vector<int>& body : bodies) std::erase_if(body, is_out);
  std::erase_if(bodies, [](const std::vector<int>& body) { return body.empty(); });
  return bodies;
}

// Each once, as bodies may share faces.
std::vector<int> all_of(const Bodies& bodies) {
  std::vector<int> faces;
  for (const std::vector<int>& body : bodies) faces.insert(faces.end(), body.begin(), body.end());
  std::ranges::sort(faces);
  faces.erase(std::ranges::unique(faces).begin(), faces.end());
  return faces;
}

Bodies one_by_one(const std::vector<int>& faces) {
  Bodies units;
  for (const int face : faces) units.push_back({face});
  return units;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  if (from.empty()) return;
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

Ended ended_by(std::vector<std::string> words, const Program& program) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int code =
      supervised([&] { return program(static_cast<int>(words.size()), arguments.data()); });
  return {code, last_ending()};
}

std::string Part::word() const {
  std::string text = file.string();
  if (!only_faces) return text + selection;
  for (std::size_t i = 0; i < faces.size(); ++i)
    text += (i == 0 ? "#" : ",") + std::to_string(faces[i]);
  return text;
}

bool is_output(const std::string& word) {
  for (const char* option : {"-o", "--output", "--json", "--picture", "--html", "--glb", "--table",
                             "--log", "--reproduce"})
    if (word == option) return true;
  return false;
}

std::vector<Part> parts_of(const std::vector<std::string>& words) {
  std::vector<Part> parts;
  for (std::size_t i = 2; i < words.size(); ++i) try {
      if (is_output(words[i - 1])) continue;
      const InputName name = parse_input(words[i]);
      if (!std::filesystem::is_regular_file(name.file)) continue;
      Part part{i, name.file, words[i].substr(name.file.string().size())};
      if (!nets::is_net_file(name.file)) part.bodies = chosen(name);
      part.faces = all_of(part.bodies);
      parts.push_back(std::move(part));
    } catch (const UsageError&) {  // no input
    }
  return parts;
}

std::string cause_of(const std::string& said, const std::vector<Part>& parts) {
  static const std::string kStart = "blossom: ";
  static const std::regex number("[-+]?[0-9]+(\\.[0-9]*)?(e[-+]?[0-9]+)?"),
      list("0((, | and |,)0)+");
  std::istringstream in(said);
  std::string cause;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kStart)) cause = line;
  for (const Part& part : parts) {
    const std::string word = part.word(), file = part.file.string();
    const std::string selected = word.substr(file.size()), name = part.file.filename().string();
    for (const std::string& text : {word, file, name + selected, name})
      replace_all(cause, text, "input");
  }
  return std::regex_replace(std::regex_replace(cause, number, "0"), list, "0");
}

End silent_end(std::vector<std::string> words, const Program& program,
               const std::vector<Part>& parts) {
  const Scratch said;
  const auto run = [&] {
    const Silence silence(said.file());
    return ended_by(std::move(words), program);
  };
  const Ended ended = run();
  return {ended.code, ended.how.crashed, cause_of(said.text(), parts)};
}

Reduction::Reduction(std::vector<std::string> words, const Program& program,
                     Clock::time_point until)
    : words_(std::move(words)), program_(program), until_(until) {}

End Reduction::end_with(const std::vector<Part>& parts) const {
  std::vector<std::string> words = words_;
  for (const Part& part : parts) words[part.place] = part.word();
  return silent_end(std::move(words), program_, parts);
}

bool Reduction::repeats(const std::vector<Part>& parts) const {
  if (Clock::now() >= until_) return false;
  const LimitedTime limited(until_);
  return end_with(parts) == wanted_ && Clock::now() < until_;
}

// Leaves out runs of units, the longest first; something stays.
bool Reduction::reduced(std::vector<Part>& parts, std::size_t number, Bodies units) const {
  const Part before = parts[number];
  const std::size_t all = units.size();
  for (std::size_t run = (all + 1) / 2; run > 0; run = run > 1 ? (run + 1) / 2 : 0)
    for (std::size_t first = 0; first < units.size() && units.size() > run;) {
      Bodies rest = units;
      const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(first);
      rest.erase(begin, rest.end() - begin > static_cast<std::ptrdiff_t>(run)
                            ? begin + static_cast<std::ptrdiff_t>(run)
                            : rest.end());
      parts[number].only_faces = true;
      parts[number].faces = all_of(rest);
      if (repeats(parts))
        units = std::move(rest);
      else
        first += run;
    }
  parts[number] = before;
  if (units.size() == all) return false;
  parts[number].only_faces = true;
  parts[number].faces = all_of(units);
  return true;
}

void Reduction::reduce(std::vector<Part>& parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i) reduced(parts, i, parts[i].bodies);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      smaller = reduced(parts, i, one_by_one(parts[i].faces)) || smaller;
  }
}

}  // namespace blossom::cli
