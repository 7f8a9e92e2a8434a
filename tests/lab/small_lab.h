#pragma once

#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "io/files/atomic_file.h"
#include "io/temporary_folder.h"
#include "lab/lab.h"

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

/// A look of two passes: the first adds `step_size` per frame, the second multiplies by `gain`.
namespace small_look {
inline constexpr const char* manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "Small", "driven_by": "nothing", "settle_frames": 20,
  "passes": [
    { "name": "sum", "fragment": "sum.frag", "format": "rgba32f", "inputs": { "previous": "sum@1" } },
    { "name": "show", "fragment": "show.frag", "format": "rgba32f", "inputs": { "image": "sum" } }
  ]
})";
inline constexpr const char* sum = R"(#version 410 core
uniform sampler2D previous;
uniform float step_size = 1.0;  // @range 0 4
in vec2 uv;
out vec4 color;
void main() { color = texture(previous, uv) + step_size; }
)";
inline constexpr const char* show = R"(#version 410 core
#include "gain.glsl"
uniform sampler2D image;
in vec2 uv;
out vec4 color;
void main() { color = texture(image, uv) * gain; }
)";
inline constexpr const char* gain = "uniform float gain = 1.0;  // @range 0 8\n";

}  // namespace small_look

/// A lab with a small look in its own temporary folder.
class SmallLab {
public:
    /// `manifest` may define other passes and another driver.
    explicit SmallLab(const std::string& manifest = small_look::manifest)
        : m_roots{m_folder.path(), m_folder / "user", m_folder / "state"} {
        write("look.json", manifest);
        write("sum.frag", small_look::sum);
        write("show.frag", small_look::show);
        write("gain.glsl", small_look::gain);
        auto context = gpu::create_headless_context();
        REQUIRE(context.has_value());
        m_context = std::move(*context);
        start();
        m_lab->looks().open("small");
        wait_for_frames();
    }
    SmallLab(const SmallLab&) = delete;
    SmallLab& operator=(const SmallLab&) = delete;
    ~SmallLab() { m_lab.reset(); }

    /// Restarts the lab like the program; no look is open.
    void start(std::unique_ptr<MidiInputs> midi = machine_midi_inputs(),
               ShippedFiles shipped = {}) {
        m_lab.reset();
        m_context->make_current();
        m_lab = std::make_unique<Lab>(Library(m_roots, std::move(shipped)), *m_context, nullptr,
                                      std::move(midi));
        m_lab->work().size.choose({false, {8, 8}, 1.0});
    }
    void wait_for_frames() {
        REQUIRE(update_until(
            [&] { return m_lab->renderer() && player().transport().frame_number() > 2; }));
    }

    Lab& lab() { return *m_lab; }
    Player& player() { return m_lab->player(); }
    const Document& document() const { return *m_lab->document(); }
    const Roots& roots() const { return m_roots; }
    std::filesystem::path folder() const { return m_folder.path(); }
    std::filesystem::path look_folder() const { return folder() / "shaders" / "small"; }
    /// Saves like an editor that writes in place.
    void write(const char* file, const std::string& text) {
        m_folder.write(look_folder() / file, text);
    }
    /// Saves like an editor that renames.
    void write_by_rename(const char* file, const std::string& text) {
        REQUIRE(write_atomically(look_folder() / file, text).has_value());
    }
    /// Returns false on timeout. The limit is for failing tests: in parallel with many others a
    /// test may take twenty times as long as alone.
    template <class Condition>
    bool update_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (std::chrono::steady_clock::now() < end) {
            m_lab->update(1.0 / 60.0);
            if (condition())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    void update(int count) {
        for (int i = 0; i < count; ++i)
            m_lab->update(1.0 / 60.0);
    }
    float shown() { return gpu::read_pixel(m_lab->renderer()->executor().target(1), 3, 3)[0]; }
    float frames() { return static_cast<float>(player().transport().frame_number()); }

private:
    TemporaryFolder m_folder;
    Roots m_roots;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
}
