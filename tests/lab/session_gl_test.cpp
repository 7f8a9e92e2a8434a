#include "formats/preset/preset_format.h"
#include "io/pictures/picture_file.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/session.h"
#include "lab/session/session_autosave.h"
#include "lab/small_lab.h"

namespace fs = std::filesystem;

namespace {
const std::map<std::string, double> kept_window{{"width", 1000.0}, {"scale", 1.25}};

// The session after the end of the program, whether it was closed or killed.
Session stored(SmallLab& small) {
    REQUIRE(save_session(small.roots(), session_of(small.lab(), kept_window)).has_value());
    Diagnostics warnings;
    Session session = load_session(small.roots(), warnings);
    CHECK(warnings.empty());
    return session;
}

void set_gain(SmallLab& small, double gain) {
    small.lab().edit([gain](Document& document) { document.set_value("gain", Value(gain)); });
}
}  // namespace

TEST_CASE("unsaved values, undo, redo, preset, time and render size are restored") {
    SmallLab small;
    set_gain(small, 2.0);
    small.lab().presets().save_as("two");
    set_gain(small, 3.0);
    set_gain(small, 4.0);
    small.lab().edit([](Document& document) { document.undo(); });
    small.lab().work().size.choose({false, {16, 8}, 0.5});
    small.update(5);
    small.lab().player().pause();
    const double time = small.player().transport().time();
    const Session session = stored(small);
    CHECK(session.window == kept_window);

    small.start();
    restore(small.lab(), session);
    REQUIRE(small.update_until([&] { return small.lab().document() != nullptr; }));
    CHECK(small.document().values().at("gain") == Value(3.0));
    CHECK(preset_name(small.document()) == "two");
    CHECK(is_modified(small.document()));
    CHECK_FALSE(small.player().transport().is_playing());
    CHECK(std::abs(small.player().transport().time() - time) < 1.5 / 60.0);  // one frame may pass
    CHECK(small.lab().work().size.extent() == Extent{8, 4});
    small.lab().edit([](Document& document) { document.redo(); });
    CHECK(small.document().values().at("gain") == Value(4.0));
    for (int i = 0; i < 2; ++i)
        small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().values().at("gain") == Value(2.0));
    CHECK_FALSE(is_modified(small.document()));
}

TEST_CASE("undo after a restart returns to the preset that was open before") {
    SmallLab small;
    set_gain(small, 2.0);
    small.lab().presets().save_as("two");
    set_gain(small, 3.0);
    small.lab().presets().save_as("three");
    const fs::path three = preset_file(small.document());
    const auto two = load_preset(three.parent_path() / "two.json");
    REQUIRE(two.has_value());
    small.lab().edit(
        [&](Document& document) { open_preset(document, *two, three.parent_path() / "two.json"); });
    const Session session = stored(small);
    CHECK(session.opened.size() == 2);

    small.start();
    restore(small.lab(), session);
    REQUIRE(small.update_until([&] { return small.lab().document() != nullptr; }));
    CHECK(preset_name(small.document()) == "two");
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(preset_file(small.document()) == three);
    CHECK(preset_name(small.document()) == "three");
    CHECK_FALSE(is_modified(small.document()));

    small.lab().edit([](Document& document) { document.redo(); });
    small.lab().presets().rename(three, "four");  // also for the past
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(preset_name(small.document()) == "four");
    CHECK(preset_file(small.document()).stem() == "four");
}

TEST_CASE("a change is saved at once, and a drag when it ends") {
    SmallLab small;
    SessionAutosave keeper(small.roots());
    const WindowState arrangement;
    const auto kept_gain = [&] {
        Diagnostics warnings;
        const Values values = load_session(small.roots(), warnings).current.preset.values;
        return values.count("gain") ? values.at("gain").number() : 0.0;
    };
    set_gain(small, 2.0);
    keeper.update(small.lab(), arrangement);
    CHECK(kept_gain() == 2.0);
    small.lab().edit([](Document& document) { document.set_value("gain", Value(3.0), true); });
    keeper.update(small.lab(), arrangement);
    CHECK(kept_gain() == 2.0);
    small.lab().edit([](Document& document) { document.finish(); });
    keeper.update(small.lab(), arrangement);
    CHECK(kept_gain() == 3.0);
}

