#include "lab/reload/crash_marker.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace {
/// The state folder of a run, and the files that a crash would leave in it.
class Run {
public:
    Roots roots() const { return {m_folder.path(), m_folder.path(), m_folder.path()}; }

    // The kernel releases the lock of a dead process. A copy was never locked.
    void crash() const {
        const fs::path folder = m_folder.path() / "opening";
        for (const auto& entry : fs::directory_iterator(folder)) {
            fs::copy_file(entry.path(), folder / "crashed");
            return;
        }
        FAIL("there is no mark");
    }

private:
    TemporaryFolder m_folder;
};

OpenRequest request_for(const fs::path& look) {
    return {look, {}, {}};
}
}  // namespace

TEST_CASE("a crash leaves the name and location of the look that was compiled") {
    const Run run;
    CrashMarker mark(run.roots());
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
    mark.begin(request_for("/looks/bad.fs"), "/looks/part.glsl");
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());  // the run is still active
    run.crash();
    const auto left = find_unfinished_opening(run.roots());
    REQUIRE(left.has_value());
    CHECK(left->look == "bad.fs");
    CHECK(left->paths == std::vector<fs::path>{"/looks/bad.fs"});
    CHECK(left->file() == "/looks/part.glsl");
    CHECK(left->has("/looks/../looks/bad.fs"));
    CHECK_FALSE(left->has("/looks/good.fs"));
    CHECK_FALSE(left->is_reset);
}

TEST_CASE("an opened look leaves no mark, even after several openings") {
    const Run run;
    {
        CrashMarker mark(run.roots());
        mark.begin(request_for("/looks/a.fs"), {});
        mark.begin(request_for("/looks/b.fs"), {});
        mark.end();
        CHECK_FALSE(mark.is_set());
        CHECK(fs::is_empty(run.roots().state / "opening"));
        mark.begin(request_for("/looks/c.fs"), {});
    }
    CHECK(fs::is_empty(run.roots().state / "opening"));
}

TEST_CASE("the mark of a crash is removed when another look is opened") {
    const Run run;
    CrashMarker mark(run.roots());
    mark.begin(request_for("/looks/a.fs"), {});
    run.crash();
    mark.end();
    REQUIRE(find_unfinished_opening(run.roots()).has_value());
    mark.begin(request_for("/looks/b.fs"), {});
    mark.end();
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
}

TEST_CASE("a driver reset leaves a mark although the program exits normally") {
    const Run run;
    {
        CrashMarker mark(run.roots());
        Stack stack{{"a", "/looks/a.fs", "a"}, {"b", "/looks/b.fs", "b"}};
        mark.leave({"/looks/a.fs", {}, {}, stack});
    }
    const auto left = find_unfinished_opening(run.roots());
    REQUIRE(left.has_value());
    CHECK(left->is_reset);
    CHECK(left->look == "a.fs+b.fs");
    CHECK(left->file() == "/looks/a.fs");
    CHECK(left->has("/looks/b.fs"));
}

TEST_CASE("a damaged mark or an unwritable state folder does not count as a crash") {
    const Run run;
    fs::create_directories(run.roots().state / "opening");
    TemporaryFolder folder;
    fs::copy_file(folder.write("mark", "not a mark"), run.roots().state / "opening/1");
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
    CrashMarker nowhere({"/", "/", "/proc/none"});
    nowhere.begin(request_for("/looks/a.fs"), {});
    CHECK_FALSE(nowhere.is_set());
}

TEST_CASE("a look counts as opened after a few quiet updates, also with others between them") {
    const Run run;
    CrashMarker mark(run.roots());
    mark.begin(request_for("/looks/slow.fs"), {});
    for (int i = 0; i < 3; ++i) {
        mark.note_update(true);
        mark.note_update(false);  // amid a slow frame
    }
    CHECK(mark.is_set());
    mark.note_update(true);
    CHECK_FALSE(mark.is_set());
    mark.begin(request_for("/looks/slow.fs"), {});
    mark.note_update(true);
    CHECK(mark.is_set());
}
