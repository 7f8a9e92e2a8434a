#pragma once

#include "model/look/extent.h"
#include "ui/frame/edits.h"

#include <imgui/imgui.h>

#include <filesystem>
#include <string>

/// A part of the window, in its coordinates from the top left corner.
struct Rect {
    float left = 0.0f;
    float top = 0.0f;
    float width = 0.0f;
    float height = 0.0f;

    float right() const { return left + width; }
    float bottom() const { return top + height; }
    bool is_shown() const { return width > 0.0f && height > 0.0f; }
};

/// What ImGui calls a texture; it takes GL's name in a pointer's clothes.
ImTextureID texture_id(std::uintptr_t handle);

/// A pane of the window: drawn into until it ends.
class Pane {
public:
    Pane(const char* id, const Rect& place, const ImVec4& background, bool is_padded = true,
         bool scrolls = true);
    ~Pane();
    Pane(const Pane&) = delete;
    Pane& operator=(const Pane&) = delete;
};

void dim_text(const std::string& text);
/// As dim_text, over as many lines as it takes.
void wrapped_dim_text(const std::string& text);
/// As many lines as `width` takes; they end at blanks.
std::string wrapped(const std::string& text, float width);
/// Cut at the right with "…" where it does not fit `width`; the whole in a tooltip.
void fitted_text(const std::string& text, float width, const ImVec4& color);
std::string cut_to_fit(const std::string& text, float width);

/// Whether the last item has been hovered for a moment, with no button held.
bool is_lingered_on();
/// Shows a text, broken into lines, when the last item is hovered for a moment.
void tooltip(const std::string& text);
/// The same of a file that a click opens in the user's editor.
void editor_tooltip(const std::filesystem::path& file);

/// A quiet heading over a part of a pane.
void heading(const std::string& text);
/// The same with room for a small button at its end, which is drawn next.
void heading_with_button(const std::string& text);

/// A line that opens and closes what follows; leaves room for a small button at its end.
bool section(const std::string& label, bool opens_first);
/// Opens the section of that label that comes next.
void open_section(const std::string& label);

/// An arrowhead around `middle` that points down or to the right.
void draw_chevron(const ImVec2& middle, bool is_down, const ImVec4& color);

/// ImGui::BeginCombo with a quieter arrow.
bool begin_combo(const char* id, const std::string& present, float width);

/// A button with a text that stays quiet until hovered.
bool quiet_button(const std::string& label);

/// A choice among a few words, as buttons in a row, named "ID:WORD"; gives the one in force.
int choice(const char* id, const char* const* labels, int count, int chosen, Edits& edits);

/// Moves on along the line, to `x` from the pane's left edge.
void same_line_right(float width);

/// "1280 × 720".
std::string size_text(Extent extent);
