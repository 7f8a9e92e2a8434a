#pragma once

#include "model/look/extent.h"
#include "ui/frame/edits.h"
#include "ui/widgets/rect.h"

#include <imgui/imgui.h>

#include <filesystem>
#include <string>
#include <string_view>

/// ImGui's texture handle: the GL name, stored as a pointer.
ImTextureID texture_id(std::uintptr_t handle);

/// An area of the window to draw into during its lifetime.
class Pane {
public:
    Pane(const char* id, const Rect& rect, const ImVec4& background, bool is_padded = true,
         bool scrolls = true);
    ~Pane();
    Pane(const Pane&) = delete;
    Pane& operator=(const Pane&) = delete;
};

void dim_text(const std::string& text);
/// As dim_text, wrapped into lines.
void wrapped_dim_text(const std::string& text);
/// Wraps the text at blanks to `width`.
std::string wrapped(const std::string& text, float width);
/// Cuts the text with "…" if it does not fit `width`; the tooltip has the whole text.
void fitted_text(const std::string& text, float width, const ImVec4& color);
/// A file name as the label of a menu item: printable, and not cut at "##", where ImGui cuts
/// labels.
std::string menu_label(std::string_view name);
std::string elided_to_width(const std::string& text, float width);

/// Whether the last item has been hovered for a moment without a pressed button.
bool is_hover_delayed();
/// Shows a wrapped text when the last item is hovered for a moment.
void tooltip(const std::string& text);
/// ImGui::BeginTooltip for the last item, beside its pane. `size`: of the contents; zero: of the
/// tooltip in the previous frame.
void begin_tooltip(const ImVec2& size = {});
/// In this frame and the next, tooltips end above this y, so that they cover nothing below it.
void keep_tooltips_above(float y);
/// A tooltip for a file that opens in the user's editor on click.
void editor_tooltip(const std::filesystem::path& file);

/// The heading of a section.
void heading(const std::string& text);
/// As heading(), with space for a small button, which is drawn next.
void heading_with_button(const std::string& text);

/// A collapsible header with space for small buttons at its end.
bool section(const std::string& label, bool opens_first, int buttons = 1);
/// Opens the next section with this label.
void open_section(const std::string& label);

/// An arrowhead centred at `middle`, pointing down or right.
void draw_chevron(const ImVec2& middle, bool is_down, const ImVec4& color);

/// Call it after each item of an open list. The chosen item gets the focus when the list opens, and
/// the first item that starts with the typed letters.
void focus_list_item(std::string_view label, bool is_chosen);
/// ImGui::BeginCombo with a less prominent arrow. Letters select an item, see focus_list_item().
bool begin_combo(const char* id, const std::string& current, float width);

/// A text button without a background until it is hovered.
bool quiet_button(const std::string& label);

/// A choice as a row of buttons with marks "ID:WORD"; returns the chosen index.
int choice(const char* id, const char* const* labels, int count, int chosen, Edits& edits);

/// Continues the line with an item of this width at the right end.
void same_line_right(float width);

/// "1280 × 720".
std::string size_text(Extent extent);
