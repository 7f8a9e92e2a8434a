#include "io/files/atomic_file.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <csignal>
#include <random>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
bool fails_to_flush_folders = false;
std::size_t count_of(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}
}  // namespace

// Replaces the C library's fsync, so that it can fail.
extern "C" int fsync(int file) {
    struct stat status = {};
    if (fails_to_flush_folders && ::fstat(file, &status) == 0 && S_ISDIR(status.st_mode)) {
        errno = EIO;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_fsync, file));
}

TEST_CASE("a new file is written with its parent folders, and no temporary file remains") {
    const TemporaryFolder folder;
    REQUIRE(write_atomically(folder / "a/b/file.txt", std::string_view("one\0two", 7)));
    CHECK(content_of(folder / "a/b/file.txt") == std::string("one\0two", 7));
    CHECK(count_of(folder / "a/b") == 1);
}

TEST_CASE("a file of any size is copied over another one, and a missing one changes nothing") {
    const TemporaryFolder folder;
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, std::size_t{1} << 20, (std::size_t{1} << 20) + 7}) {
        std::string bytes(size, 'a');
        if (size > 0)
            bytes.back() = 'z';
        folder.write("to", "before");
        REQUIRE(copy_atomically(folder.write("from", bytes), folder / "to"));
        CHECK(content_of(folder / "to") == bytes);
    }
    folder.write("to", "before");
    const auto failed = copy_atomically(folder / "none", folder / "to");
    REQUIRE_FALSE(failed.has_value());
    CHECK(failed.error().front().file == folder / "none");
    CHECK(content_of(folder / "to") == "before");
}

TEST_CASE("an existing file is replaced and keeps its permissions") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "a long old content");
    fs::permissions(file, fs::perms(0640));
    REQUIRE(write_atomically(file, "new"));
    CHECK(content_of(file) == "new");
    CHECK(fs::status(file).permissions() == fs::perms(0640));
}

TEST_CASE("a new file gets permissions from the umask") {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    REQUIRE(write_atomically(folder / "file", "new"));
    ::umask(before);
    CHECK(fs::status(folder / "file").permissions() == fs::perms(0640));
}

TEST_CASE(
    "a symbolic link is kept and its target is written, also through chains and dangling links") {
    const TemporaryFolder folder;
    folder.write("there/file", "old");
    fs::create_symlink("there/file", folder / "inner");
    fs::create_symlink(folder / "inner", folder / "outer");
    REQUIRE(write_atomically(folder / "outer", "new"));
    CHECK(fs::is_symlink(folder / "outer"));
    CHECK(fs::is_symlink(folder / "inner"));
    CHECK(content_of(folder / "there/file") == "new");

    fs::create_symlink("there/later", folder / "dangling");
    REQUIRE(write_atomically(folder / "dangling", "made"));
    CHECK(fs::is_symlink(folder / "dangling"));
    CHECK(content_of(folder / "there/later") == "made");
}

TEST_CASE("an impossible target is an error with a reason, and leaves no files behind") {
    const TemporaryFolder folder;
    folder.write("file", "kept");
    fs::create_symlink("circle", folder / "circle");
    fs::create_directory(folder / "folder");
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    const auto message = [&](const fs::path& file) {
        const auto written = write_atomically(file, "new");
        REQUIRE_FALSE(written.has_value());
        REQUIRE(written.error().size() == 1);
        CHECK(written.error().front().file == file);
        return written.error().front().message;
    };
    CHECK(message(folder / "folder") == "can't write the file: it is a folder");
    CHECK(message(folder / "pipe") == "can't write the file: it isn't a regular file");
    CHECK(message(folder / "circle") == "can't write the file: its symbolic links form a loop");
    CHECK(message(folder / "file/inside") == "can't create its folder: Not a directory");
    CHECK(message("/proc/afterglow/file").starts_with("can't create its folder: "));
    CHECK(message(folder / std::string(300, 'n')).starts_with("can't write the file: "));
    CHECK(message(folder.path() / "") == "can't write the file: the path has no file name");
    CHECK(message("") == "can't write the file: the path has no file name");
    CHECK(content_of(folder / "file") == "kept");
    CHECK(count_of(folder.path()) == 4);
}

