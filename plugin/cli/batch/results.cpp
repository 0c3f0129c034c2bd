// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/results.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

constexpr mode_t kMode = 0666;  // less what the user's mask takes
constexpr std::chrono::seconds kKeepEvery(1);

occt::Failure unwritable(const std::string& name) {
  return occt::Failure(name + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

ResultFile::ResultFile(const std::string& file, const std::function<void(const Result&)>& use)
    : name_(file), is_file_(file != "-") {
  if (!is_file_) {
    name_ = "stdout";
    descriptor_ = STDOUT_FILENO;
    return;
  }
  refuse_special(file);
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kMode);
  if (descriptor_ < 0) throw unwritable(name_);
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    throw UsageError(name_ + ": another batch is writing it");
  read(use);
}

ResultFile::~ResultFile() {
  if (is_file_ && descriptor_ >= 0) close(descriptor_);
}

void ResultFile::read(const std::function<void(const Result&)>& use) {
  std::ifstream in(name_, std::ios::binary);
  std::string line;
  off_t whole = 0;
  for (std::size_t number = 1; std::getline(in, line) && !in.eof(); ++number) {
    stop_if_interrupted();
    use(parse_result(line, name_ + ":" + std::to_string(number)));
    whole += static_cast<off_t>(line.size()) + 1;
  }
  if (ftruncate(descriptor_, whole) != 0) throw unwritable(name_);
}

void ResultFile::add(const std::string& line) {
  const std::string text = line + "\n";
  struct stat before {};
  if (is_file_ && fstat(descriptor_, &before) != 0) throw unwritable(name_);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(descriptor_, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const occt::Failure error = unwritable(name_);
      if (is_file_ && ftruncate(descriptor_, before.st_size) != 0) throw unwritable(name_);
      throw error;
    }
    done += static_cast<std::size_t>(written);
  }
  dirty_ = true;
  keep();
}

bool ResultFile::is_wanted() const {
  pollfd pipe{descriptor_, 0, 0};
  return is_file_ || poll(&pipe, 1, 0) <= 0 || (pipe.revents & POLLERR) == 0;
}

void ResultFile::keep(bool now) {
  if (!is_file_ || !dirty_ || (!now && Clock::now() < kept_ + kKeepEvery)) return;
  if (fdatasync(descriptor_) != 0) throw unwritable(name_);
  kept_ = Clock::now();
  dirty_ = false;
}

}  // namespace blossom::cli
