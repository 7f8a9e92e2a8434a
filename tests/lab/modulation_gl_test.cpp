#include "formats/preset/preset_format.h"
#include "lab/document/changes.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/offline/offline.h"
#include "lab/session.h"
#include "lab/small_lab.h"

#include <cmath>
#include <numbers>

namespace {
/// Varies gain around 1 by 1/8 of its range 0 .. 8, once per second.
const Modulation once_a_second{.depth = 0.125, .shape = LfoShape::sine, .rate = 1.0};

double gain_at(double seconds) {
    return 1.0 + std::sin(2.0 * std::numbers::pi * seconds);
}

void move_gain(SmallLab& small) {
    small.lab().edit([](Document& document) { set_modulation(document, "gain", once_a_second); });
}

bool is_close(double number, double expected) {
    return std::abs(number - expected) <= 1e-4 * std::max(1.0, std::abs(expected));
}

Offline drawn_offline(SmallLab& small, double fps) {
    RenderRequest request{.look = "small", .preset = "moving", .size = {8, 8}, .fps = fps};
    auto prepared = prepare(request, Library(small.roots()));
    REQUIRE(prepared.has_value());
    auto offline = Offline::create(std::move(*prepared), request.size, fps);
    REQUIRE(offline.has_value());
    return std::move(*offline);
}
}  // namespace

TEST_CASE("setting a modulation can be undone, and running it is not a change") {
    SmallLab small;
    move_gain(small);
    const Document& document = small.document();
    CHECK(document.history().undo_name() == "Modulation of Gain");
    CHECK(is_modified(document));
    small.lab().edit([](Document& changed) { opened_preset(changed).saved = changed.state(); });
    for (int i = 0; i < 20; ++i) {
        small.update(1);
        CHECK(is_close(small.shown(), small.frames() * gain_at(small.player().transport().time())));
    }
    CHECK(document.values().empty());
    CHECK_FALSE(is_modified(document));
    CHECK(document.history().past().size() == 1);
    small.lab().edit([](Document& changed) { changed.undo(); });
    small.update(1);
    CHECK(document.state().modulations.empty());
    CHECK(small.shown() == small.frames());
    small.lab().edit([](Document& changed) { changed.redo(); });
    CHECK(document.state().modulations == Modulations{{"gain", once_a_second}});
}

TEST_CASE("while paused a changed value is drawn with its modulation, and a step advances it") {
    SmallLab small;
    move_gain(small);
    small.update(13);
    small.lab().player().pause();
    small.lab().edit([](Document& document) { document.set_value("gain", Value(3.0)); });
    small.update(2);
    const double time = small.player().transport().time();
    CHECK(is_close(small.shown(), small.frames() * (2.0 + gain_at(time))));
    small.lab().player().step();
    small.update(1);
    CHECK(is_close(small.player().transport().time(), time + 1.0 / 60.0));
    CHECK(is_close(small.shown(), small.frames() * (2.0 + gain_at(time + 1.0 / 60.0))));
}

TEST_CASE("a replay uses the modulated values of each frame's time") {
    SmallLab small;
    small.update(40);
    small.lab().player().pause();
    Modulation moving = once_a_second;
    moving.depth = 0.25;  // of 0 .. 4
    small.lab().edit([&](Document& document) { set_modulation(document, "step_size", moving); });
    small.update_until([&] {
        return !small.lab().renderer()->replay().is_running() &&
               small.lab().renderer()->replay().total() > 0;
    });
    const auto& past = small.player().transport().past();
    double sum = 0.0;
    for (std::size_t i = past.size() - 20; i < past.size(); ++i)  // settle_frames
        sum += gain_at(past[i].span.end);
    CHECK(is_close(small.shown(), sum));
}

TEST_CASE("a preset moves identically in the window and offline, at any frame rate") {
    SmallLab small;
    move_gain(small);
    small.lab().presets().save_as("moving");
    CHECK_FALSE(is_modified(small.document()));
    for (const double fps : {30.0, 60.0}) {
        Offline offline = drawn_offline(small, fps);
        const int frames = static_cast<int>(std::lround(0.3 * fps));
        const Picture picture = offline.picture_after(frames);
        CHECK(is_close(picture.pixels[0], frames * gain_at(0.3)));
        Document still = offline.document();
        set_modulation(still, "gain", std::nullopt);
        REQUIRE(offline.start_again(still).has_value());
        CHECK(offline.picture_after(4).pixels[0] == 4.0f);
    }
    const auto described = prepare({.look = "small", .preset = "moving"}, Library(small.roots()));
    REQUIRE(described.has_value());
    CHECK(describe(*described, {8, 8})->find("\"kind\": \"lfo\"") != std::string::npos);
}

TEST_CASE("a modulation is restored with the session and listed in the history") {
    SmallLab small;
    const DocumentState before = small.document().state();
    move_gain(small);
    const auto changes = changes_between(small.document().look(), before, small.document().state());
    REQUIRE(changes.size() == 1);
    CHECK(line_of(changes.front()) ==
          "Modulation of Gain none → LFO, sine, rate 1 Hz, phase 0 turns, depth 0.125");
    const Session session = session_of(small.lab(), {});
    CHECK(has_unsaved(session));
    small.start();
    restore(small.lab(), session);
    small.wait_for_frames();
    CHECK(small.document().state().modulations == Modulations{{"gain", once_a_second}});
}

TEST_CASE("a locked parameter keeps its modulation when everything is reset") {
    SmallLab small;
    move_gain(small);
    small.lab().edit([](Document& document) {
        set_modulation(document, "step_size", once_a_second);
        set_parameter_setting(document, "gain", {.is_locked = true});
        reset_all_parameters(document);
    });
    CHECK(small.document().state().modulations == Modulations{{"gain", once_a_second}});
}