TEST_CASE("a paused picture whose first replay is cancelled is drawn with a partial history") {
    SmallLab small;
    small.update(30);
    small.lab().player().pause();
    const Session session = stored(small);
    small.start();
    restore(small.lab(), session);
    REQUIRE(small.update_until(
        [&] { return small.lab().renderer() && small.lab().renderer()->replay().is_running(); }));
    small.lab().frames().cancel_replay();
    REQUIRE_FALSE(small.lab().renderer()->has_drawn());
    small.update(1);
    CHECK(small.shown() >= 1.0f);  // every frame adds one
    CHECK(small.shown() < 20.0f);  // fewer frames than settle_frames
}

TEST_CASE("values follow a look that was edited between two sessions") {
    SmallLab small;
    set_gain(small, 3.0);
    const Session session = stored(small);
    small.write("gain.glsl", "uniform float strength = 1.0;  // @range 0 8 @was gain\n");
    small.write("show.frag", replaced(small_look::show, "* gain", "* strength"));
    small.start();
    restore(small.lab(), session);
    REQUIRE(small.update_until([&] { return small.lab().document() != nullptr; }));
    CHECK(small.document().values() == Values{{"strength", Value(3.0)}});
}

TEST_CASE("unsaved changes are stored when another look opens, and can be restored") {
    SmallLab small;
    small.lab().looks().stash_unsaved(stored(small));
    CHECK(small.lab().looks().stash().files().empty());  // nothing unsaved
    set_gain(small, 3.0);
    small.lab().looks().stash_unsaved(stored(small));
    small.lab().looks().stash_unsaved(stored(small));
    REQUIRE(small.lab().looks().stash().files().size() == 1);  // without a duplicate
    const fs::path three = small.lab().looks().stash().files().front();
    CHECK(small.lab().looks().stash().list().front().look == "small");
    CHECK(small.lab().looks().stash().list().front().changes == 1);

    small.start();
    small.lab().looks().open("small");
    small.wait_for_frames();
    set_gain(small, 5.0);
    restore_stashed(small.lab(), three);
    const auto has_gain = [&](double gain) {
        const auto value = small.document().values().find("gain");
        return value != small.document().values().end() && value->second == Value(gain);
    };
    REQUIRE(small.update_until([&] { return has_gain(3.0); }));
    REQUIRE(small.lab().looks().stash().files().size() == 1);
    const fs::path five = small.lab().looks().stash().files().front();
    const fs::path picture = small.lab().looks().stash().list().front().picture;
    CHECK(load_picture(picture).has_value());
    CHECK_FALSE(fs::exists(three));
    restore_stashed(small.lab(), five);
    CHECK(small.update_until([&] { return has_gain(5.0); }));
    CHECK_FALSE(fs::exists(picture));
}

TEST_CASE("changes are counted without locked content, and ages are rounded") {
    Session session;
    session.opened.front().saved.preset.values = {{"a", Value(1.0)}, {"b", Value(1.0)}};
    session.current.preset.values = {{"a", Value(2.0)}, {"c", Value(1.0)}};
    session.current.preset.signal = Spec{"waveform", {}};
    session.current.overrides["sum"].scale = 0.5;
    CHECK(count_changes(session) == 5);  // a, b, c, the signal and a pass
    session.current.locks.signal = true;
    CHECK(count_changes(session) == 4);
    CHECK(age_text(5.0) == "just now");
    CHECK(age_text(640.0) == "10 min ago");
    CHECK(age_text(2.0 * 3600.0) == "2 h ago");
    CHECK(age_text(25.0 * 3600.0) == "1 day ago");
}

