// The signal of a drawing by the user: keyframes that morph into each other.
#include "signals/drawing/drawing.h"
#include "signals/drawing/drawn_paths.h"
#include "signals/drawing/drawn_settings.h"
#include "signals/drawing/keyframe_order.h"
#include "signals/drawing/line_morph.h"
#include "signals/drawing/path_signals.h"
#include "signals/drawing/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace {
ScenePath path_of(const std::vector<BeamPosition>& line) {
    ScenePath path;
    for (const BeamPosition& position : line)
        path.points.push_back({position[0], position[1]});
    return path;
}

/// The drawing as a function of time.
class MovingDrawing {
public:
    MovingDrawing(const Drawing& drawing, const Settings& settings)
        : m_order(order_in(settings, drawing.keyframes.size())), m_spin(settings.number("spin")) {
        m_beam.beam_speed = settings.number("beam_speed");
        m_beam.refresh = settings.number("refresh");
        for (std::size_t step = 0; step < m_order.steps(); ++step)
            m_steps.push_back(morphs_of(drawing.keyframes[m_order.begin_of(step)],
                                        drawing.keyframes[m_order.end_of(step)]));
    }

    BeamScene at(double seconds) const {
        const KeyframeOrder::Moment moment = m_order.at(seconds);
        return scene_of(m_steps[moment.step], moment.share);
    }

    /// An interpolated line is never longer than the longer of the two. The start and end of each
    /// step therefore give the maximum duration.
    double seconds() const {
        double longest = 1.0 / m_beam.refresh;
        for (const auto& morphs : m_steps)
            for (const double share : {0.0, 1.0})
                longest = std::max(longest, drawing_seconds(scene_of(morphs, share)));
        return longest;
    }

    /// Of the keyframes and the rotation.
    Repetition repetition() const {
        Repetition repetition;
        repetition.add(m_spin / 360.0);
        const double cycle =
            static_cast<double>(m_order.steps()) * (m_order.hold_seconds + m_order.morph_seconds);
        if (m_order.loops && cycle > 0.0)
            repetition.add(1.0 / cycle);
        return repetition;
    }

    DrawnSteps drawn() const {
        return {.steps = m_steps,
                .loops = m_order.loops,
                .hold_seconds = m_order.hold_seconds,
                .morph_seconds = m_order.morph_seconds,
                .is_eased = m_order.is_eased,
                .spin = m_spin,
                .beam_speed = m_beam.beam_speed,
                .refresh = m_beam.refresh};
    }

    std::size_t max_points() const {
        std::size_t maximum = 0;
        for (const auto& morphs : m_steps)
            maximum = std::max(maximum, point_count(scene_of(morphs, 0.0)));
        return maximum;
    }

private:
    static KeyframeOrder order_in(const Settings& settings, std::size_t count) {
        constexpr std::pair<std::string_view, KeyframePlay> plays[] = {
            {"loop", KeyframePlay::loop},
            {"pingpong", KeyframePlay::back_and_forth},
            {"once", KeyframePlay::once},
            {"still", KeyframePlay::still}};
        const auto play = std::find_if(std::begin(plays), std::end(plays), [&](const auto& one) {
            return settings.is("play", one.first);
        });
        const auto still_at = static_cast<std::size_t>(settings.whole("keyframe") - 1);
        KeyframeOrder order = order_of(play->second, count, still_at);
        order.hold_seconds = settings.number("hold");
        order.morph_seconds = settings.number("morph");
        order.is_eased = settings.is("ease", "smooth");
        return order;
    }

    BeamScene scene_of(const std::vector<LineMorph>& morphs, double share) const {
        BeamScene scene = m_beam;
        SceneItem& item = scene.items.emplace_back();
        for (const LineMorph& morph : morphs)
            if (!morph.from.empty())
                item.paths.push_back(path_of(morph.at(share)));
        item.spin[1] = m_spin;
        item.perspective = 3.0;
        return scene;
    }

    KeyframeOrder m_order;
    std::vector<std::vector<LineMorph>> m_steps;
    BeamScene m_beam;  // without items
    double m_spin;
};

Result<Drawing> drawing_in(const Settings& settings, const SignalMedia& media) {
    const std::string_view strokes = settings.word("strokes");
    const bool has_file = !settings.word("file").empty();
    if (has_file && !strokes.empty())
        return fail({{}, 0, "drawing: 'file' and 'strokes' can't be used together"});
    if (!strokes.empty()) {
        auto drawing = parse_drawing(strokes);
        if (!drawing)
            return fail(
                {{}, 0, fmt::format("drawing: strokes: {}", drawing.error().front().message)});
        return drawing;
    }
    if (media.sound)
        return fail({{}, 0, "drawing: expected an SVG file, got a sound. Use audio:FILE instead."});
    if (media.scene)
        return fail(
            {{},
             0,
             "drawing: expected an SVG file, got a scene or OBJ model. Use scene:FILE instead."});
    if (!media.drawing)
        return fail({{},
                     0,
                     has_file ? "drawing: nothing to draw"
                              : "drawing: expected a file, as in drawing:FILE.svg, or strokes"});
    return to_scale(*media.drawing, settings.number("size"));
}

