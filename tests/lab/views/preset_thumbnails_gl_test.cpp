// Small pictures of presets, drawn in the background and cached.
#include "formats/preset/preset_format.h"
#include "io/pictures/picture_file.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/small_lab.h"
#include "lab/views/preset_thumbnails.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <thread>

namespace {
// A look whose second pass shows `gain` / 100, as an 8-bit picture stores it.
class Painting : public SmallLab {
public:
    Painting() {
        write("show.frag",
              replaced(small_look::show, "texture(image, uv) * gain", "vec4(gain / 100.0)"));
        update_until([&] { return std::abs(shown() - 0.01f) < 1e-4f; });
    }
    std::filesystem::path preset(const char* name, double gain) {
        Preset preset;
        preset.look = "small";
        preset.name = name;
        preset.values = {{"gain", Value(gain)}};
        auto file = folder() / "presets" / "small" / (std::string(name) + ".json");
        REQUIRE(save_preset(file, preset).has_value());
        return file;
    }
    /// Updates until every picture is available. "": the look's defaults.
    void look_at(PresetThumbnails& pictures, const std::vector<std::filesystem::path>& files) {
        REQUIRE(update_until([&] {
            pictures.update(lab(), PresetThumbnails::Use::drawn, 1.0);
            return std::ranges::none_of(files,
                                        [&](const auto& file) { return pictures.of(file).is_due; });
        }));
    }
};

// A look that shows its source.
const std::string showing_a_source = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "picture",
  "default_source": "pattern:white", "source_encoding": "linear", "settle_frames": 1,
  "passes": [{ "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "source" } }]
})";

// Saves like an editor: another file replaces it.
void save_grey(const std::filesystem::path& file, float level) {
    const Picture grey{{4, 4}, 3, Encoding::linear, std::vector<float>(48, level)};
    REQUIRE(save_picture(grey, file).has_value());
}

// On its own thread, because each thread has one current context.
Result<Picture> painted(const SmallLab& small, const std::filesystem::path& file, int* drawn) {
    return std::async(std::launch::async,
                      [&] {
                          PresetThumbnailRenderer painter(small.document().look(),
                                                          Library(small.roots()));
                          auto picture = painter.paint(file, JobProgress{});
                          *drawn += painter.drawn();
                          return picture;
                      })
        .get();
}
}  // namespace

TEST_CASE("a preset's picture shows its values and is redrawn only after a change") {
    Painting small;
    const auto bright = small.preset("bright", 8.0);
    int drawn = 0;
    auto picture = painted(small, bright, &drawn);
    REQUIRE(picture.has_value());
    CHECK(picture->extent == Extent{240, 135});
    CHECK(picture->encoding == Encoding::display);
    // 0.08 is 20.4 of 255.
    CHECK(std::abs(picture->pixels[0] * 255.0f - 20.4f) <= 0.5f);
    CHECK(drawn == 1);
    picture = painted(small, bright, &drawn);
    REQUIRE(picture.has_value());
    CHECK(std::abs(picture->pixels[0] * 255.0f - 20.4f) <= 0.5f);
    CHECK(drawn == 1);  // from the cache
    small.preset("bright", 4.0);
    picture = painted(small, bright, &drawn);
    CHECK(std::abs(picture->pixels[0] * 255.0f - 10.2f) <= 0.5f);
    CHECK(drawn == 2);
    const auto plain = painted(small, {}, &drawn);
    CHECK(std::abs(plain->pixels[0] * 255.0f - 2.55f) <= 0.5f);
    CHECK(drawn == 3);
}

TEST_CASE("cached pictures are used, and damaged ones are drawn again") {
    Painting small;
    const auto bright = small.preset("bright", 8.0);
    int drawn = 0;
    REQUIRE(painted(small, bright, &drawn).has_value());
    const auto kept = small.roots().state / "preset-pictures";
    for (const auto& entry : std::filesystem::directory_iterator(kept))
        REQUIRE(write_atomically(entry.path(), "no picture").has_value());
    CHECK(painted(small, bright, &drawn).has_value());
    CHECK(drawn == 2);
    small.write("show.frag", replaced(small_look::show, "texture(image, uv) * gain",
                                      "vec4(gain / 50.0)"));  // the look was edited
    REQUIRE(small.update_until([&] { return std::abs(small.shown() - 0.02f) < 1e-4f; }));
    const auto picture = painted(small, bright, &drawn);
    CHECK(std::abs(picture->pixels[0] * 255.0f - 40.8f) <= 0.5f);
    CHECK(drawn == 3);
}

