// Where a look is drawn, the driver has met all that is looked at before it is seen.
#include "graph/warm_up/first_views.h"
#include "lab/small_lab.h"

namespace {
/// Whether each kind of picture that the open look draws has been looked at in its home.
bool has_met_all(Lab& lab) {
    const Executor& executor = lab.renderer()->executor();
    const auto views = executor.programs().first_views;
    REQUIRE(views);
    views->expect(executor.look(), executor.plan());
    return views->owed() == 0;
}

bool is_open(SmallLab& small, const std::string& look) {
    return small.turn_until([&] {
        return !small.lab().loader().is_loading() && small.document().look().id == look &&
               small.lab().renderer()->has_drawn();
    });
}
}  // namespace

TEST_CASE("a look that is opened has been looked at, beside the one that is seen until then") {
    SmallLab small;
    small.lab().new_look("other");
    REQUIRE(is_open(small, "other"));
    bool has_met = false;  // what is opened before the reader has had a rest is not looked at
    for (int rests = 0; !has_met && rests < 10; ++rests) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
        small.turn_until([end] { return std::chrono::steady_clock::now() > end; });
        small.lab().open("small");
        REQUIRE(is_open(small, "small"));
        has_met = has_met_all(small.lab());
        small.lab().open("other");
        REQUIRE(is_open(small, "other"));
    }
    CHECK(has_met);
    CHECK(has_met_all(small.lab()));
}

TEST_CASE("an edit that draws another kind of picture is not seen before that has been looked at") {
    SmallLab small;
    const auto now = small.lab().renderer()->executor().programs().first_views;
    has_met_all(small.lab());  // what is owed by now is met with the edit
    small.write_by_rename("look.json", replaced(small_look::manifest, "rgba32f", "rg16f"));
    REQUIRE(small.turn_until(
        [&] { return small.document().look().passes[0].format == Format::rg16f; }));
    CHECK(small.lab().renderer()->executor().programs().first_views == now);
    CHECK(has_met_all(small.lab()));
}
