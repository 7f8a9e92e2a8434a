#pragma once

#include "lab/files/folder_reader.h"
#include "lab/library/library_view.h"
#include "lab/rendering/pace.h"
#include "lab/views/list_thumbnails.h"
#include "lab/views/views.h"
#include "ui/actions/action_table.h"
#include "ui/frame/edits.h"
#include "ui/window/output_window.h"
#include "ui/window/toolkit.h"

/// Draws the panels and the output window, and keeps what they show up to date.
class PanelDisplay {
public:
    /// `state_file`: kept up to date with the displayed state, for tests; "": not written.
    PanelDisplay(gpu::Window& window, BuiltFonts fonts, Views views,
                 std::filesystem::path state_file);

    const Toolkit& toolkit() const { return m_toolkit; }
    OutputWindow& output() { return m_output; }
    LibraryView& library() { return m_library; }
    Pace& pace() { return m_pace; }
    /// Whether some results are still pending. On a slow machine they take long.
    bool is_pending(const Lab& lab) const;

    /// Prepares the panels while the first picture is still being loaded.
    void make_ready(const Lab& lab, const WindowState& state, double wall_seconds);
    void update(Lab& lab, WindowState& state, double wall_seconds);
    /// Draws the n-th frame of the panels. Returns the user's edits.
    Edits draw(Lab& lab, const WindowState& state, long frame_number);

private:
    void list_looks(const Lab& lab, double wall_seconds);

    gpu::Window& m_window;
    Toolkit m_toolkit;
    ActionTable m_actions = make_action_table();
    OutputWindow m_output;
    Views m_views;
    ListThumbnails m_pictures{
        {}, PresetThumbnails(gpu::WindowEvents::wake), {}, LookThumbnails(gpu::WindowEvents::wake)};
    LibraryView m_library;
    FolderReader m_folders;
    Pace m_pace;
    std::filesystem::path m_state_file;
    std::string m_state_text;
};
