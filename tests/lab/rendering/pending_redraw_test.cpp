#include "lab/rendering/pending_redraw.h"

#include <doctest/doctest.h>

TEST_CASE("redraws are joined until they are taken") {
    PendingRedraw pending;
    CHECK(pending.is_empty());
    pending.add({{true, false, false}, false});
    pending.add({{false, false, true}, false});
    CHECK_FALSE(pending.needs_replay());
    CHECK(pending.take().passes == std::vector<bool>{true, false, true});
    CHECK(pending.is_empty());
}

TEST_CASE("a replay stays needed when passes are added to it") {
    PendingRedraw pending;
    pending.add_replay();
    pending.add({{true}, false});
    CHECK(pending.needs_replay());
    pending.clear();
    CHECK(pending.is_empty());
    CHECK_FALSE(pending.needs_replay());
}
