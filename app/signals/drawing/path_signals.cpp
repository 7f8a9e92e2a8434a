// Signals that draw paths: a text, a scene file.
#include "signals/drawing/path_signals.h"

#include "signals/drawing/drawn_settings.h"
#include "signals/drawing/scene.h"
#include "signals/drawing/shapes.h"
#include "signals/drawing/stroke_font.h"
#include "signals/signal/points.h"
#include "signals/signal/settings.h"

#include <fmt/format.h>

namespace {
Result<std::unique_ptr<Signal>> signal_of(BeamScene scene, const Settings& settings,
                                          std::string_view what) {
    auto made =
        make_scene_signal(std::make_shared<const BeamScene>(std::move(scene)), rate_of(settings));
    if (!made)
        for (Diagnostic& reason : made.error())
            reason.message = fmt::format("{}: {}", what, reason.message);
    return made;
}

// Replaces "\n", as typed in a single-line field.
std::string with_line_ends(std::string_view text) {
    std::string lines;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_end = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == 'n';
        lines += is_end ? '\n' : text[i];
        i += is_end ? 1 : 0;
    }
    return lines;
}

Result<std::unique_ptr<Signal>> make_text(const Settings& settings, const SignalMedia&) {
    return signal_of(text_scene(settings), settings, "text");
}

Result<std::unique_ptr<Signal>> make_scene(const Settings& settings, const SignalMedia& media) {
    auto scene = file_scene(media, settings);
    return scene ? signal_of(std::move(*scene), settings, "scene") : fail(scene.error());
}
}  // namespace

BeamScene text_scene(const Settings& settings) {
    SceneItem item;
    item.paths = text_paths(with_line_ends(settings.word("text")), settings.number("size"),
                            TextAlign::middle);
    item.spin[1] = settings.number("spin");
    item.perspective = 3.0;
    return {.items = {std::move(item)}, .beam_speed = settings.number("beam_speed")};
}

Result<BeamScene> file_scene(const SignalMedia& media, const Settings& settings) {
    if (!media.scene)
        return fail({{},
                     0,
                     media.drawing ? "scene: expected a JSON scene or OBJ model, got an SVG. Use "
                                     "drawing:FILE instead."
                     : media.sound ? "scene: expected a JSON scene or OBJ model, got a sound. Use "
                                     "audio:FILE instead."
                                   : "scene: no scene to draw"});
    BeamScene scene = *media.scene;
    scene.beam_speed *= settings.number("speed");
    scene.move_speed *= settings.number("speed");
    return scene;
}

SignalKind text_kind() {
    return {.kind = "text",
            .label = "Text",
            .help = "Text in Afterglow's stroke font, drawn 60 times a second.",
            .settings = {{.key = "text",
                          .label = "Text",
                          .help = "The text to draw. \\n starts a new line.",
                          .type = SettingType::text,
                          .initial_word = "AFTERGLOW"},
                         size_setting(0.2, "Height of a capital letter."),
                         spin_setting(),
                         speed_setting(),
                         fit_setting(),
                         points_setting()},
            .bare_setting = "text",
            .make = make_text};
}

SignalKind scene_kind() {
    return {
        .kind = "scene",
        .label = "Scene",
        .help = "Shapes, text, drawings and wireframes from a JSON scene or an OBJ model.",
        .settings = {{.key = "file",
                      .label = "File",
                      .help = "A JSON scene (see docs/scenes.md) or an OBJ model.",
                      .type = SettingType::text},
                     {.key = "speed",
                      .label = "Speed",
                      .unit = "×",
                      .help = "Speed of the beam and of all movement, relative to the scene file.",
                      .low = 0.1,
                      .high = 10,
                      .initial = 1,
                      .logarithmic = true,
                      .limit = {0.001, 1000}},
                     fit_setting(),
                     points_setting()},
        .file_setting = "file",
        .bare_setting = "file",
        .make = make_scene};
}