TEST_CASE("a file is written even if its folder cannot be flushed") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.json", "old");
    fails_to_flush_folders = true;
    const auto written = write_atomically(file, "new");
    fails_to_flush_folders = false;
    CHECK(written.has_value());
    CHECK(content_of(folder / "a.json") == "new");
}

TEST_CASE("after a kill at any moment, the file has either the old or the new content") {
    const TemporaryFolder folder;
    const fs::path file = folder / "file";
    // The length and the letter of a text match, so that a partially written file is detected.
    const auto text = [](int round) {
        return std::string(static_cast<std::size_t>(1 + round % 7 * 40000),
                           static_cast<char>('a' + round % 7));
    };
    REQUIRE(write_atomically(file, text(0)));
    std::mt19937 random(20240601);
    std::uniform_int_distribution<useconds_t> moment(0, 8000);
    int changes = 0;
    // On a busy machine the child may be killed before it saves.
    for (int trial = 0; trial < 60 || (changes <= 10 && trial < 2000); ++trial) {
        const std::string before = content_of(file);
        const pid_t child = ::fork();
        if (child == 0)
            for (int round = trial + 1;; ++round)
                if (!write_atomically(file, text(round)))
                    ::_exit(1);
        REQUIRE(child > 0);
        ::usleep(moment(random));
        ::kill(child, SIGKILL);
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status));
        const std::string after = content_of(file);
        changes += after != before;
        REQUIRE_FALSE(after.empty());
        CHECK(after == text(after.front() - 'a'));
    }
    CHECK(changes > 10);  // the child did save
    REQUIRE(write_atomically(file, "last"));
    CHECK(count_of(folder.path()) == 1);
}

TEST_CASE("a save removes temporary files of killed processes, and nothing else") {
    const TemporaryFolder folder;
    folder.write(".afterglow-4194301-7.tmp", "half of a pres");
    folder.write(".afterglow-1-0.tmp", "of a process that has another's number now");
    // Names in another format, and links and folders with a matching name, belong to the user.
    const std::vector<std::string> kept = {
        ".afterglow-notes.tmp", ".afterglow-1-.tmp", ".afterglow--1.tmp", ".afterglow-1-2.tmp.bak",
        "afterglow-1-2.tmp",    ".afterglow.tmp",    ".afterglow-1-x.tmp"};
    for (const std::string& name : kept)
        folder.write(name, "mine");
    fs::create_directory(folder / ".afterglow-5-5.tmp");
    fs::create_symlink("afterglow-1-2.tmp", folder / ".afterglow-6-6.tmp");
    fs::create_directory(folder / "inside");
    folder.write("inside/.afterglow-4194301-7.tmp", "of another folder");

    REQUIRE(write_atomically(folder / "file", "new"));
    CHECK_FALSE(fs::exists(folder / ".afterglow-4194301-7.tmp"));
    CHECK_FALSE(fs::exists(folder / ".afterglow-1-0.tmp"));
    for (const std::string& name : kept)
        CHECK(content_of(folder / name) == "mine");
    CHECK(fs::is_directory(folder / ".afterglow-5-5.tmp"));
    CHECK(fs::is_symlink(folder / ".afterglow-6-6.tmp"));
    CHECK(fs::exists(folder / "inside/.afterglow-4194301-7.tmp"));
    CHECK(count_of(folder.path()) == kept.size() + 4);
}

TEST_CASE("concurrent saves into one folder do not affect each other") {
    const TemporaryFolder folder;
    constexpr int writers = 4;
    std::vector<pid_t> children;
    for (int writer = 0; writer < writers; ++writer) {
        const pid_t child = ::fork();
        if (child == 0) {
            const fs::path file = folder / std::to_string(writer);
            for (int round = 0; round < 60; ++round)
                if (!write_atomically(file, std::to_string(round)))
                    ::_exit(1);
            ::_exit(0);
        }
        REQUIRE(child > 0);
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
    }
    for (int writer = 0; writer < writers; ++writer)
        CHECK(content_of(folder / std::to_string(writer)) == "59");
    CHECK(count_of(folder.path()) == writers);
}
