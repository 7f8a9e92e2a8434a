#pragma once

#include <cstddef>
#include <optional>
#include <string>

/// The visible part of a timeline, in seconds.
struct TimelineRange {
    double start = 0.0;
    double end = 0.0;

    bool operator==(const TimelineRange&) const = default;
    double seconds() const { return end - start; }
    /// The position of a time, 0 at the left and 1 at the right edge.
    double share(double time) const { return seconds() > 0.0 ? (time - start) / seconds() : 0.0; }
    double time(double share) const { return start + share * seconds(); }
};

/// What is dragged in the timeline.
struct TimelineDrag {
    enum class Kind { scrub, region, region_start, region_end, cue };
    Kind kind = Kind::scrub;
    double from = 0.0;     // time at the press
    std::size_t line = 0;  // of the cue
    bool has_moved = false;

    bool operator==(const TimelineDrag&) const = default;
};

/// A cue whose text is typed.
struct CueTyping {
    std::size_t line = 0;  // in the cue file, from 1; 0: a new cue
    std::string text = {};
    std::string timeline = {};  // the control that it was started in
    bool is_new = true;         // not drawn yet
    std::string problem = {};   // of the text that was last confirmed
    bool wants_focus = false;

    bool operator==(const CueTyping&) const = default;
};

/// What a timeline of `length` seconds displays, and the drag in it.
class TimelineView {
public:
    bool operator==(const TimelineView&) const = default;
    /// The visible range: all, unless it was zoomed.
    TimelineRange visible(double length) const;
    bool is_zoomed() const { return m_range.has_value(); }
    /// Zooms by a factor; the time at `share` of the width stays there. At most one sample per
    /// pixel of a usual screen, about 1 ms, is visible.
    void zoom(double length, double factor, double share);
    /// Moves the visible range by a share of its width.
    void pan(double length, double share);
    void show_all() { m_range.reset(); }
    void show(double length, const TimelineRange& range);
    /// Scrolls to the playing position when it leaves the visible range.
    void follow(double length, double position);

    std::optional<TimelineDrag> drag = {};
    std::optional<CueTyping> typing = {};
    bool is_hovered = false;  // or held: the arrow keys seek

private:
    std::optional<TimelineRange> m_range;  // nullopt: all
};

/// The distance of the labels of a time axis: 0.001 s to an hour, in steps of 1, 2, 5, 10, 15 or 30
/// units, with at most `count` labels in the range.
double label_step(double seconds, double count);
