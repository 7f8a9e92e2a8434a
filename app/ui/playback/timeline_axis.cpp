#include "ui/playback/timeline_axis.h"

#include "lab/sequencer/sequencer.h"
#include "lab/sequencer/sound_region.h"
#include "signals/audio/sound_peaks.h"
#include "ui/playback/sound_controls.h"
#include "ui/playback/timeline_cues.h"
#include "ui/widgets/theme.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

double timeline_length(const Scene& scene) {
    const PlayedSignal& signal = scene.lab.player.signal();
    if (signal.sound().sound)
        return signal.sound().sound->seconds();
    constexpr double page = 60.0;  // s
    return page * (std::floor(scene.lab.player.transport().time() / page) + 1.0);
}

TimelineAxis timeline_axis(const ImVec2& low, const ImVec2& high, const Scene& scene) {
    const double length = timeline_length(scene);
    return {.mark = "",
            .low = low,
            .high = high,
            .ruler = std::round(ImGui::GetFontSize() * 1.15f),
            .cues = scene.lab.sequencer.cues().is_open() ? std::round(ImGui::GetFontSize() * 1.15f)
                                                         : 0.0f,
            .range = scene.window.views.timeline.visible(length),
            .length = length,
            .part = played_part(scene.lab.player.signal())};
}

namespace {
// "1:23", with decimals if the labels are closer than a second.
std::string time_label(double time, double step) {
    const double minutes = std::floor(time / 60.0 + 1e-9);
    const double seconds = std::max(time - minutes * 60.0, 0.0);
    const int decimals = step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
    return fmt::format("{:.0f}:{:0{}.{}f}", minutes, seconds, decimals > 0 ? decimals + 3 : 2,
                       decimals);
}

void draw_ruler(const TimelineAxis& axis, const Scene& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(scene.fonts.numbers);
    const float label = ImGui::CalcTextSize("00:00.000").x;
    const double step = label_step(axis.range.seconds(), axis.width() / label);
    const float bottom = axis.low.y + axis.ruler;
    const auto first = static_cast<long long>(std::ceil(axis.range.start / step - 1e-9));
    for (long long i = first; static_cast<double>(i) * step <= axis.range.end; ++i) {
        const double time = static_cast<double>(i) * step;
        const float x = std::floor(axis.x(time)) + 0.5f;
        const std::string text = time_label(time, step);
        list.AddLine({x, bottom - axis.ruler * 0.3f}, {x, bottom}, theme::packed(theme::faint));
        if (x + 3.0f + ImGui::CalcTextSize(text.c_str()).x < axis.high.x)
            list.AddText({x + 3.0f, axis.low.y}, theme::packed(theme::dim), text.c_str());
    }
    ImGui::PopFont();
}

// One bar per device pixel: the left channel above the right one.
void draw_channel(const TimelineAxis& axis, const SoundPeaks& peaks, std::size_t side,
                  float density) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = axis.low.y + axis.ruler;
    const float half =
        (axis.high.y - axis.cues - top) / static_cast<float>(SoundPeaks::side_count) * 0.5f;
    const float middle = top + half * (side == 0 ? 1.0f : 3.0f);
    const float bar = 1.0f / std::max(density, 1.0f);
    const auto count = static_cast<std::size_t>(std::max(axis.width() / bar, 1.0f));
    const auto columns = peaks.columns(side, axis.range.start, axis.range.end, count);
    const ImU32 inside = theme::packed(theme::label);
    const ImU32 outside = theme::packed(theme::filled);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float x = axis.low.x + bar * static_cast<float>(i);
        const double time = axis.time(x + bar * 0.5f);
        const bool is_played = !axis.part || (time >= axis.part->start && time < axis.part->end);
        const float high = std::clamp(columns[i].high, -1.0f, 1.0f) * (half - 1.0f);
        const float low = std::clamp(columns[i].low, -1.0f, 1.0f) * (half - 1.0f);
        list.AddRectFilled({x, middle - high - bar * 0.5f}, {x + bar, middle - low + bar * 0.5f},
                           is_played ? inside : outside);
    }
}

void draw_state_text(const TimelineAxis& axis, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float top = axis.low.y + axis.ruler;
    ImGui::GetWindowDrawList()->AddText({axis.low.x + (axis.width() - size.x) * 0.5f,
                                         top + (axis.high.y - axis.cues - top - size.y) * 0.5f},
                                        theme::packed(theme::dim), text.c_str());
}

void draw_sound(const TimelineAxis& axis, const Scene& scene) {
    const SoundOverview& overview = scene.lab.sequencer.overview();
    if (const SoundPeaks* peaks = overview.peaks()) {
        for (std::size_t side = 0; side < SoundPeaks::side_count; ++side)
            draw_channel(axis, *peaks, side, scene.density);
    } else if (overview.is_measuring()) {
        draw_state_text(axis, fmt::format("Reading waveform {:.0f} %", overview.share() * 100.0));
    }
}

// The region as a bar in the ruler with its two edges.
void draw_loop_region(const TimelineAxis& axis, double start, double end,
                      const theme::Color& color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float left = std::clamp(axis.x(std::min(start, end)), axis.low.x, axis.high.x);
    const float right = std::clamp(axis.x(std::max(start, end)), axis.low.x, axis.high.x);
    theme::Color filled = color;
    filled.alpha = 0.28f;
    list.AddRectFilled({left, axis.low.y}, {right, axis.low.y + axis.ruler}, theme::packed(filled));
    for (const double time : {start, end}) {
        const float x = axis.x(time);
        if (x >= axis.low.x - 1.0f && x <= axis.high.x + 1.0f)
            list.AddLine({x, axis.low.y}, {x, axis.high.y}, theme::packed(color), 2.0f);
    }
}

void draw_loop_regions(const TimelineAxis& axis, const Scene& scene) {
    const auto& drag = scene.window.views.timeline.drag;
    const double pointer = std::clamp(axis.time(ImGui::GetIO().MousePos.x), 0.0, axis.length);
    if (drag && drag->has_moved && axis.part) {
        if (drag->kind == TimelineDrag::Kind::region)
            return draw_loop_region(axis, drag->from, pointer, theme::accent);
        if (drag->kind == TimelineDrag::Kind::region_start)
            return draw_loop_region(axis, pointer, axis.part->end, theme::accent);
        if (drag->kind == TimelineDrag::Kind::region_end)
            return draw_loop_region(axis, axis.part->start, pointer, theme::accent);
    }
    if (has_region(scene.lab.player.signal()))
        draw_loop_region(axis, axis.part->start, axis.part->end, theme::accent);
}
}  // namespace

void draw_axis(const TimelineAxis& axis, const Scene& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(axis.low, axis.high, theme::packed(theme::field), rounding);
    list.PushClipRect(axis.low, axis.high, true);
    draw_ruler(axis, scene);
    draw_sound(axis, scene);
    draw_loop_regions(axis, scene);
    draw_cues(axis, scene);
    const float x = axis.x(axis.time_at(scene.lab.player.transport().time()));
    list.AddLine({x, axis.low.y}, {x, axis.high.y}, theme::packed(theme::text), 1.5f);
    list.PopClipRect();
    list.AddRect(axis.low, axis.high, theme::packed(theme::outline), rounding);
}
