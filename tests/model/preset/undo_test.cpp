#include "model/preset/undo.h"

#include <doctest/doctest.h>

TEST_CASE("undo and redo move one step at a time") {
    Undo<int> undo(1);
    undo.change(2, "two");
    undo.change(3, "three");
    CHECK(undo.undo_name() == "three");
    undo.undo();
    CHECK(undo.current() == 2);
    CHECK(undo.redo_name() == "three");
    undo.undo();
    CHECK(undo.current() == 1);
    CHECK_FALSE(undo.can_undo());
    undo.redo();
    undo.redo();
    CHECK(undo.current() == 3);
    CHECK_FALSE(undo.can_redo());
}

TEST_CASE("a drag is one undo step until it is finished") {
    Undo<int> undo(0);
    for (int i = 1; i <= 5; ++i)
        undo.change(i, "decay", true);
    undo.finish();
    undo.change(9, "decay", true);
    undo.undo();
    CHECK(undo.current() == 5);
    undo.undo();
    CHECK(undo.current() == 0);
}

TEST_CASE("changing another parameter during a drag starts a new undo step") {
    Undo<int> undo(0);
    undo.change(1, "decay", true);
    undo.change(2, "gain", true);
    undo.undo();
    CHECK(undo.current() == 1);
}

TEST_CASE("a change without effect adds no undo step, and a new change discards redo") {
    Undo<int> undo(0);
    undo.change(0, "nothing");
    CHECK_FALSE(undo.can_undo());
    undo.change(1, "one");
    undo.undo();
    undo.change(2, "two");
    CHECK_FALSE(undo.can_redo());
    CHECK(undo.current() == 2);
}

TEST_CASE("undo and redo do nothing at the ends of the history") {
    Undo<int> undo(7);
    undo.undo();
    undo.redo();
    CHECK(undo.current() == 7);
}

TEST_CASE("the undo history is limited to the newest 1000 steps") {
    Undo<int> undo(0);
    for (int i = 1; i <= 1500; ++i)
        undo.change(i, "step");
    CHECK(undo.past().size() == 1000);
    while (undo.can_undo())
        undo.undo();
    CHECK(undo.current() == 500);
}

TEST_CASE("a rewrite applies to all undo and redo states, and a saved history is restored") {
    Undo<int> undo(1);
    undo.change(2, "two");
    undo.change(3, "three");
    undo.undo();
    undo.rewrite([](int& state) { state *= 10; });
    Undo<int> back = Undo<int>::restored(undo.past(), undo.current(), undo.future());
    CHECK(back.current() == 20);
    back.redo();
    CHECK(back.current() == 30);
    back.undo();
    back.undo();
    CHECK(back.current() == 10);
}

TEST_CASE("undo ends a drag: the next change is a new undo step") {
    Undo<int> undo(1);
    undo.change(2, "gain");
    undo.change(3, "gain", true);  // the drag is not finished
    undo.undo();
    undo.change(4, "gain", true);
    undo.undo();
    CHECK(undo.current() == 2);
}