TEST_CASE("the latest 12 unsaved sessions are kept") {
    const SmallLab small;
    SessionStash sessions(small.roots());
    Session session;
    session.look = "small";
    session.current.preset.look = "small";
    session.opened.front().saved.preset.look = "small";
    for (int i = 1; i <= 14; ++i) {
        session.current.preset.values["gain"] = Value(static_cast<double>(i));
        CHECK(sessions.keep(session).value_or(false));
    }
    const SessionStash again(small.roots());
    REQUIRE(again.files().size() == 12);
    CHECK(again.files() == sessions.files());
    const auto latest = SessionStash::read(again.files().front());
    const auto oldest = SessionStash::read(again.files().back());
    REQUIRE(latest.has_value());
    REQUIRE(oldest.has_value());
    CHECK(latest->current.preset.values.at("gain") == Value(14.0));
    CHECK(oldest->current.preset.values.at("gain") == Value(3.0));
}

TEST_CASE("a preset's name cannot select the folder of the unsaved changes") {
    const SmallLab small;
    SessionStash sessions(small.roots());
    Session session;
    session.current.preset.look = "small";
    session.current.preset.values["gain"] = Value(2.0);
    session.opened.front().saved.preset.name = "../up\n" + std::string(115, 'x') + "\u00e9";
    REQUIRE(sessions.keep(session).value_or(false));
    const fs::path file = sessions.files().front();
    CHECK(file.parent_path() == small.roots().state / "unsaved");
    CHECK(fs::exists(file));
    CHECK(file.stem().string().substr(7).starts_with("small \u2013 ..-up-xxx"));
}

TEST_CASE("a damaged session is set aside and reported, and the program starts without it") {
    const SmallLab small;
    const fs::path file = small.roots().state / "session.json";
    for (const std::string& text :
         {std::string("{"), std::string(), std::string("[1, 2]"), std::string("\x00\xff", 2),
          std::string(R"({"format": "x"})")}) {
        REQUIRE(write_atomically(file, text).has_value());
        Diagnostics warnings;
        CHECK(load_session(small.roots(), warnings).look.empty());
        CHECK_FALSE(warnings.empty());
        CHECK_FALSE(fs::exists(file));
        CHECK(content_of(file.string() + ".damaged") == text);
    }
}

TEST_CASE("favourites, locks and slider ranges are restored, even after leaving the look") {
    SmallLab small;
    small.lab().edit([](Document& document) {
        set_parameter_setting(document, "gain", {.is_favourite = true, .is_locked = true});
    });
    small.lab().parameters().set_slider_ends("gain", Limit{1.0, 3.0});
    const ParameterSetting gain{true, true, Limit{1.0, 3.0}};
    const Session session = stored(small);
    small.start();
    small.lab().parameters().set_all(session.parameter_settings);
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return small.lab().document() != nullptr; }));
    CHECK(small.document().parameter_settings() == ParameterSettings{{"gain", gain}});
    small.lab().parameters().set_slider_ends("gain", Limit{3.0, 1.0});
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->is_problem);
    CHECK(small.document().parameter_settings() == ParameterSettings{{"gain", gain}});
    small.lab().parameters().set_slider_ends("gain", std::nullopt);
    CHECK_FALSE(small.document().parameter_settings().at("gain").ends.has_value());
}

TEST_CASE("a changed locked value causes no warning when presets are opened") {
    SmallLab small;
    small.lab().presets().save_as("one");
    const auto set = [&](const char* name, double value) {
        small.lab().edit([&](Document& document) { document.set_value(name, Value(value)); });
    };
    const auto opened_again = [&] {
        while (small.lab().messages().notice())
            small.lab().update(10.0);  // earlier notices expire
        small.lab().looks().open(
            small.lab().work().library.find_preset("small", "one")->file.string());
        REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
        return small.lab().messages().notice().has_value();
    };
    small.lab().edit(
        [](Document& document) { set_parameter_setting(document, "gain", {.is_locked = true}); });
    set("gain", 3.0);
    CHECK_FALSE(opened_again());
    CHECK(small.document().values() == Values{{"gain", Value(3.0)}});
    set("step_size", 2.0);
    CHECK(opened_again());  // not locked, so undo can restore it
    CHECK(small.document().values() == Values{{"gain", Value(3.0)}});
}
