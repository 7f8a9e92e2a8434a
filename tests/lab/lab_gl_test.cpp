#include "lab/document/opened_preset.h"
#include "lab/lab_parts.h"
#include "lab/menus/window_menu.h"
#include "lab/small_lab.h"

TEST_CASE("an open look draws every frame of the clock") {
    SmallLab small;
    CHECK(small.shown() == small.frames());
    small.update(5);
    CHECK(small.shown() == small.frames());
}

TEST_CASE("an edited shader is drawn, and values, clock and history stay") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    small.update(1);
    CHECK(small.shown() == 2 * small.frames());
    const auto before = small.frames();
    SUBCASE("saved in place") {
        small.write("show.frag", replaced(small_look::show, "* gain", "* gain * 4.0"));
    }
    SUBCASE("saved by rename") {
        small.write_by_rename("show.frag", replaced(small_look::show, "* gain", "* gain * 4.0"));
    }
    REQUIRE(small.update_until([&] { return small.shown() == 8 * small.frames(); }));
    CHECK(small.frames() > before);
    CHECK(small.lab().messages().problems().empty());
}

TEST_CASE("an edited include is drawn") {
    SmallLab small;
    small.write_by_rename("gain.glsl", "uniform float gain = 3.0;  // @range 0 8\n");
    CHECK(small.update_until([&] { return small.shown() == 3 * small.frames(); }));
}

TEST_CASE("an added pass is drawn, and other passes keep their history") {
    SmallLab small;
    const std::string third = replaced(small_look::manifest, R"("inputs": { "image": "sum" } })",
                                       R"("inputs": { "image": "sum" } },
    { "name": "third", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "show" } })");
    small.write_by_rename("look.json", third);
    REQUIRE(small.update_until([&] { return small.lab().document()->look().passes.size() == 3; }));
    small.update(1);
    CHECK(small.shown() == small.frames());
}

TEST_CASE("an error has file, line and source, keeps the last picture and can be fixed") {
    SmallLab small;
    small.write_by_rename("show.frag", replaced(small_look::show, "* gain", "* gian"));
    REQUIRE(small.update_until([&] { return !small.lab().messages().problems().empty(); }));
    const Problem problem = small.lab().messages().problems().front();
    CHECK(problem.diagnostic.file.filename() == "show.frag");
    CHECK(problem.diagnostic.line == 6);
    CHECK(problem.excerpt.line().find("gian") != std::string::npos);
    small.update(3);
    CHECK(small.shown() == small.frames());

    small.write_by_rename("show.frag", small_look::show);
    CHECK(small.update_until([&] { return small.lab().messages().problems().empty(); }));
}

TEST_CASE("the render size is a fixed size or 1/4 to 2 times the view") {
    SmallLab small;
    small.lab().work().size.set_view({40, 20});
    const auto drawn_at = [&small](const PictureSize& size) {
        small.lab().work().size.choose(size);
        small.update(1);
        REQUIRE(small.update_until([&] { return !small.lab().frames().has_unfinished_frame(); }));
        return small.lab().renderer()->executor().target(1).extent();
    };
    CHECK(drawn_at({true, {}, 1.0}) == Extent{40, 20});
    CHECK(drawn_at({true, {}, 9.0}) == Extent{80, 40});
    CHECK(drawn_at({true, {}, 0.01}) == Extent{10, 5});
    CHECK(drawn_at({false, {30, 10}, 0.5}) == Extent{15, 5});
}

TEST_CASE("the render size is chosen once, when the view keeps its size for half a second") {
    SmallLab small;
    small.lab().work().size.choose({});
    small.lab().work().size.set_view({40, 20});
    const auto update_for = [&small](double seconds) {
        for (double left = seconds; left > 0.0; left -= 0.05)
            small.lab().update(0.05);
    };
    update_for(0.4);
    small.lab().work().size.set_view({60, 20});
    CHECK(small.lab().work().size.extent() == Extent{60, 20});
    update_for(0.4);
    CHECK(small.lab().work().size.chosen().is_to_be_chosen());
    update_for(0.3);
    small.lab().work().size.set_view({30, 10});
    update_for(1.0);
    CHECK(small.lab().work().size.extent() == Extent{60, 20});
    small.lab().work().size.fix_to_view();
    CHECK(small.lab().work().size.extent() == Extent{30, 10});
    small.lab().work().size.choose(PictureSize{true, {}, 1.0});
    small.lab().work().size.set_view({50, 50});
    update_for(1.0);
    CHECK(small.lab().work().size.extent() == Extent{50, 50});
}

TEST_CASE("the output window offers its display's size if the fixed render size differs") {
    SmallLab small;  // of 8 x 8 px
    small.lab().work().size.set_view({40, 20});
    offer_display_size(small.lab().work().size, small.lab().messages(), {8, 8});
    CHECK_FALSE(small.lab().messages().notice());
    offer_display_size(small.lab().work().size, small.lab().messages(), {40, 20});
    REQUIRE(small.lab().messages().notice());
    CHECK(small.lab().messages().notice()->text ==
          "The render size is 8 × 8 px, the display 40 × 20 px");
    const MenuEntry match = small.lab().messages().notice()->buttons.front();
    match.commands.front()(mutable_parts(small.lab(), nullptr));
    CHECK(small.lab().work().size.extent() == Extent{40, 20});
    SmallLab following;
    following.lab().work().size.choose(PictureSize{true, {}, 1.0});
    offer_display_size(following.lab().work().size, following.lab().messages(), {40, 20});
    CHECK_FALSE(following.lab().messages().notice());
}

