#include "lab/small_lab.h"
#include "lab/views/history_thumbnails.h"

TEST_CASE("a state's picture is copied at frames 1, 2, 4 ... 128 and then no more") {
    std::vector<int> due;
    for (int frame = -1; frame <= 1000; ++frame)
        if (is_copy_due(frame))
            due.push_back(frame);
    CHECK(due == std::vector<int>{1, 2, 4, 8, 16, 32, 64, 128});
}

TEST_CASE("the picture farthest from the current state is dropped first") {
    CHECK(farthest_index({3, 4, 9}, 4) == 9);
    CHECK(farthest_index({3, 4, 9}, 9) == 3);
    CHECK(farthest_index({7}, 7) == 7);
}

TEST_CASE("each state of the history has its own picture until another state replaces it") {
    SmallLab small;
    auto views = Views::make();
    REQUIRE(views.has_value());
    HistoryThumbnails pictures;
    const auto look = [&] {
        views->update(small.lab(), {});
        pictures.update(small.lab(), *views);
    };
    const auto update_with = [&](double gain) {
        small.lab().edit([gain](Document& document) { document.set_value("gain", Value(gain)); });
        small.lab().update(1.0 / 60.0);
        look();
    };
    look();
    update_with(2.0);
    update_with(3.0);
    const auto handle = [&](std::size_t place) {
        return pictures.picture(small.document(), place).handle;
    };
    CHECK(handle(0) != 0);
    CHECK(handle(1) != 0);
    CHECK(handle(2) != 0);
    CHECK(handle(1) != handle(2));
    CHECK(pictures.picture(small.document(), 1).extent == Extent{72, 72});  // of a square picture

    small.lab().edit([](Document& document) { document.undo(); });
    small.lab().edit([](Document& document) { document.set_value("gain", Value(4.0)); });
    CHECK(handle(1) != 0);
    CHECK(handle(2) == 0);  // its previous picture was of another state
    small.lab().update(1.0 / 60.0);
    look();
    CHECK(handle(2) != 0);
}
