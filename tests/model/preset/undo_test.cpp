#include "model/preset/undo.h"

#include <doctest/doctest.h>

TEST_CASE("undo goes back step by step and redo forward again") {
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

TEST_CASE("a drag is one step until it is finished") {
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

TEST_CASE("another knob in the middle of a drag is a step of its own") {
    Undo<int> undo(0);
    undo.change(1, "decay", true);
    undo.change(2, "gain", true);
    undo.undo();
    CHECK(undo.current() == 1);
}

TEST_CASE("what changes nothing is no step, and a new change ends what could be redone") {
    Undo<int> undo(0);
    undo.change(0, "nothing");
    CHECK_FALSE(undo.can_undo());
    undo.change(1, "one");
    undo.undo();
    undo.change(2, "two");
    CHECK_FALSE(undo.can_redo());
    CHECK(undo.current() == 2);
}

TEST_CASE("undo and redo at their ends do nothing") {
    Undo<int> undo(7);
    undo.undo();
    undo.redo();
    CHECK(undo.current() == 7);
}

TEST_CASE("only the newest thousand steps are kept") {
    Undo<int> undo(0);
    for (int i = 1; i <= 1500; ++i)
        undo.change(i, "step");
    CHECK(undo.past().size() == 1000);
    while (undo.can_undo())
        undo.undo();
    CHECK(undo.current() == 500);
}

TEST_CASE("a rewrite reaches the past and what can be redone; a saved history comes back") {
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

TEST_CASE("undo ends a gesture: what is turned next is a step of its own") {
    Undo<int> undo(1);
    undo.change(2, "gain");
    undo.change(3, "gain", true);  // the hand is still on it
    undo.undo();
    undo.change(4, "gain", true);
    undo.undo();
    CHECK(undo.current() == 2);
}