TEST_CASE("a uniform renamed with @was keeps its value") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(5.0)); });
    small.update(1);
    small.write_by_rename("show.frag", replaced(small_look::show, "* gain", "* strength"));
    small.write_by_rename("gain.glsl", "uniform float strength = 1.0;  // @range 0 8 @was gain\n");
    REQUIRE(small.update_until(
        [&] { return find_parameter(small.lab().document()->look(), "strength") != nullptr; }));
    small.update(1);
    CHECK(small.lab().document()->values() == Values{{"strength", Value(5.0)}});
    CHECK(small.shown() == 5 * small.frames());
}

TEST_CASE("while paused a changed value is drawn, also through passes with history") {
    SmallLab small;
    small.update(10);
    small.lab().player().pause();
    small.update(1);
    const float frames = small.frames();
    CHECK_FALSE(small.lab().is_moving());

    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    small.update(1);
    CHECK(small.shown() == 2 * frames);
    CHECK(small.frames() == frames);

    small.lab().edit([](Document& document) { document.set_value("step_size", Value(3.0)); });
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
    CHECK(small.shown() == 2 * 3 * std::min(frames, 20.0f));  // settle_frames is 20
    CHECK(small.frames() == frames);
}

TEST_CASE("during playback a changed value starts with the next frame") {
    SmallLab small;
    small.update(30);
    const float frames = small.frames();
    const float light = small.shown();
    small.lab().edit([](Document& document) { document.set_value("step_size", Value(3.0)); });
    for (int i = 0; i < 3; ++i)
        small.lab().update(0.0);  // like a display that is faster than the look
    CHECK(small.frames() == frames);
    CHECK(small.shown() == light);
    small.update(1);
    CHECK(small.shown() - light == 3 * (small.frames() - frames));
}

TEST_CASE("a replay can be cancelled") {
    SmallLab small;
    small.update(30);
    small.lab().player().pause();
    small.lab().edit([](Document& document) { document.set_value("step_size", Value(2.0)); });
    small.lab().frames().cancel_replay();
    CHECK(small.update_until([&] { return !small.lab().is_moving(); }));
}

TEST_CASE("restart begins at frame 1 without history") {
    SmallLab small;
    small.update(10);
    small.lab().frames().restart();
    small.update(1);
    CHECK(small.frames() == 1);
    CHECK(small.shown() == 1);
}

TEST_CASE("a saved preset restores its values when it is opened again") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(4.0)); });
    small.lab().presets().save_as("four");
    CHECK_FALSE(is_modified(*small.lab().document()));
    small.lab().edit([](Document& document) { document.set_value("gain", Value(1.5)); });
    CHECK(is_modified(*small.lab().document()));
    const auto preset = small.lab().work().library.find_preset("small", "four");
    REQUIRE(preset.has_value());
    small.lab().looks().open(preset->file.string());
    REQUIRE(small.update_until([&] {
        return !small.lab().loader().is_loading() &&
               preset_name(*small.lab().document()) == "four" &&
               !is_modified(*small.lab().document());
    }));
    CHECK(small.lab().document()->values().at("gain") == Value(4.0));
}

TEST_CASE("a preset may contain list items by label") {
    SmallLab small;
    small.write("gain.glsl", "uniform int gain = 1;  // @items \"One\" \"Two\" \"Three\"\n");
    REQUIRE(small.update_until([&] {
        const Parameter* gain = find_parameter(small.document().look(), "gain");
        return gain && gain->items.size() == 3;
    }));
    const auto file = small.folder() / "presets/small/third.json";
    std::filesystem::create_directories(file.parent_path());
    REQUIRE(write_atomically(file, R"({"format": "afterglow-preset", "version": 1,
        "look": "small", "name": "Third", "values": {"gain": "Three"}})"));
    small.lab().looks().open(file.string());
    REQUIRE(small.update_until([&] { return preset_name(small.document()) == "Third"; }));
    CHECK(small.document().values().at("gain") == Value(2.0));
}

TEST_CASE("a line of text transfers the values to another lab") {
    SmallLab from;
    from.lab().edit([](Document& document) { document.set_value("gain", Value(6.0)); });
    SmallLab to;
    to.lab().presets().sharing().paste(from.lab().presets().sharing().line());
    to.update(1);
    CHECK(to.shown() == 6 * to.frames());
    to.lab().edit([](Document& document) { document.undo(); });
    to.update(1);
    CHECK(to.shown() == to.frames());
    to.lab().presets().sharing().paste("afterglow:1:nonsense");
    CHECK(to.lab().messages().notice()->is_problem);
}
