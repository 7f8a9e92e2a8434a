#include "io/files/file_watcher.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>

namespace fs = std::filesystem;

namespace {
using Paths = std::vector<fs::path>;

bool is_ready(const FileWatcher& watcher, int milliseconds) {
    pollfd poll_request{watcher.descriptor(), POLLIN, 0};
    return ::poll(&poll_request, 1, milliseconds) > 0;
}

// The files reported as changed within the given time, as seen by a loop that sleeps in poll.
Paths changed_within(FileWatcher& watcher, int milliseconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        if (left.count() <= 0 || !is_ready(watcher, static_cast<int>(left.count())))
            return {};
        if (Paths changed = watcher.take_changed(); !changed.empty())
            return changed;
    }
}

constexpr int soon = 2000;
constexpr int a_while = 350;

FileWatcher watcher_of(const Paths& files) {
    auto watcher = FileWatcher::start();
    REQUIRE(watcher.has_value());
    REQUIRE(watcher->watch(files));
    CHECK(watcher->take_changed().empty());
    return std::move(*watcher);
}
}  // namespace

TEST_CASE("a save in place is reported once, and other files in the folder are not") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.frag", "one");
    FileWatcher watcher = watcher_of({file});
    CHECK_FALSE(is_ready(watcher, 20));
    folder.write("b.frag", "other");
    folder.write("a.frag", "two");
    CHECK(changed_within(watcher, soon) == Paths{file});
    CHECK(changed_within(watcher, 50).empty());
}

TEST_CASE("a file is not reported while it is being written") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.frag", "one");
    FileWatcher watcher = watcher_of({file});
    Descriptor open_file(::open(file.c_str(), O_WRONLY | O_TRUNC));
    REQUIRE(::write(open_file.get(), "half", 4) == 4);
    CHECK(changed_within(watcher, 50).empty());
    REQUIRE(open_file.close());
    CHECK(changed_within(watcher, soon) == Paths{file});
}

TEST_CASE("saves by rename, as by vim and emacs, are reported once as a change") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.frag", "one");
    FileWatcher watcher = watcher_of({file});
    fs::rename(folder.write("4913~", "two"), file);
    CHECK(changed_within(watcher, soon) == Paths{file});

    fs::rename(file, folder / "a.frag~");
    CHECK(watcher.take_changed().empty());
    Descriptor open_file(::open(file.c_str(), O_WRONLY | O_CREAT, 0644));
    CHECK(changed_within(watcher, a_while).empty());
    REQUIRE(open_file.close());
    CHECK(changed_within(watcher, soon) == Paths{file});
    CHECK(changed_within(watcher, a_while).empty());
}

TEST_CASE("two saves within 100 ms are both reported") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.frag", "one");
    FileWatcher watcher = watcher_of({file});
    for (int save = 0; save < 2; ++save) {
        folder.write("a.frag", "the same size");
        CHECK(changed_within(watcher, soon) == Paths{file});
    }
}

TEST_CASE("a deleted file is reported after a short delay") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.frag", "one");
    FileWatcher watcher = watcher_of({file});
    fs::remove(file);
    CHECK(watcher.take_changed().empty());
    CHECK(changed_within(watcher, soon) == Paths{file});
    CHECK(changed_within(watcher, a_while).empty());
}

TEST_CASE("a missing file in missing folders is reported when it appears") {
    const TemporaryFolder folder;
    const fs::path file = folder / "shaders/include/a.glsl";
    FileWatcher watcher = watcher_of({file});
    fs::create_directory(folder / "shaders");
    CHECK(changed_within(watcher, 50).empty());
    fs::create_directory(folder / "shaders/include");
    CHECK(changed_within(watcher, 50).empty());
    folder.write("shaders/include/a.glsl", "one");
    CHECK(changed_within(watcher, soon) == Paths{file});
    folder.write("shaders/include/a.glsl", "two");
    CHECK(changed_within(watcher, soon) == Paths{file});

    const fs::path at_once = folder / "p/q/r/file";
    REQUIRE(watcher.watch({at_once}));
    folder.write("p/q/r/file", "one");
    CHECK(changed_within(watcher, soon) == Paths{at_once});
}

