#pragma once

#include "lab/document/document.h"
#include "lab/messages/menu_entry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class WindowOverlay;

/// The window of another program that the source shows, as in "window:TITLE"; "": none.
std::string overlaid_window(const Document* document);

/// Why the picture can't be shown over the window of the source, and what the user can do.
struct OverlayRefusal {
    std::string text;
    std::vector<MenuEntry> buttons;
};
/// nullopt: it can be shown.
std::optional<OverlayRefusal> overlay_refusal(const Document* document);

/// Keeps a window of this program over the window that the source shows.
class SourceOverlay {
public:
    /// `window`: number of our hidden window on the X server. Errors have no file.
    static Result<SourceOverlay> open(std::uint64_t window, const std::string& title);
    SourceOverlay(SourceOverlay&& other) noexcept;
    SourceOverlay& operator=(SourceOverlay&& other) noexcept;
    ~SourceOverlay();

    /// As it was opened with.
    const std::string& title() const { return m_title; }

private:
    SourceOverlay(std::unique_ptr<WindowOverlay> overlay, std::string title);

    std::unique_ptr<WindowOverlay> m_overlay;
    std::string m_title;
};
