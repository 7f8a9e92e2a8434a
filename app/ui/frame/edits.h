#pragma once

#include "lab/window/window_state.h"
#include "model/look/value.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

class Document;
class Lab;

/// Where a widget was drawn, in pixels of the window from its top left corner.
struct WidgetPlace {
    float left = 0.0f;
    float top = 0.0f;
    float right = 0.0f;
    float bottom = 0.0f;
};

/// What a person did to the panels of one frame; applied after all of them are drawn.
class Edits {
public:
    void add(std::function<void(Lab&)> edit) { m_lab.push_back(std::move(edit)); }
    void arrange(std::function<void(WindowState&)> edit) { m_window.push_back(std::move(edit)); }
    void document(std::function<void(Document&)> edit);

    /// Turns a parameter; all calls up to finish() are one step of undo.
    void set(const std::string& name, Value value);
    void finish();

    /// Ends the line that is being drawn by hand.
    void end_line();

    void show(Dialog dialog);
    /// Opens a look or preset; unsaved changes to another one are kept.
    void open(const std::string& argument);
    /// The same, with the preset's own signal or source where the user's is locked.
    void open_with_content(const std::string& argument);
    /// As open(), for any file: a sound becomes the signal.
    void open_file(const std::filesystem::path& file);
    /// To the clipboard of the desktop.
    void copy(std::string text) { m_copied = std::move(text); }
    void quit() { m_is_quitting = true; }

    /// Names the widget that was drawn last, for who drives the window from outside.
    void mark(const std::string& name);

    void apply(Lab& lab, WindowState& window) const;
    const std::optional<std::string>& copied() const { return m_copied; }
    bool is_quitting() const { return m_is_quitting; }
    /// Whether something was asked of the lab.
    bool has_verbs() const { return !m_lab.empty(); }
    const std::map<std::string, WidgetPlace>& places() const { return m_places; }

private:
    std::vector<std::function<void(Lab&)>> m_lab;
    std::vector<std::function<void(WindowState&)>> m_window;
    std::optional<std::string> m_copied;
    bool m_is_quitting = false;
    std::map<std::string, WidgetPlace> m_places;
};
