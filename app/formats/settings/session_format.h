#pragma once

#include "base/diagnostic.h"
#include "model/plan/plan.h"
#include "model/preset/comparison.h"
#include "model/preset/content.h"
#include "model/preset/cue_text.h"
#include "model/preset/preset.h"
#include "model/preset/preset_stars.h"
#include "model/tuning/parameter_settings.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A state of a document, and the name of the step that followed it.
struct SessionState {
    std::string step;
    Preset preset;  // values, signal and source
    PassOverrides overrides;
    bool is_picture_driven = false;  // see StackPart
    ContentLocks locks = {};
    bool chose_content = false;  // the step changed the content, so undo restores the content of
                                 // this state

    CueText cues = {};
    std::size_t opened = 0;  // index in Session::opened of the preset that it is based on

    bool operator==(const SessionState&) const = default;
};

/// A preset that states of the session are based on.
struct SessionPreset {
    std::string file;    // "": none
    SessionState saved;  // as in the file; its preset also has name and author

    bool operator==(const SessionPreset&) const = default;
};

/// The open document at the end of the last session, with unsaved changes and undo.
struct Session {
    std::string look;                          // folder or manifest; "": none open
    std::map<std::string, std::string> looks;  // folder or manifest of each look of a stack, by id
    std::vector<SessionPreset> opened{1};      // never empty; the first one is that of `current`
    SessionState current;
    std::vector<SessionState> past;    // oldest first
    std::vector<SessionState> future;  // next redo last
    double time = 0.0;                 // s
    double speed = 1.0;
    double level = 1.0;
    bool is_playing = true;
    Comparison comparison;
    bool follows_view = false;
    Extent fixed_size;        // empty: automatic
    bool fits_shape = false;  // the largest picture with its aspect ratio within fixed_size
    double picture_scale = 1.0;
    std::string picture_shape;  // "": the look's default; otherwise "view", "source" or "whole
                                // pixels"
    LookParameterSettings parameter_settings;  // the user's settings for parameters, by look
    LookSlots slots;
    FavouritePresets preset_stars;
    std::map<std::string, double> window;  // state of the window, by the window's own names

    bool operator==(const Session&) const = default;
};

std::string session_to_json(const Session& session);
Result<Session> parse_session(std::string_view text, const std::filesystem::path& file);
