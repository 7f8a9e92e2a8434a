#include "lab/reload/opening_mark.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace {
/// The state folder of a run, and what a crash of it would leave behind.
class Run {
public:
    Roots roots() const { return {m_folder.path(), m_folder.path(), m_folder.path()}; }

    // The kernel ends the lock of a dead process; a copy was never locked.
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

TEST_CASE("a crash leaves the name and place of the look that was compiled") {
    const Run run;
    OpeningMark mark(run.roots());
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
    mark.begin(request_for("/looks/bad.fs"), "/looks/part.glsl");
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());  // the run goes on
    run.crash();
    const auto left = find_unfinished_opening(run.roots());
    REQUIRE(left.has_value());
    CHECK(left->look == "bad.fs");
    CHECK(left->places == std::vector<fs::path>{"/looks/bad.fs"});
    CHECK(left->file() == "/looks/part.glsl");
    CHECK(left->has("/looks/../looks/bad.fs"));
    CHECK_FALSE(left->has("/looks/good.fs"));
    CHECK_FALSE(left->is_reset);
}

TEST_CASE("a look that was opened leaves nothing, also where it was opened several times") {
    const Run run;
    {
        OpeningMark mark(run.roots());
        mark.begin(request_for("/looks/a.fs"), {});
        mark.begin(request_for("/looks/b.fs"), {});
        mark.end();
        CHECK_FALSE(mark.is_set());
        CHECK(fs::is_empty(run.roots().state / "opening"));
        mark.begin(request_for("/looks/c.fs"), {});
    }
    CHECK(fs::is_empty(run.roots().state / "opening"));
}

TEST_CASE("what a crash left is forgotten once another look is opened") {
    const Run run;
    OpeningMark mark(run.roots());
    mark.begin(request_for("/looks/a.fs"), {});
    run.crash();
    mark.end();
    REQUIRE(find_unfinished_opening(run.roots()).has_value());
    mark.begin(request_for("/looks/b.fs"), {});
    mark.end();
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
}

TEST_CASE("a reset of the driver is left behind although the program ends well") {
    const Run run;
    {
        OpeningMark mark(run.roots());
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

TEST_CASE("a damaged mark, or a state folder that cannot be written, is no crash") {
    const Run run;
    fs::create_directories(run.roots().state / "opening");
    TemporaryFolder folder;
    fs::copy_file(folder.write("mark", "not a mark"), run.roots().state / "opening/1");
    CHECK_FALSE(find_unfinished_opening(run.roots()).has_value());
    OpeningMark nowhere({"/", "/", "/proc/none"});
    nowhere.begin(request_for("/looks/a.fs"), {});
    CHECK_FALSE(nowhere.is_set());
}
