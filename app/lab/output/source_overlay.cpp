#include "lab/output/source_overlay.h"

#include "io/capture/window_overlay.h"
#include "lab/export/export_target.h"
#include "lab/window/window_state.h"
#include "model/picture/source_spec.h"

#include <algorithm>
#include <cstdlib>

std::string overlaid_window(const Document* document) {
    if (!document || document->look().driven_by != Driver::picture)
        return {};
    const auto source = parse_source(document->state().source);
    if (!source || !source->is_live())
        return {};
    const auto live = parse_live(source->picture);
    return live && live->kind == LiveKind::window ? live->name : std::string();
}

namespace {
bool is_wayland() {
    const char* const display = std::getenv("WAYLAND_DISPLAY");
    return display && *display;
}

// Opens the export dialog with this target.
MenuEntry export_button(std::string label, const std::string& target) {
    return {.name = std::move(label),
            .commands = {[target](WindowState& window) {
                const auto& targets = export_targets();
                const auto found = std::ranges::find(targets, target, &ExportTarget::name);
                window.look_export.target = static_cast<std::size_t>(found - targets.begin());
                window.dialog = {.kind = Dialog::Kind::export_look};
            }}};
}
}  // namespace

std::optional<OverlayRefusal> overlay_refusal(const Document* document) {
    if (is_wayland())
        return OverlayRefusal{
            "A Wayland desktop does not let a program place its picture over another window. "
            "Export the look for a program that draws it itself.",
            {export_button("Export for ReShade…", "reshade"),
             export_button("Export for mpv…", "mpv")}};
    if (overlaid_window(document).empty())
        return OverlayRefusal{
            "The overlay needs a window as its source. Choose one with Show live source… in the "
            "panel Source.",
            {}};
    return std::nullopt;
}

SourceOverlay::SourceOverlay(std::unique_ptr<WindowOverlay> overlay, std::string title)
    : m_overlay(std::move(overlay)), m_title(std::move(title)) {}
SourceOverlay::SourceOverlay(SourceOverlay&& other) noexcept = default;
SourceOverlay& SourceOverlay::operator=(SourceOverlay&& other) noexcept = default;
SourceOverlay::~SourceOverlay() = default;

Result<SourceOverlay> SourceOverlay::open(std::uint64_t window, const std::string& title) {
    auto overlay = WindowOverlay::open(static_cast<std::uint32_t>(window), title);
    if (!overlay)
        return fail(overlay.error());
    return SourceOverlay(std::move(*overlay), title);
}
