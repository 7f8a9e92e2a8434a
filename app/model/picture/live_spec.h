#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"

#include <optional>
#include <string>
#include <string_view>

/// The kinds of live sources.
enum class LiveKind {
    window,  // of another program
    screen,
    camera,
    pipe,  // video from another program
};

/// A part of a screen, px from its top left.
struct ScreenArea {
    int x = 0;
    int y = 0;
    Extent extent;

    bool operator==(const ScreenArea&) const = default;
};

/// The picture of a source that is live: "screen:,area=0x0+640+480,cursor=on".
struct LiveSpec {
    LiveKind kind = LiveKind::window;
    // window: its title, or a part of it. screen: an X display; "": that of $DISPLAY. camera: a
    // device. pipe: a named pipe; "": standard input.
    std::string name;
    std::optional<ScreenArea> area = std::nullopt;  // of a screen; nullopt: all of it
    bool has_cursor = false;                        // of a screen
    Extent size;  // of a camera, or of raw video; empty: the camera's own, or from the header
    std::string format;  // of raw video, as FFmpeg's pixel formats: "rgb24"; "": with a header

    bool operator==(const LiveSpec&) const = default;
};

/// Whether the picture of a source is live: begins with "window:", "screen:", "camera:" or "pipe:".
bool is_live(std::string_view picture);

/// Whether settings follow the name, so that each piece after a comma is one. A window's title may
/// contain commas.
bool has_live_settings(std::string_view picture);

/// Parses the picture of a source. Errors have no file.
Result<LiveSpec> parse_live(std::string_view picture);
