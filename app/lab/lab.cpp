#include "lab/lab.h"

#include "base/elapsed.h"
#include "formats/preset/fitted_preset.h"
#include "formats/preset/preset_format.h"
#include "lab/commands/remote_commands.h"
#include "lab/document/content_edits.h"
#include "lab/document/opened_preset.h"
#include "lab/document/sharing.h"
#include "lab/document/users_content.h"
#include "lab/lab_parts.h"
#include "lab/offline/thumbnail.h"
#include "lab/session.h"

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

Lab::Lab(Library library, const gpu::Context& screen, std::unique_ptr<gpu::Context> worker,
         std::unique_ptr<MidiInputs> midi)
    : m_work(std::move(library)),
      m_remote(m_work.document, m_work.library.roots(), m_work.messages, std::move(midi),
               remote_commands()),
      m_loader(std::move(worker), screen, m_work.library.roots(), m_work.messages) {}

void Lab::edit(const std::function<void(Document&)>& change) {
    if (m_work.document)
        change(*m_work.document);
}

void Lab::update(double wall_seconds, WindowState* window) {
    const auto start = std::chrono::steady_clock::now();
    m_work.messages.update(wall_seconds);
    m_looks.packs().update();
    m_looks.passes().update();
    update_loading(wall_seconds);
    const double loading_seconds = seconds_since(start);
    m_remote.update(wall_seconds, mutable_parts(*this, window));
    m_work.size.update(wall_seconds);
    m_jobs.update();
    m_work.programs.update();
    m_work.sender.update(document(), m_frames.passes().switches(), m_work.size.extent(),
                         m_work.messages, wall_seconds);
    if (m_work.document && m_work.renderer)
        update_drawing(wall_seconds, loading_seconds);
}

void Lab::update_loading(double wall_seconds) {
    for (const fs::path& file : m_loader.take_changed_files())
        file_changed(file);
    const bool has_unfinished_frame = m_frames.has_unfinished_frame();
    m_loader.worker().builder().set_picture(m_work.size.extent());
    m_loader.set_displayed(m_frames.displayed());
    if (auto built = m_loader.update({m_work.size.extent(), has_unfinished_frame}, wall_seconds))
        take(std::move(*built));
    const bool has_drawn = !m_work.renderer || m_work.renderer->has_drawn();
    m_loader.note_update(!m_loader.is_loading() && !m_frames.has_unfinished_frame() && has_drawn);
}

void Lab::update_drawing(double wall_seconds, double loading_seconds) {
    m_presets.navigation().update(wall_seconds);
    m_sequencer.update(wall_seconds);
    m_drawing.follow();
    if (!m_frames.has_unfinished_frame())
        m_content.update();
    m_frames.update(wall_seconds, loading_seconds);
    m_automation.update(m_work.player.transport().time());
    m_audio.update();
    watch_extra_files();
}

bool Lab::is_moving() const {
    return m_loader.is_loading() || m_frames.is_moving() || m_presets.navigation().morphing() ||
           m_remote.is_busy() || m_jobs.is_running() || m_looks.packs().is_running() ||
           m_sequencer.is_busy() || m_work.sender.is_busy() || m_work.messages.is_counting();
}

void Lab::take(BuiltLook built) {
    if (built.kind != JobKind::look)
        return m_frames.replace_constants(std::move(built));
    m_sequencer.cues().look_changed();
    if (built.is_reload && m_work.document && m_work.renderer)
        m_frames.replace(built);
    else
        open_document(built);
    if (built.then)
        built.then();
}

void Lab::open_document(BuiltLook& built) {
    OpenDocument& document = m_work.document;
    const OpenRequest& request = built.request;
    const bool is_same = document && document->look().manifest == built.look->manifest;
    const bool had_changes = document && is_modified(*document);
    const bool loses_changes = had_changes && has_unlocked_changes(*document);
    const Content content = document ? content_of(*document) : m_content.initial();
    const bool keeps_time =
        document && !request.brings_content && is_locked_in(built.look->driven_by, content.locks);
    const Tempo tempo = document ? document->state().tempo : m_sequencer.initial_tempo();
    const CueText cues = document ? document->state().cues : m_sequencer.initial_cues();
    std::optional<Session> left;
    std::optional<Picture> left_picture;
    if (!is_same && had_changes) {
        left = session_of(*this, {});
        left_picture = small_copy(m_work.renderer.get());
    }
    if (is_same) {
        document->replace_look(std::move(*built.look));
    } else {
        m_parameters.store();
        document.emplace(std::move(*built.look));
        m_looks.passes().forget();
    }
    keep_content(*document, content);
    document->amend([&](DocumentState& state) {
        state.cues = cues;
        state.tempo = tempo;
    });
    remember_files(*document, m_work.media.recent());
    m_frames.open(built, {is_same, keeps_time});
    open_values(request);
    if (!is_same)
        m_parameters.load();
    if (!is_same && (!request.preset || !request.preset_file.empty()))
        forget_past(*document);
    m_presets.navigation().note_opened(request, is_same && loses_changes && !built.then);
    if (left)
        m_looks.stash_unsaved(*left, [&] { return left_picture; });
    if (request.preset)
        m_content.offer(with_checked_media(*request.preset, document->look(),
                                           media_folder(request.preset_file),
                                           m_work.media.recent()));
}

void Lab::open_values(const OpenRequest& request) {
    const auto content = request.brings_content ? OpenedContent::own : OpenedContent::locked;
    if (!request.preset) {
        open_defaults(*m_work.document, content);
        return;
    }
    const fs::path folder = media_folder(request.preset_file);
    CheckedPreset checked =
        with_checked_media(*request.preset, m_work.document->look(), folder, m_work.media.recent());
    Diagnostics warnings;  // values that do not fit become the nearest ones
    const Preset preset = fitted_preset(m_work.document->look(), std::move(checked.preset),
                                        request.preset_file, warnings);
    m_work.messages.add_look_problems(warnings);
    if (request.preset_file.empty()) {  // a line of text: stored nowhere yet
        opened_preset(*m_work.document).identity = preset;
        opened_preset(*m_work.document).file.clear();
        apply_preset(*m_work.document, preset, "Open preset");
    } else {
        open_preset(*m_work.document, preset, request.preset_file, content);
    }
    m_work.messages.add_look_problems(
        compare_with_look(*request.preset, m_work.document->look(), request.preset_file));
}

void Lab::watch_extra_files() {
    std::vector<fs::path> files = m_work.pictures.files();
    const auto add = [&files](const fs::path& file) {
        if (!file.empty())
            files.push_back(file);
    };
    add(m_frames.comparison().selection().reference().file());
    add(preset_file(*m_work.document));
    if (const fs::path file = driving_file(*m_work.document); file.is_absolute())
        add(file);
    for (const fs::path& file : m_sequencer.cues().files())
        add(file);
    if (std::error_code error; fs::exists(m_sequencer.playlist().file(), error))
        add(m_sequencer.playlist().file());
    m_loader.files().watch_extra(std::move(files));
}

void Lab::file_changed(const fs::path& file) {
    if (!m_work.document)
        return;
    if (file == preset_file(*m_work.document))
        m_presets.sharing().file_changed(file);
    m_sequencer.cues().file_changed(file);
    m_sequencer.playlist().file_changed(file);
    if (m_work.pictures.forget(file))
        m_frames.reapply();  // reads it again, and draws a paused picture again
    m_frames.comparison().file_changed(file);
    if (file == driving_file(*m_work.document))
        m_work.media.read_again(*m_work.document);
}
