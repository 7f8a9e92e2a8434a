#pragma once

#include "model/look/look.h"
#include "model/picture/source_spec.h"
#include "model/preset/content.h"

#include <optional>
#include <string>

/// Whether a signal is the user's own content: a file, device, socket, drawing or text. Generated
/// signals are not.
bool is_users_content(const Spec& signal);
/// Whether a source is the user's own content: all except test patterns.
bool is_users_content(const std::string& source);

/// Whether both have the same file, device, drawing or text. Other settings may differ.
bool is_same_content(const Spec& one, const Spec& other);
bool is_same_content(const std::string& one, const std::string& other);

/// Sets "keep circles round" on user content that is drawn in x and y and has no `fit` yet. Other
/// signals are returned unchanged.
Spec with_round_circles(Spec signal);
/// Sets default fit and prescale detection for the user's own source, unless its text sets them.
/// Native looks keep its aspect ratio; foreign looks stretch it, because they use it anyway.
std::string with_users_defaults(const std::string& source, const Look& look);

/// The fit that the signal sets; nullopt: the look's own.
std::optional<Fit> beam_fit_of(const Spec& signal);

/// The display name of the content: "song.wav", "Live sound", "HELLO", "SMPTE bars".
std::string content_name(const Content& content, Driver driver);

/// Messages for content that the look does not use.
inline constexpr const char* needs_signal_look =
    "This look doesn't use a signal. Open a signal look (such as Phosphor) first.";
inline constexpr const char* needs_picture_look =
    "This look doesn't use a picture or video. Open a picture look (such as CRT) first.";

/// Labels: "Keep my signal" or "Keep my source"; "Use the preset's signal" or "... source".
std::string keep_content_label(Driver driver);
std::string use_content_label(Driver driver);

/// Whether the content that this look uses is locked.
bool is_locked_in(Driver driver, const ContentLocks& locks);
