#include "formats/look_format.h"
#include "gpu/headless_context.h"
#include "io/pictures/picture_file.h"
#include "lab/document/opened_preset.h"
#include "lab/lab_parts.h"
#include "lab/media/chosen_images.h"
#include "lab/small_lab.h"

#include <cmath>

namespace fs = std::filesystem;

namespace {
// Reads a picture that the user chooses, displayed by `show`.
constexpr const char* with_a_picker = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 1,
  "source_encoding": "linear",
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f" },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
const std::string picker = replaced(replaced(small_look::sum, "previous;", "picked;"),
                                    "texture(previous, uv) + step_size", "texture(picked, uv)");

// EXR stores the values exactly.
fs::path save_grey(const fs::path& file, float level) {
    const Picture grey{{4, 4}, 3, Encoding::linear, std::vector<float>(48, level)};
    REQUIRE(save_picture(grey, file).has_value());
    return file;
}

void pick(SmallLab& small, const fs::path& file) {
    small.lab().edit([&file](Document& document) {
        document.set_value("picked", Value::of_path(file.string()));
    });
}

// A small lab with a look that has a picture parameter.
struct PickerLab : SmallLab {
    PickerLab() {
        write("sum.frag", picker);
        write("look.json", with_a_picker);
        REQUIRE(update_until(
            [this] { return find_parameter(document().look(), "picked") && shown() == 0.0f; }));
    }
};
}  // namespace

TEST_CASE("a chosen picture is loaded only when it is chosen and when its file changes") {
    const TemporaryFolder folder;
    folder.write("shaders/small/look.json", with_a_picker);
    folder.write("shaders/small/sum.frag", picker);
    folder.write("shaders/small/show.frag", small_look::show);
    folder.write("shaders/small/gain.glsl", small_look::gain);
    const auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    const LoadedLook loaded = load_look(folder / "shaders/small", folder / "shaders/include");
    REQUIRE(loaded.look.has_value());
    auto programs = build_programs(*loaded.look);
    REQUIRE(programs.has_value());
    Executors executors(Executor(*loaded.look, std::move(*programs)));
    REQUIRE(executors.picture().resize({8, 8}, {8, 8}).has_value());
    ChosenImages images;
    const auto shown = [&](const fs::path& file) {
        const auto done = images.show(*loaded.look, {{"picked", Value::of_path(file.string())}},
                                      executors.picture());
        executors.draw({}, {});
        CHECK(done.has_value());
        return gpu::read_pixel(executors.picture().target(1), 3, 3)[0];
    };

    const fs::path file = save_grey(folder / "one.exr", 0.25f);
    const auto written = fs::last_write_time(file);
    CHECK(shown(file) == 0.25f);
    save_grey(file, 0.5f);
    fs::last_write_time(file, written);
    CHECK(shown(file) == 0.25f);  // same modification time, so it was not read
    fs::last_write_time(file, written + std::chrono::seconds(1));
    CHECK(shown(file) == 0.5f);
    CHECK(shown(save_grey(folder / "two.exr", 2.0f)) == 2.0f);
    CHECK(shown({}) == 0.0f);
    CHECK(images.files().empty());
}

TEST_CASE("a chosen picture that is overwritten is shown without an edit of the look") {
    PickerLab small;
    const fs::path file = save_grey(small.folder() / "picked.exr", 0.25f);
    pick(small, file);
    REQUIRE(small.update_until([&] { return small.shown() == 0.25f; }));
    save_grey(file, 3.0f);
    CHECK(small.update_until([&] { return small.shown() == 3.0f; }));
    small.lab().player().pause();
    small.update(2);
    save_grey(file, 0.125f);
    CHECK(small.update_until([&] { return small.shown() == 0.125f; }));
}

