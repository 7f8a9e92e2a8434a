// The viewers of a look are warmed up in its context before it is displayed.
#include "graph/warm_up/first_views.h"
#include "lab/small_lab.h"

namespace {
/// Whether the viewers are warmed up in the look's context for each kind of its targets.
bool has_met_all(Lab& lab) {
    const Executor& executor = lab.renderer()->executor();
    const auto views = executor.programs().generic().first_views;
    REQUIRE(views);
    views->expect(executor.look(), executor.plan());
    return views->pending() == 0;
}

bool is_open(SmallLab& small, const std::string& look) {
    return small.update_until([&] {
        return !small.lab().loader().is_loading() && small.document().look().id == look &&
               small.lab().renderer()->has_drawn();
    });
}
}  // namespace

TEST_CASE("the viewers of an opening look are warmed up while the previous look is displayed") {
    SmallLab small;
    small.lab().looks().duplicate("other");
    REQUIRE(is_open(small, "other"));
    bool has_met = false;  // a look that opens before the reader was idle is not warmed up
    for (int rests = 0; !has_met && rests < 10; ++rests) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
        small.update_until([end] { return std::chrono::steady_clock::now() > end; });
        small.lab().looks().open("small");
        REQUIRE(is_open(small, "small"));
        has_met = has_met_all(small.lab());
        small.lab().looks().open("other");
        REQUIRE(is_open(small, "other"));
    }
    CHECK(has_met);
    CHECK(has_met_all(small.lab()));
}

TEST_CASE("a reload that changes a target's format is shown after its viewers are warmed up") {
    SmallLab small;
    const auto now = small.lab().renderer()->executor().programs().generic().first_views;
    has_met_all(small.lab());  // the warm-ups that are due now are done with the edit
    small.write_by_rename("look.json", replaced(small_look::manifest, "rgba32f", "rg16f"));
    REQUIRE(small.update_until(
        [&] { return small.document().look().passes[0].format == Format::rg16f; }));
    CHECK(small.lab().renderer()->executor().programs().generic().first_views == now);
    CHECK(has_met_all(small.lab()));
}
