#pragma once

#include "lab/messages/edit.h"
#include "lab/window/window_state.h"
#include "model/look/value.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Where a widget was drawn, in window coordinates from the top left corner.
struct WidgetRect {
    float left = 0.0f;
    float top = 0.0f;
    float right = 0.0f;
    float bottom = 0.0f;
};

/// What the panels ask of the window in one frame.
struct WindowRequests {
    std::optional<std::string> copied = {};  // text for the clipboard
    bool copies_picture = false;
    bool quits = false;
    bool shows_dialog = false;
};

/// The user's changes in the panels during one frame. They are applied after all panels are drawn.
class Edits {
public:
    void change(Edit edit) { m_edits.push_back(std::move(edit)); }
    /// Changes the window.
    void arrange(std::function<void(WindowState&)> edit) { m_edits.emplace_back(std::move(edit)); }

    /// Sets a parameter; all calls up to finish() are one undo step.
    void set(const std::string& name, Value value);
    void finish();

    void show(Dialog dialog);
    /// Opens a look or preset; unsaved changes to another one are kept.
    void open(const std::string& argument);
    /// As open(), but with the preset's signal or source even if the user's content is locked.
    void open_with_content(const std::string& argument);
    /// As open(), for any file: a sound becomes the signal.
    void open_file(const std::filesystem::path& file);
    /// Opens stored unsaved changes. Those of the open look are stored instead.
    void open_unsaved(const std::filesystem::path& stored);
    /// Copies the text to the clipboard.
    void copy(std::string text) { m_requests.copied = std::move(text); }
    /// Copies the displayed picture to the clipboard.
    void copy_picture() { m_requests.copies_picture = true; }
    void quit() { m_requests.quits = true; }
    /// Appends the edits of another list.
    void append(Edits other);

    /// Records the position of the last widget under this name, for scripts that drive the window.
    void mark(const std::string& name);
    void mark(const std::string& name, const WidgetRect& rect) { m_widget_rects[name] = rect; }

    void apply(Lab& lab, WindowState& window) const;
    const WindowRequests& requests() const { return m_requests; }
    /// Whether any edit changes more than the window.
    bool change_lab() const {
        return std::ranges::any_of(m_edits, std::not_fn(&Edit::changes_only_window));
    }
    const std::map<std::string, WidgetRect>& widget_rects() const { return m_widget_rects; }

private:
    std::vector<Edit> m_edits;
    WindowRequests m_requests;
    std::map<std::string, WidgetRect> m_widget_rects;
};