TEST_CASE("a renamed folder and its replacement are reported") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("look/a.frag", "one");
    folder.write("other/a.frag", "another");
    FileWatcher watcher = watcher_of({file});
    fs::rename(folder / "look", folder / "old");
    fs::rename(folder / "other", folder / "look");
    CHECK(changed_within(watcher, soon) == Paths{file});
    folder.write("old/a.frag", "nobody asks for this");
    CHECK(changed_within(watcher, 50).empty());
    fs::remove_all(folder / "look");
    CHECK(changed_within(watcher, soon) == Paths{file});
    folder.write("look/a.frag", "again");
    CHECK(changed_within(watcher, soon) == Paths{file});
}

TEST_CASE("a symbolic link is reported when its target is saved or the link changes") {
    const TemporaryFolder folder;
    folder.write("there/one", "1");
    folder.write("there/two", "2");
    const fs::path link = folder / "link";
    fs::create_symlink("there/one", link);
    FileWatcher watcher = watcher_of({link});
    folder.write("there/one", "1b");
    CHECK(changed_within(watcher, soon) == Paths{link});
    fs::create_symlink("there/two", folder / "new");
    fs::rename(folder / "new", link);
    CHECK(changed_within(watcher, soon) == Paths{link});
    folder.write("there/two", "2b");
    CHECK(changed_within(watcher, soon) == Paths{link});
    folder.write("there/one", "1c");
    CHECK(changed_within(watcher, 50).empty());
}

TEST_CASE("a new hard link to a complete file is reported at once") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.frag";
    FileWatcher watcher = watcher_of({file});
    fs::create_hard_link(folder.write("b.frag", "one"), file);
    CHECK(changed_within(watcher, soon) == Paths{file});
}

TEST_CASE("changing the watch list keeps pending changes of files that stay") {
    const TemporaryFolder folder;
    const fs::path a = folder.write("a", "1");
    const fs::path b = folder.write("b", "1");
    const fs::path c = folder.write("c", "1");
    FileWatcher watcher = watcher_of({a, b});
    folder.write("a", "2");
    folder.write("b", "2");
    REQUIRE(watcher.watch({b, c}));
    CHECK(changed_within(watcher, soon) == Paths{b});
    folder.write("a", "3");
    CHECK(changed_within(watcher, 50).empty());
    folder.write("c", "2");
    CHECK(changed_within(watcher, soon) == Paths{c});
    REQUIRE(watcher.watch({}));
    folder.write("c", "3");
    CHECK(changed_within(watcher, 50).empty());
}

TEST_CASE("after an event queue overflow, every file is reported") {
    const TemporaryFolder folder;
    const fs::path a = folder.write("a", "1");
    const fs::path b = folder.write("b", "1");
    FileWatcher watcher = watcher_of({a, b});
    // The kernel merges equal consecutive events, so two names alternate.
    std::size_t max_events = 16384;
    std::ifstream("/proc/sys/fs/inotify/max_queued_events") >> max_events;
    if (max_events > 200000)
        return;
    for (std::size_t i = 0; i < max_events / 2 + 64; ++i)
        for (const char* name : {"x", "y"}) {
            const Descriptor file(::open((folder / name).c_str(), O_WRONLY | O_CREAT, 0600));
            REQUIRE(file.is_open());
        }
    CHECK(changed_within(watcher, soon) == Paths{a, b});
    folder.write("a", "2");
    CHECK(changed_within(watcher, soon) == Paths{a});
}

TEST_CASE("running out of file descriptors gives an error") {
    rlimit maximum = {};
    REQUIRE(::getrlimit(RLIMIT_NOFILE, &maximum) == 0);
    const rlimit none{0, maximum.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
    const auto watcher = FileWatcher::start();
    REQUIRE(::setrlimit(RLIMIT_NOFILE, &maximum) == 0);
    REQUIRE_FALSE(watcher.has_value());
    CHECK(watcher.error().front().message.find(
              "can't watch files for changes: Too many open files") != std::string::npos);
}

TEST_CASE("impossible paths are harmless") {
    const TemporaryFolder folder;
    folder.write("file", "");
    fs::create_symlink("circle", folder / "circle");
    auto watcher = FileWatcher::start();
    REQUIRE(watcher.has_value());
    CHECK(watcher->watch({folder / "file/inside", "", "relative/none"}).has_value());
    const auto watched = watcher->watch({folder / "circle", "/proc/1/none/file"});
    CHECK((watched.has_value() || watched.error().front().line == 0));
    CHECK(watcher->take_changed().empty());
}
