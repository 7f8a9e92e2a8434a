#pragma once

#include "model/look/look.h"
#include "model/picture/source_spec.h"
#include "model/preset/content.h"

#include <optional>
#include <string>

/// Whether a signal is the user's own: from a file, device or socket, a drawing or a text. What a
/// generator makes is not.
bool is_users_content(const Spec& signal);
/// The same of a source: any but a test pattern.
bool is_users_content(const std::string& source);

/// Whether both show the same file, device, drawing or text; how they show it may differ.
bool is_same_content(const Spec& one, const Spec& other);
bool is_same_content(const std::string& one, const std::string& other);

/// The signal with circles kept round, where it is the user's own, draws in x and y and says
/// nothing else; any other signal as it is.
Spec with_round_circles(Spec signal);
/// The source with its shape kept and its enlargement found, where it is the user's own and its
/// text says nothing else. In looks of other programs the picture has the source's shape anyway.
std::string with_users_defaults(const std::string& source, const Look& look);

/// How a signal asks to lie in the picture; none: as the look has it.
std::optional<Fit> beam_fit_of(const Spec& signal);

/// As a message names what drives a look: "song.wav", "Live sound", "HELLO", "SMPTE bars".
std::string content_name(const Content& content, const Look& look);

/// What is said where a look is not driven by what was chosen for it.
inline constexpr const char* needs_signal_look =
    "This look doesn't use a signal. Open a signal look (such as Phosphor) first.";
inline constexpr const char* needs_picture_look =
    "This look doesn't use a picture or video. Open a picture look (such as CRT) first.";

/// "Keep my signal" or "Keep my source", and the like for what the preset brings.
std::string keep_content_words(const Look& look);
std::string use_content_words(const Look& look);

/// Whether what drives the look is locked.
bool is_locked_in(const Look& look, const ContentLocks& locks);