TEST_CASE("a new encoding of an image in look.json takes effect with the same file") {
    SmallLab small;
    // As PNG stores it: the sRGB curve maps 0.5 to ((0.5 + 0.055) / 1.055)^2.4 = 0.21404.
    const Picture half{{1, 1}, 3, Encoding::display, {0.5f, 0.5f, 0.5f}};
    REQUIRE(save_picture(half, small.look_folder() / "grain.png").has_value());
    const double stored = std::round(0.5 * 255.0) / 255.0;
    const double linear = std::pow((stored + 0.055) / 1.055, 2.4);
    std::string manifest =
        replaced(replaced(with_a_picker, R"("fragment": "sum.frag",)",
                          R"("fragment": "sum.frag", "inputs": { "picked": "grain" },)"),
                 R"("passes")", R"("images": { "grain": { "file": "grain.png" } }, "passes")");
    small.write("sum.frag", picker);
    small.write("look.json", manifest);
    const auto shows = [&small](double level) {
        return small.update_until([&] { return std::abs(small.shown() - level) < 1e-4; });
    };
    REQUIRE(shows(linear));
    small.write("look.json", replaced(manifest, R"("source_encoding": "linear")",
                                      R"("source_encoding": "display")"));
    CHECK(shows(stored));
}

TEST_CASE("the notice of a problem disappears with the problem") {
    PickerLab small;
    const fs::path file = small.folder() / "picked.exr";
    pick(small, file);
    small.update(1);
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->is_problem);
    REQUIRE(small.lab().messages().problems().size() == 1);
    CHECK(small.lab().messages().problems().front().diagnostic.file == file);

    SUBCASE("the file is created") {
        save_grey(file, 0.5f);
        REQUIRE(small.update_until([&] { return small.shown() == 0.5f; }));
    }
    SUBCASE("another file is chosen") {
        pick(small, save_grey(small.folder() / "other.exr", 0.5f));
        small.update(2);
    }
    SUBCASE("the choice is undone") {
        small.lab().edit([](Document& document) { document.undo(); });
        small.update(2);
    }
    CHECK(small.lab().messages().problems().empty());
    CHECK_FALSE(small.lab().messages().notice().has_value());
}

TEST_CASE("a newer notice stays when an earlier problem is fixed") {
    PickerLab small;
    pick(small, small.folder() / "picked.exr");
    small.update(1);
    small.lab().messages().say("Saved");
    small.lab().edit([](Document& document) { document.undo(); });
    small.update(2);
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->text == "Saved");
}

TEST_CASE("a preset that is broken and repaired on disk leaves no notice") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    small.lab().presets().save_as("bright");
    const fs::path file = preset_file(small.document());
    const std::string good = content_of(file);
    REQUIRE(write_atomically(file, "{ broken").has_value());
    REQUIRE(small.update_until([&] {
        return small.lab().messages().notice() && small.lab().messages().notice()->is_problem;
    }));
    REQUIRE(write_atomically(file, good).has_value());
    CHECK(small.update_until([&] { return !small.lab().messages().notice().has_value(); }));
    CHECK(small.document().values() == Values{{"gain", Value(2.0)}});
}

TEST_CASE("a sampler reads its default pattern, and again after a choice is removed") {
    const TemporaryFolder folder;
    const auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    folder.write("a.fs",
                 "/*{\"INPUTS\": [{\"NAME\": \"picked\", \"TYPE\": \"image\"}]}*/\n"
                 "void main() { gl_FragColor = IMG_THIS_PIXEL(picked); }\n");
    LoadedLook loaded = load_look(folder / "a.fs", {});
    REQUIRE(loaded.look.has_value());
    loaded.look->parameters[0].initial = Value::of_path("pattern:white");
    auto programs = build_programs(*loaded.look);
    REQUIRE(programs.has_value());
    Executors executors(Executor(*loaded.look, std::move(*programs)));
    REQUIRE(executors.picture().resize({8, 8}, {8, 8}).has_value());
    ChosenImages images;
    const auto shown = [&](const Values& values) {
        CHECK(images.show(*loaded.look, values, executors.picture()).has_value());
        executors.draw({1, {0.0, 1.0 / 60.0}}, {});
        return gpu::read_pixel(executors.picture().target(0), 4, 4)[0];
    };
    const std::string black = save_grey(folder / "black.exr", 0.0f).string();
    CHECK(shown({}) == 1.0f);
    CHECK(shown({{"picked", Value::of_path(black)}}) == 0.0f);
    CHECK(shown({}) == 1.0f);
    CHECK(shown({{"picked", Value::of_path("")}}) == 0.0f);
    CHECK(images.files().empty());
}

