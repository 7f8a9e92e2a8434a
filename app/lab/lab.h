#pragma once

#include "lab/commands/content_commands.h"
#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/automation.h"
#include "lab/document/parameter_settings_store.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/frame/frame_loop.h"
#include "lab/frame/workspace.h"
#include "lab/jobs/background_jobs.h"
#include "lab/playback/audio_control.h"
#include "lab/reload/look_loader.h"
#include "lab/remote/remote_control.h"
#include "lab/sequencer/sequencer.h"

#include <functional>
#include <memory>

/// The open look and the components that process it. The window and the tests drive it with
/// update().
class Lab {
public:
    /// `worker` is a context for the worker thread that shares objects with `screen`; null: one is
    /// created after the first picture. `screen` is current here and must outlive the lab.
    Lab(Library library, const gpu::Context& screen, std::unique_ptr<gpu::Context> worker,
        std::unique_ptr<MidiInputs> midi = machine_midi_inputs());
    Lab(const Lab&) = delete;
    Lab& operator=(const Lab&) = delete;

    Workspace& work() { return m_work; }
    const Workspace& work() const { return m_work; }
    Messages& messages() { return m_work.messages; }
    const Messages& messages() const { return m_work.messages; }
    Player& player() { return m_work.player; }
    const Player& player() const { return m_work.player; }
    /// Null until a look has been built.
    Renderer* renderer() { return m_work.renderer.get(); }
    const Renderer* renderer() const { return m_work.renderer.get(); }
    /// Null until a look has been opened.
    const Document* document() const { return m_work.document ? &*m_work.document : nullptr; }
    /// Changes the document, if a look is open.
    void edit(const std::function<void(Document&)>& change);

    // Components.
    LookLoader& loader() { return m_loader; }
    const LookLoader& loader() const { return m_loader; }
    LookCommands& looks() { return m_looks; }
    const LookCommands& looks() const { return m_looks; }
    PresetCommands& presets() { return m_presets; }
    const PresetCommands& presets() const { return m_presets; }
    ContentCommands& content() { return m_content; }
    const ContentCommands& content() const { return m_content; }
    ParameterSettingsStore& parameters() { return m_parameters; }
    const ParameterSettingsStore& parameters() const { return m_parameters; }
    Automation& automation() { return m_automation; }
    const Automation& automation() const { return m_automation; }
    AudioControl& audio() { return m_audio; }
    const AudioControl& audio() const { return m_audio; }
    RemoteControl& remote() { return m_remote; }
    const RemoteControl& remote() const { return m_remote; }
    DrawingTool& drawing() { return m_drawing; }
    const DrawingTool& drawing() const { return m_drawing; }
    FrameLoop& frames() { return m_frames; }
    const FrameLoop& frames() const { return m_frames; }
    BackgroundJobs& jobs() { return m_jobs; }
    const BackgroundJobs& jobs() const { return m_jobs; }
    Sequencer& sequencer() { return m_sequencer; }
    const Sequencer& sequencer() const { return m_sequencer; }

    /// One iteration: reads changed files, takes built looks, applies edits, draws. `window` is for
    /// remote commands; null: without a window.
    void update(double wall_seconds, WindowState* window = nullptr);
    /// Whether the next update has work without any event.
    bool is_moving() const;

private:
    void update_loading(double wall_seconds);
    void update_drawing(double wall_seconds, double loading_seconds);
    void take(BuiltLook built);
    void open_document(BuiltLook& built);
    void open_values(const OpenRequest& request);
    void watch_extra_files();
    void file_changed(const std::filesystem::path& file);

    Workspace m_work;
    ParameterSettingsStore m_parameters{m_work.document, m_work.messages};
    Automation m_automation{m_work.document, m_work.messages};
    AudioControl m_audio{m_work.player, m_work.library.roots(), m_work.messages};
    RemoteControl m_remote;
    DrawingTool m_drawing{m_work.document, m_work.size, m_work.messages, m_work.opened_files};
    BackgroundJobs m_jobs{m_work.document, m_work.size, m_work.library.roots(), m_work.messages};
    LookLoader m_loader;  // destroyed before the renderer in m_work
    FrameLoop m_frames{m_work, m_loader, m_drawing.board()};
    ContentCommands m_content{m_work, m_drawing, m_frames.comparison()};
    LookCommands m_looks{m_work, m_loader, m_content};
    PresetCommands m_presets{m_work, m_loader, m_content};
    Sequencer m_sequencer{m_work, m_frames, m_presets.navigation(), m_remote};
};