TEST_CASE("pictures are drawn only while displayed, and a broken preset reports its error") {
    Painting small;
    const auto bright = small.preset("bright", 8.0);
    const auto broken = small.folder() / "presets" / "small" / "broken.json";
    REQUIRE(write_atomically(broken, "{\n\"format\": 3 }").has_value());
    PresetThumbnails pictures;
    for (int update = 0; update < 3; ++update)
        pictures.update(small.lab(), PresetThumbnails::Use::hidden, 1.0);
    CHECK_FALSE(pictures.is_pending());
    CHECK(pictures.of(bright).is_due);
    small.look_at(pictures, {{}, bright, broken});
    CHECK(pictures.of({}).image.extent == Extent{240, 135});
    CHECK(pictures.of(bright).image.handle != 0);
    CHECK(pictures.of(broken).image.handle == 0);
    CHECK(pictures.of(broken).problem.starts_with("line 2: "));
    CHECK(pictures.drawn() == 2);

    const auto handle = pictures.of({}).image.handle;
    small.preset("broken", 2.0);  // repaired
    std::filesystem::last_write_time(
        broken, std::filesystem::last_write_time(broken) + std::chrono::seconds(2));
    pictures.update(small.lab(), PresetThumbnails::Use::drawn, 1.0);
    small.look_at(pictures, {{}, bright, broken});
    CHECK(pictures.of(broken).image.handle != 0);
    CHECK(pictures.of(broken).problem.empty());
    CHECK(pictures.of({}).image.handle == handle);  // the others are unchanged
    CHECK(pictures.drawn() == 3);
}

TEST_CASE("pictures of an edited look wait for a rest of two seconds") {
    Painting small;
    PresetThumbnails pictures;
    small.look_at(pictures, {{}});
    small.write("show.frag",
                replaced(small_look::show, "texture(image, uv) * gain", "vec4(gain / 50.0)"));
    REQUIRE(small.update_until([&] { return std::abs(small.shown() - 0.02f) < 1e-4f; }));
    pictures.update(small.lab(), PresetThumbnails::Use::drawn, 1.0);
    for (int update = 0; update < 40; ++update) {
        pictures.update(small.lab(), PresetThumbnails::Use::drawn, 0.02);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    CHECK(pictures.of({}).is_due);
    CHECK(pictures.drawn() == 1);
    small.look_at(pictures, {{}});
    CHECK(pictures.drawn() == 2);
}

TEST_CASE("a preset's picture follows the file that the preset references") {
    SmallLab small(showing_a_source);
    const auto grey = small.folder() / "presets" / "small" / "grey.exr";
    save_grey(grey, 0.08f);
    Preset preset;
    preset.look = "small";
    preset.name = "grey";
    preset.source = grey.string();
    const auto file = small.folder() / "presets" / "small" / "grey.json";
    REQUIRE(save_preset(file, preset).has_value());
    int drawn = 0;
    CHECK(std::abs(painted(small, file, &drawn)->pixels[0] * 255.0f - 20.4f) <= 0.5f);
    painted(small, file, &drawn);
    CHECK(drawn == 1);
    PresetThumbnails pictures;
    const auto look = [&] {
        REQUIRE(small.update_until([&] {
            pictures.update(small.lab(), PresetThumbnails::Use::drawn, 1.0);
            return !pictures.of(file).is_due && !pictures.of({}).is_due;
        }));
    };
    look();
    CHECK(pictures.drawn() == 1);  // the look's defaults
    save_grey(grey, 0.5f);
    std::filesystem::last_write_time(
        grey, std::filesystem::last_write_time(grey) + std::chrono::seconds(2));
    pictures.update(small.lab(), PresetThumbnails::Use::drawn, 1.0);
    CHECK(pictures.of(file).is_due);
    CHECK_FALSE(pictures.of({}).is_due);
    look();
    CHECK(pictures.drawn() == 2);
    CHECK(std::abs(painted(small, file, &drawn)->pixels[0] * 255.0f - 127.5f) <= 0.5f);
    CHECK(drawn == 1);  // from the cache
}
