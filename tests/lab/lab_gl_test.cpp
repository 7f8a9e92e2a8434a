#include "gpu/readback.h"
#include "io/atomic_file.h"
#include "lab/lab.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace fs = std::filesystem;

namespace {
constexpr const char* manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
constexpr const char* sum = R"(#version 410 core
uniform sampler2D previous;
uniform float step_size = 1.0;  // @range 0 4
in vec2 uv;
out vec4 color;
void main() { color = texture(previous, uv) + step_size; }
)";
constexpr const char* show = R"(#version 410 core
#include "gain.glsl"
uniform sampler2D image;
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv) * gain; }
)";
constexpr const char* gain = "uniform float gain = 1.0;  // @range 0 8\n";

/// A lab on a small look that counts frames, in a folder of its own.
class SmallLab {
public:
    SmallLab() {
        std::string name = (fs::temp_directory_path() / "afterglow-lab-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        fs::create_directories(look_folder());
        write("look.json", manifest);
        write("sum.frag", sum);
        write("show.frag", show);
        write("gain.glsl", gain);
        auto context = gpu::Context::headless();
        REQUIRE(context.has_value());
        m_context = std::move(*context);
        auto worker = gpu::Context::shared_with(*m_context);
        REQUIRE(worker.has_value());
        m_lab = std::make_unique<Lab>(Library({m_folder, m_folder / "user", m_folder / "state"}),
                                      std::move(*worker));
        m_lab->set_picture_size({false, {8, 8}, 1.0});
        m_lab->open("small");
        REQUIRE(
            turn_until([&] { return m_lab->renderer() && m_lab->player().frame_number() > 2; }));
    }
    ~SmallLab() {
        m_lab.reset();
        m_context.reset();
        fs::remove_all(m_folder);
    }

    Lab& lab() { return *m_lab; }
    fs::path look_folder() const { return m_folder / "shaders" / "small"; }
    /// Saves as an editor that writes in place.
    void write(const char* file, const std::string& text) {
        std::ofstream(look_folder() / file) << text;
    }
    /// Saves as an editor that renames.
    void write_by_rename(const char* file, const std::string& text) {
        REQUIRE(write_atomically(look_folder() / file, text).has_value());
    }

    template <class Condition>
    bool turn_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (std::chrono::steady_clock::now() < end) {
            m_lab->update(1.0 / 60.0);
            if (condition())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    void turn(int count) {
        for (int i = 0; i < count; ++i)
            m_lab->update(1.0 / 60.0);
    }
    float shown() { return gpu::read_pixel(m_lab->renderer()->executor().target(1), 3, 3)[0]; }
    float frames() { return static_cast<float>(m_lab->player().frame_number()); }

private:
    fs::path m_folder;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
}
}  // namespace

TEST_CASE("an open look counts every frame of the clock") {
    SmallLab small;
    CHECK(small.shown() == small.frames());
    small.turn(5);
    CHECK(small.shown() == small.frames());
}

TEST_CASE("an edited shader shows, and values, clock and history survive") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    small.turn(1);
    CHECK(small.shown() == 2 * small.frames());
    const auto before = small.frames();
    SUBCASE("saved in place") {
        small.write("show.frag", replaced(show, "* gain", "* gain * 4.0"));
    }
    SUBCASE("saved by rename") {
        small.write_by_rename("show.frag", replaced(show, "* gain", "* gain * 4.0"));
    }
    REQUIRE(small.turn_until([&] { return small.shown() == 8 * small.frames(); }));
    CHECK(small.frames() > before);
    CHECK(small.lab().problems().empty());
}

TEST_CASE("an edited include shows") {
    SmallLab small;
    small.write_by_rename("gain.glsl", "uniform float gain = 3.0;  // @range 0 8\n");
    CHECK(small.turn_until([&] { return small.shown() == 3 * small.frames(); }));
}

TEST_CASE("a pass that is added shows, and the others keep their history") {
    SmallLab small;
    const std::string third = replaced(manifest, R"("inputs": { "image": "sum" } })",
                                       R"("inputs": { "image": "sum" } },
    { "name": "third", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "show" } })");
    small.write_by_rename("look.json", third);
    REQUIRE(small.turn_until([&] { return small.lab().document()->look().passes.size() == 3; }));
    small.turn(1);
    CHECK(small.shown() == small.frames());
}

