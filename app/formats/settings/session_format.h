#pragma once

#include "base/diagnostic.h"
#include "model/plan/plan.h"
#include "model/preset/comparison.h"
#include "model/preset/content.h"
#include "model/preset/preset.h"
#include "model/preset/preset_stars.h"
#include "model/tuning/knob_settings.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// One state of a document, and the name of the step that led away from it.
struct SessionState {
    std::string step;
    Preset preset;  // values, signal and source
    PassOverrides overrides;
    ContentLocks locks = {};
    bool chose_content = false;  // the step: undo brings the content of this state back

    bool operator==(const SessionState&) const = default;
};

/// What was open when the program was last used, unsaved changes and undo included.
struct Session {
    std::string look;                          // folder or manifest; "": none was open
    std::map<std::string, std::string> looks;  // folder or manifest of each look of a stack, by id
    std::string preset_file;                   // "": none was open
    SessionState saved;  // as the preset's file holds it; its preset also says name and author
    SessionState current;
    std::vector<SessionState> past;    // oldest first
    std::vector<SessionState> future;  // the next redo last
    double time = 0.0;                 // s
    double speed = 1.0;
    double level = 1.0;
    bool is_playing = true;
    Comparison comparison;
    bool follows_view = false;
    Extent fixed_size;        // empty: to be chosen
    bool fits_shape = false;  // the picture is the largest of its shape within fixed_size
    double picture_scale = 1.0;
    std::string picture_shape;  // "": as the look has it; else "view", "source" or "whole pixels"
    LookKnobs knobs;            // what the person keeps about parameters, by look
    LookSlots slots;
    PresetStars preset_stars;
    std::map<std::string, double> window;  // what the window remembers of itself, by its own names

    bool operator==(const Session&) const = default;
};

std::string session_to_json(const Session& session);
Result<Session> parse_session(std::string_view text, const std::filesystem::path& file);