TEST_CASE("a picture chosen while a look is open is loaded in the background") {
    PickerLab small;
    pick(small, save_grey(small.folder() / "one.exr", 0.25f));
    const float frames = small.frames();
    small.update(1);
    CHECK(small.frames() == frames + 1.0f);
    CHECK(small.shown() == 0.0f);  // unchanged, because it takes effect at the start of an update
    CHECK(small.update_until([&] { return small.shown() == 0.25f; }));
}

TEST_CASE("of two pictures chosen in succession the second one stays") {
    PickerLab small;
    pick(small, save_grey(small.folder() / "one.exr", 0.25f));
    small.update(1);
    pick(small, save_grey(small.folder() / "two.exr", 0.5f));
    REQUIRE(small.update_until([&] { return small.shown() == 0.5f; }));
    for (int update = 0; update < 50; ++update) {
        small.update(1);
        CHECK(small.shown() == 0.5f);
    }
}

TEST_CASE("a chosen panorama becomes a cube map, and another shape is reported") {
    SmallLab small;
    small.write("../../elsewhere/room.fs",
                "/*{\"INPUTS\": [{\"NAME\": \"room\", \"TYPE\": \"cube\"}],"
                " \"PASSES\": [{\"FLOAT\": true}]}*/\n"
                "void main() { gl_FragColor = textureCube(room, vec3(-1.0, 0.5, 0.25)); }\n");
    small.lab().looks().open((small.folder() / "elsewhere/room.fs").string());
    REQUIRE(small.update_until([&] { return small.document().look().id == "room.fs"; }));
    const auto choose = [&small](const Picture& picture, const char* name) {
        const fs::path file = small.folder() / name;
        REQUIRE(save_picture(picture, file).has_value());
        small.lab().edit([&file](Document& document) {
            document.set_value("room", Value::of_path(file.string()));
        });
    };
    const auto red = [&small] {
        return gpu::read_pixel(small.lab().renderer()->executor().target(0), 3, 3)[0];
    };
    choose({{8, 4}, 1, Encoding::display, std::vector<float>(32, 1.0f)}, "white.png");
    CHECK(small.update_until([&] { return red() == 1.0f; }));
    choose({{5, 3}, 1, Encoding::display, std::vector<float>(15, 1.0f)}, "neither.png");
    CHECK(small.update_until([&] { return small.lab().messages().problems().size() == 1; }));
    CHECK(small.lab().messages().problems().front().diagnostic.file.filename() == "neither.png");
    CHECK(small.lab().messages().problems().front().diagnostic.message.starts_with(
        "can't be a cube map at 5 x 3 px."));
    CHECK(small.update_until([&] { return red() == 0.0f; }));
}

TEST_CASE("a picture outside a preset's folder needs the user's permission once") {
    PickerLab small;
    const fs::path outside = save_grey(small.folder() / "outside.exr", 0.5f);
    const fs::path preset = small.folder() / "user/presets/small/theirs.json";
    const auto open_with = [&](const std::string& file) {
        fs::create_directories(preset.parent_path());
        REQUIRE(write_atomically(preset, R"({"format": "afterglow-preset", "version": 1,
            "look": "small", "name": "theirs", "values": {"picked": ")" +
                                             file + "\"}}")
                    .has_value());
        small.lab().looks().open(preset.string());
        REQUIRE(small.update_until([&] { return preset_file(small.document()) == preset; }));
        small.update(3);
    };
    open_with(outside.string());
    CHECK(small.shown() == 0.0f);
    REQUIRE(small.lab().messages().notice().has_value());
    CHECK(small.lab().messages().notice()->text ==
          "The preset uses content outside its folder: file \"" + outside.string() +
              "\". It was not loaded.");
    const MenuEntry use = small.lab().messages().notice()->buttons.front();
    CHECK(use.name == "Use it");
    use.commands.front()(mutable_parts(small.lab(), nullptr));
    CHECK(small.update_until([&] { return small.shown() == 0.5f; }));
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return preset_file(small.document()).empty(); }));
    open_with(outside.string());
    CHECK(small.update_until([&] { return small.shown() == 0.5f; }));

    save_grey(preset.parent_path() / "beside.exr", 0.25f);
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return preset_file(small.document()).empty(); }));
    open_with("beside.exr");
    CHECK(small.update_until([&] { return small.shown() == 0.25f; }));
    CHECK_FALSE(is_modified(small.document()));
}
