#include "lab/sequencer/sound_region.h"

#include <doctest/doctest.h>

namespace {
Look scope_look() {
    Look look;
    look.driven_by = Driver::signal;
    return look;
}

/// Four seconds of sound at 1 kHz.
struct Song {
    Song() { follow(); }
    // As the frame loop does after an edit.
    void follow() {
        const auto sound = std::make_shared<Sound>(Sound{1000, 2, std::vector<float>(8000, 0.5f)});
        REQUIRE(
            player.set_signal(document.state().signal, {.file = {}, .sound = sound}).has_value());
    }

    Player player;
    Document document = [] {
        Document made(scope_look());
        made.amend([](DocumentState& state) {
            state.signal = Spec{"audio", {{"file", std::string("a.wav")}}};
        });
        return made;
    }();
};
}  // namespace

TEST_CASE("a region of a sound plays in a loop, and playback keeps its position in it") {
    Song song;
    song.player.seek(1.75);
    set_region(song.document, song.player, 2.0, 1.5);
    song.follow();
    const auto part = played_part(song.player.signal());
    CHECK(part->start == doctest::Approx(1.5));
    CHECK(part->end == doctest::Approx(2.0));
    CHECK(part->loops);
    CHECK(song.player.transport().time() == doctest::Approx(0.25));
    CHECK(part->position_at(0.25) == doctest::Approx(1.75));
    CHECK(part->position_at(0.6) == doctest::Approx(1.6));
    CHECK(has_region(song.player.signal()));
}

TEST_CASE("playback outside of a new region starts at the region") {
    Song song;
    song.player.seek(3.5);
    set_region(song.document, song.player, 1.0, 2.0);
    CHECK(song.player.transport().time() == 0.0);
}

TEST_CASE("one undo step removes a region, and removing it keeps the position") {
    Song song;
    const Spec before = song.document.state().signal;
    set_region(song.document, song.player, 1.0, 2.0);
    song.follow();
    song.player.seek(0.5);
    remove_region(song.document, song.player);
    song.follow();
    CHECK(song.document.state().signal == before);
    CHECK_FALSE(has_region(song.player.signal()));
    CHECK(song.player.transport().time() == doctest::Approx(1.5));
    song.document.undo();
    song.document.undo();
    CHECK(song.document.state().signal == before);
}

TEST_CASE("a region stays within the sound, and one that is too short is ignored") {
    Song song;
    set_region(song.document, song.player, -5.0, 99.0);
    song.follow();
    CHECK_FALSE(has_region(song.player.signal()));
    const DocumentState before = song.document.state();
    set_region(song.document, song.player, 1.0, 1.0004);
    set_region(song.document, song.player, 7.0, 9.0);
    CHECK(song.document.state() == before);
}

TEST_CASE("a time of the clock and a position of the sound belong together") {
    const PlayedPart part{10.0, 14.0, true};
    for (const double position : {10.0, 11.5, 13.9})
        CHECK(part.position_at(part.time_at(position)) == doctest::Approx(position));
    CHECK(part.time_at(3.0) == 0.0);
    CHECK(part.position_at(part.time_at(99.0)) < 14.0);
    CHECK(PlayedPart{10.0, 14.0, false}.position_at(5.0) == 15.0);
}
