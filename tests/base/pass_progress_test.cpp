#include "base/pass_progress.h"

#include <doctest/doctest.h>

#include <vector>

using Step = PassProgress::Step;

TEST_CASE("a pass counts as done when the next one begins") {
    PassProgress progress;
    CHECK(progress.state().total == 0);
    progress.begin(Step::linking, 3);
    CHECK(to_string(progress.state()) == "Linking: 0 of 3 passes");
    CHECK(progress.next("beam"));
    CHECK(progress.state().done == 0);
    CHECK(progress.state().pass == "beam");
    CHECK(progress.next("glow"));
    CHECK(to_string(progress.state()) == "Linking: 1 of 3 passes");
    progress.begin(Step::drawing, 2);
    CHECK(to_string(progress.state()) == "First frame: 0 of 2 passes");
}

TEST_CASE("the listener is called for each pass, and cancelling stops at the next pass") {
    std::vector<std::string> reported;
    PassProgress progress([&reported](const PassProgress::State& state) {
        reported.push_back(state.pass + " " + std::to_string(state.done));
    });
    progress.begin(Step::reading, 3);
    CHECK(progress.next("a"));
    progress.cancel();
    CHECK_FALSE(progress.next("b"));
    CHECK(progress.is_cancelled());
    CHECK(reported == std::vector<std::string>{"a 0", "b 1"});
}

TEST_CASE("only a pass that takes over 3 seconds is named") {
    PassProgress::State state{Step::linking, 2, 7, "blur", 2.9};
    CHECK(to_string(state) == "Linking: 2 of 7 passes");
    state.seconds = 3.1;
    CHECK(to_string(state) == "Linking: 2 of 7 passes (blur is slow)");
}
