#include "lab/offline/offline.h"
#include "lab/small_lab.h"

TEST_CASE("automation recorded in the window renders identically offline") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(3.0)); });
    small.update(1);
    small.lab().automation().record(true);
    std::map<int, float> shown;  // by frame number
    for (const double gain : {3.0, 0.5, 0.5, 4.0, 1.0, 2.0}) {
        small.lab().edit([&](Document& document) { document.set_value("gain", Value(gain)); });
        small.update(1);
        shown[static_cast<int>(small.frames())] = small.shown();
    }
    small.lab().automation().record(false);
    const auto file = small.folder() / "moves.txt";
    small.lab().automation().save(file);
    auto prepared = prepare({.look = "small", .automation = file.string()}, Library(small.roots()));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), {8, 8}, 60.0);
    REQUIRE(offline.has_value());
    for (int frame = 1; frame <= shown.rbegin()->first; ++frame) {
        offline->advance();
        const float expected =
            shown.contains(frame) ? shown.at(frame) : 3.0f * static_cast<float>(frame);
        CHECK(offline->picture().pixels[0] == expected);
    }
    CHECK(offline->document().values() == Values{{"gain", Value(2.0)}});
}
