#pragma once

#include "lab/lab_parts.h"
#include "lab/messages/menu_entry.h"
#include "lab/window/window_state.h"
#include "model/look/value.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// Where a widget was drawn, in window coordinates from the top left corner.
struct WidgetRect {
    float left = 0.0f;
    float top = 0.0f;
    float right = 0.0f;
    float bottom = 0.0f;
};

/// The user's changes in the panels during one frame. They are applied after all panels are drawn.
class Edits {
public:
    /// Changes parts of the lab, which `edit` takes as references: [](Player& player) {...}. Does
    /// nothing if one of them is not there.
    template <class Edit>
    void change(Edit edit) {
        change_parts(std::function(std::move(edit)));
    }
    void arrange(std::function<void(WindowState&)> edit) { m_window.push_back(std::move(edit)); }
    void add(const MenuCommand& command);

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
    void copy(std::string text) { m_copied = std::move(text); }
    void quit() { m_is_quitting = true; }

    /// Records the position of the last widget under this name, for scripts that drive the window.
    void mark(const std::string& name);

    void apply(Lab& lab, WindowState& window) const;
    const std::optional<std::string>& copied() const { return m_copied; }
    bool is_quitting() const { return m_is_quitting; }
    /// Whether any edit of the lab was added.
    bool has_verbs() const { return !m_lab.empty(); }
    const std::map<std::string, WidgetRect>& widget_rects() const { return m_widget_rects; }

private:
    template <class... Parts>
    void change_parts(std::function<void(Parts&...)> edit) {
        m_lab.push_back([edit = std::move(edit)](Lab& lab) {
            const MutableParts all = mutable_parts(lab);
            if ((std::get<std::remove_const_t<Parts>*>(all) && ...))
                edit(*std::get<std::remove_const_t<Parts>*>(all)...);
        });
    }

    std::vector<std::function<void(Lab&)>> m_lab;
    std::vector<std::function<void(WindowState&)>> m_window;
    std::optional<std::string> m_copied;
    bool m_is_quitting = false;
    std::map<std::string, WidgetRect> m_widget_rects;
};
