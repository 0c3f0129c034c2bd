// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether a folder takes files is tried by a file without a name: one with a name would stay there
// if the program were killed just then.

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;

// Names that appear in a folder while it lives.
class Appearing {
 public:
  explicit Appearing(const std::string& folder) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    inotify_add_watch(queue_, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  }
  ~Appearing() { close(queue_); }
  Appearing(const Appearing&) = delete;
  Appearing& operator=(const Appearing&) = delete;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    alignas(inotify_event) std::array<char, 4096> bytes{};
    for (ssize_t got = 0; (got = read(queue_, bytes.data(), bytes.size())) > 0;)
      for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
        inotify_event event{};
        std::memcpy(&event, bytes.data() + at, sizeof(event));
        all.emplace_back(bytes.data() + at + sizeof(event));
        at += sizeof(event) + event.len;
      }
    return all;
  }

 private:
  int queue_;
};

TEST(Probes, OfFoldersHaveNoNames) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "bowl.brep");
  const Appearing appearing(folder / "");
  ASSERT_EQ(blossom({"info", folder / "bowl.brep", "-q", "--json", folder / "report.json"}).code,
            0);
  const std::vector<std::string> names = appearing.names();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.back(), "report.json");
  for (const std::string& name : names)
    EXPECT_NE(name.find("report.json"), std::string::npos) << name;
}

}  // namespace
}  // namespace blossom