TEST_CASE(
    "a mistake keeps the last good picture and names file, line and source; mending clears it") {
    SmallLab small;
    small.write_by_rename("show.frag", replaced(show, "* gain", "* gian"));
    REQUIRE(small.turn_until([&] { return !small.lab().problems().empty(); }));
    const Problem problem = small.lab().problems().front();
    CHECK(problem.diagnostic.file.filename() == "show.frag");
    CHECK(problem.diagnostic.line == 6);
    CHECK(problem.source_line.find("gian") != std::string::npos);
    small.turn(3);
    CHECK(small.shown() == small.frames());

    small.write_by_rename("show.frag", show);
    CHECK(small.turn_until([&] { return small.lab().problems().empty(); }));
}

TEST_CASE("a uniform renamed with @was keeps its value") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(5.0)); });
    small.turn(1);
    small.write_by_rename("show.frag", replaced(show, "* gain", "* strength"));
    small.write_by_rename("gain.glsl", "uniform float strength = 1.0;  // @range 0 8 @was gain\n");
    REQUIRE(small.turn_until(
        [&] { return find_parameter(small.lab().document()->look(), "strength") != nullptr; }));
    small.turn(1);
    CHECK(small.lab().document()->values() == Values{{"strength", Value(5.0)}});
    CHECK(small.shown() == 5 * small.frames());
}

TEST_CASE("while paused a turned knob shows, also through the frames that led here") {
    SmallLab small;
    small.turn(10);
    small.lab().transport().pause();
    small.turn(1);
    const float frames = small.frames();
    CHECK_FALSE(small.lab().is_moving());

    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    small.turn(1);
    CHECK(small.shown() == 2 * frames);
    CHECK(small.frames() == frames);

    small.lab().edit([](Document& document) { document.set_value("step_size", Value(3.0)); });
    REQUIRE(small.turn_until([&] { return !small.lab().is_moving(); }));
    CHECK(small.shown() == 2 * 3 * std::min(frames, 20.0f));  // the look settles in 20 frames
    CHECK(small.frames() == frames);
}

TEST_CASE("a replay can be cancelled") {
    SmallLab small;
    small.turn(30);
    small.lab().transport().pause();
    small.lab().edit([](Document& document) { document.set_value("step_size", Value(2.0)); });
    small.lab().cancel_replay();
    CHECK(small.turn_until([&] { return !small.lab().is_moving(); }));
}

TEST_CASE("restart begins at the first frame with no history") {
    SmallLab small;
    small.turn(10);
    small.lab().restart();
    small.turn(1);
    CHECK(small.frames() == 1);
    CHECK(small.shown() == 1);
}

TEST_CASE("a preset that is saved, changed and opened again is back as it was") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(4.0)); });
    small.lab().save_preset_as("four");
    CHECK_FALSE(small.lab().document()->is_modified());
    small.lab().edit([](Document& document) { document.set_value("gain", Value(1.5)); });
    CHECK(small.lab().document()->is_modified());
    const auto preset = small.lab().library().find_preset("small", "four");
    REQUIRE(preset.has_value());
    small.lab().open(preset->file.string());
    REQUIRE(small.turn_until([&] {
        return !small.lab().is_loading() && small.lab().document()->preset_name() == "four" &&
               !small.lab().document()->is_modified();
    }));
    CHECK(small.lab().document()->values().at("gain") == Value(4.0));
}

TEST_CASE("a line of text carries the values to another lab") {
    SmallLab from;
    from.lab().edit([](Document& document) { document.set_value("gain", Value(6.0)); });
    SmallLab to;
    to.lab().paste(from.lab().share_line());
    to.turn(1);
    CHECK(to.shown() == 6 * to.frames());
    to.lab().edit([](Document& document) { document.undo(); });
    to.turn(1);
    CHECK(to.shown() == to.frames());
    to.lab().paste("afterglow:1:nonsense");
    CHECK(to.lab().notice()->is_problem);
}