Result<std::unique_ptr<Signal>> make_drawing(const Settings& settings, const SignalMedia& media) {
    const auto drawing = drawing_in(settings, media);
    if (!drawing)
        return fail(drawing.error());
    const MovingDrawing moving(*drawing, settings);
    if (moving.max_points() > max_scene_points)
        return fail({{},
                     0,
                     fmt::format("drawing: too many points ({}); the limit is {}",
                                 moving.max_points(), max_scene_points)});
    const double seconds = moving.seconds();
    return make_changing_scene_signal(
        {[moving](double time) { return moving.at(time); }, seconds, moving.repetition()},
        rate_of(settings));
}

std::vector<SettingInfo> keyframe_settings() {
    SettingInfo play = choice_setting(
        "play", "Play",
        "Order of the keyframes. loop: restarts after the last. pingpong: back and forth. once: "
        "stays at the last. still: shows one keyframe.",
        {"loop", "pingpong", "once", "still"});
    SettingInfo ease =
        choice_setting("ease", "Ease", "smooth: morphs start and end slowly. even: constant speed.",
                       {"smooth", "even"});
    const SettingCondition moves{"play", {"loop", "pingpong", "once"}};
    ease.condition = moves;
    return in_group("Keyframes", {},
                    {std::move(play),
                     {.key = "keyframe",
                      .label = "Keyframe",
                      .help = "Number of the keyframe to show, from 1.",
                      .low = 1,
                      .high = 10,
                      .step = 1,
                      .initial = 1,
                      .limit = {1, static_cast<double>(max_keyframes)},
                      .condition = {"play", {"still"}}},
                     {.key = "hold",
                      .label = "Hold",
                      .unit = "s",
                      .help = "How long each keyframe is held.",
                      .low = 0,
                      .high = 5,
                      .initial = 0.5,
                      .limit = {0, 3600},
                      .condition = moves},
                     {.key = "morph",
                      .label = "Morph",
                      .unit = "s",
                      .help = "How long the morph to the next keyframe takes.",
                      .low = 0,
                      .high = 5,
                      .initial = 1,
                      .limit = {0, 3600},
                      .condition = moves},
                     std::move(ease)});
}

std::vector<SettingInfo> beam_settings() {
    return in_group("Beam", {},
                    {spin_setting(),
                     speed_setting(),
                     {.key = "refresh",
                      .label = "Refresh rate",
                      .unit = "Hz",
                      .help = "Maximum rate of redrawing. Long drawings are redrawn less often.",
                      .low = 10,
                      .high = 240,
                      .initial = 60,
                      .limit = {1, 1000}},
                     points_setting()});
}

std::vector<SettingInfo> drawing_settings() {
    const SettingCondition has_file{"strokes", {""}};
    SettingInfo size =
        size_setting(1.6, "Length of the longer side, for SVG files from other programs.");
    size.condition = has_file;
    std::vector<SettingInfo> settings{
        {.key = "file",
         .label = "File",
         .help = "An SVG file. The beam follows its paths, lines and shapes.",
         .type = SettingType::text,
         .condition = has_file,
         .may_be_empty = true},
        std::move(size),
        fit_setting(),
        {.key = "strokes",
         .label = "Strokes",
         .help = "Strokes drawn by hand, instead of a file. See docs/signals.md.",
         .type = SettingType::text,
         .may_be_empty = true,
         .is_hidden = true}};
    for (const auto& part : {keyframe_settings(), beam_settings()})
        settings.insert(settings.end(), part.begin(), part.end());
    return settings;
}
}  // namespace

Result<DrawnSteps> drawing_steps(const SignalMedia& media, const Settings& settings) {
    const auto drawing = drawing_in(settings, media);
    return drawing ? Result<DrawnSteps>(MovingDrawing(*drawing, settings).drawn())
                   : fail(drawing.error());
}

SignalKind drawing_kind() {
    return {.kind = "drawing",
            .label = "Drawing",
            .help =
                "Your own drawing on the picture, or the lines of an SVG file. Keyframes morph "
                "into each other.",
            .settings = drawing_settings(),
            .file_setting = "file",
            .bare_setting = "file",
            .make = make_drawing};
}
