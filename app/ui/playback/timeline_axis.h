#pragma once

#include "lab/playback/sound_position.h"
#include "lab/window/timeline_view.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

#include <optional>

/// Where a timeline draws its times.
struct TimelineAxis {
    const char* mark = "";  // of its control
    ImVec2 low;             // top left
    ImVec2 high;            // bottom right
    float ruler = 0.0f;     // height
    float cues = 0.0f;      // height of the strip of cues at the bottom; 0: none
    TimelineRange range;
    double length = 0.0;             // s, of the sound, or of the axis without a sound
    std::optional<PlayedPart> part;  // of the sound; nullopt: no sound

    float width() const { return high.x - low.x; }
    float x(double time) const { return low.x + width() * static_cast<float>(range.share(time)); }
    double time(float x) const {
        return range.time(static_cast<double>((x - low.x) / std::max(width(), 1.0f)));
    }
    bool is_in_ruler(float y) const { return y <= low.y + ruler; }
    bool is_in_cues(float y) const { return cues > 0.0f && y >= high.y - cues; }
    /// The time of the clock at a time of the axis, and back.
    double clock_at(double time) const { return part ? part->time_at(time) : time; }
    double time_at(double clock) const { return part ? part->position_at(clock) : clock; }
};

/// The axis of the open look in this area.
TimelineAxis timeline_axis(const ImVec2& low, const ImVec2& high, const Scene& scene);
/// Its length in seconds: of the sound, otherwise enough for the current time.
double timeline_length(const Scene& scene);

/// Ruler, waveform, loop region and playing position.
void draw_axis(const TimelineAxis& axis, const Scene& scene);
