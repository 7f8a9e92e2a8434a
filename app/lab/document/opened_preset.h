#pragma once

#include "lab/document/document.h"

#include <filesystem>
#include <string>

/// The file of the open preset. "" if looks were added, removed or reordered since it was opened.
const std::filesystem::path& preset_file(const Document& document);
const std::string& preset_name(const Document& document);
/// The presets of the history that were opened from this file.
std::vector<OpenedPreset*> presets_from_file(Document& document, const std::filesystem::path& file);
/// Locked content does not count as a change.
bool is_modified(const Document& document);
/// Like is_modified(), but ignores locked values, because they stay when a preset is opened.
bool has_unlocked_changes(const Document& document);

/// The current state as a preset: only changed values, or for sharing all values.
Preset preset_of(const Document& document);
Preset complete_preset_of(const Document& document);

/// Sets the values and signal of a preset or its text, as one undo step. The open preset stays.
void apply_preset(Document& document, const Preset& preset, const std::string& step_name);

/// Makes this preset the one that the current state is based on, without an undo step.
void base_on(Document& document, OpenedPreset preset);

/// Which signal or source a preset opens with while the user's is locked.
enum class OpenedContent { locked, own };
/// Opens a preset of this look: the state becomes the preset's and counts as saved. One undo step,
/// which restores the previous values and preset.
void open_preset(Document& document, const Preset& preset, std::filesystem::path file,
                 OpenedContent content = OpenedContent::locked);
/// The same with all parameters at their defaults and without a preset.
void open_defaults(Document& document, OpenedContent content = OpenedContent::locked);
/// The same as the end of the gesture with this name, within its undo step. `file` "": the
/// defaults.
void finish_morph(Document& document, const Preset& preset, std::filesystem::path file,
                  const std::string& gesture);
