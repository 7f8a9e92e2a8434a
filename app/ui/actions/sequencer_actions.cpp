#include "ui/actions/sequencer_actions.h"

#include "lab/document/opened_preset.h"
#include "lab/sequencer/sequencer.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/playback/timeline_axis.h"

namespace {
void tap_tempo(const Scene&, Edits& edits) {
    edits.change(
        [now = MidiClockInput::now()](Sequencer& sequencer) { sequencer.tempo().tap(now); });
}

void set_downbeat(const Scene&, Edits& edits) {
    edits.change([](Sequencer& sequencer) { sequencer.tempo().set_downbeat(); });
}

bool plays_playlist(const Scene& scene) {
    return scene.lab.sequencer.playlist().is_playing();
}

void play_playlist(const Scene& scene, Edits& edits) {
    edits.change([starts = !plays_playlist(scene)](Sequencer& sequencer) {
        sequencer.playlist().set_playing(starts);
    });
}

template <int by>
void step_playlist(const Scene&, Edits& edits) {
    edits.change([](Sequencer& sequencer) { sequencer.playlist().step(by); });
}

bool has_cues(const Scene& scene) {
    return scene.lab.sequencer.cues().is_open();
}

bool plays_cues(const Scene& scene) {
    return has_cues(scene) && scene.lab.sequencer.cues().is_playing();
}

void open_cues(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::open_cues});
}

void save_cues_as(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::save_cues});
}

void save_cues(const Scene& scene, Edits& edits) {
    if (scene.lab.document->state().cues.file.empty())
        return save_cues_as(scene, edits);
    edits.change([](Sequencer& sequencer) { sequencer.cues().save(); });
}

bool can_save_cues(const Scene& scene) {
    return scene.lab.sequencer.cues().has_changes();
}

void close_cues(const Scene&, Edits& edits) {
    edits.change([](Sequencer& sequencer) { sequencer.cues().close(); });
}

void play_cues(const Scene& scene, Edits& edits) {
    edits.change([starts = !plays_cues(scene)](Sequencer& sequencer) {
        sequencer.cues().set_playing(starts);
    });
}

// Of the open preset, at the playing position.
void add_preset_cue(const Scene& scene, Edits& edits) {
    const TimelineAxis axis = timeline_axis({}, {}, scene);
    const Cue cue{.seconds = axis.time_at(scene.lab.player.transport().time()),
                  .command = Cue::Command::preset,
                  .name = scene.lab.sequencer.cues().open_preset()};
    edits.change([cue](Sequencer& sequencer) { sequencer.cues().add(cue); });
}

bool has_preset(const Scene& scene) {
    return scene.lab.document && !preset_file(*scene.lab.document).empty();
}

Action row(ActionId id, const char* label, void (*act)(const Scene&, Edits&),
           bool (*is_enabled)(const Scene&), bool is_first = false) {
    return {id, Menu::playback, label, {}, is_first, act, is_enabled};
}
}  // namespace

std::vector<Action> sequencer_actions::list() {
    Action tap = row(ActionId::tap_tempo, "Tap tempo", tap_tempo, file_actions::has_document, true);
    tap.chord = {'T'};
    Action downbeat =
        row(ActionId::set_downbeat, "Set downbeat", set_downbeat, file_actions::has_document);
    downbeat.chord = {'T', true, true};
    Action playlist = row(ActionId::play_playlist, "Play playlist", play_playlist,
                          file_actions::has_document, true);
    playlist.is_on = plays_playlist;
    Action cues = row(ActionId::play_cues, "Play cues", play_cues, has_cues);
    cues.is_on = plays_cues;
    return {tap,
            downbeat,
            playlist,
            row(ActionId::playlist_next, "Next in playlist", step_playlist<1>,
                file_actions::has_document),
            row(ActionId::playlist_previous, "Previous in playlist", step_playlist<-1>,
                file_actions::has_document),
            row(ActionId::open_cues, "Open cues…", open_cues, file_actions::has_document, true),
            row(ActionId::save_cues, "Save cues", save_cues, can_save_cues),
            row(ActionId::save_cues_as, "Save cues as…", save_cues_as, has_cues),
            row(ActionId::close_cues, "Close cues", close_cues, has_cues),
            cues,
            row(ActionId::add_preset_cue, "Add preset cue", add_preset_cue, has_preset)};
}
