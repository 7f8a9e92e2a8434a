#include "ui/actions/playback_actions.h"

#include "lab/document/automation.h"
#include "lab/sequencer/sequencer.h"
#include "lab/sequencer/sound_region.h"
#include "ui/actions/file_actions.h"
#include "ui/dialogs/impulse_dialog.h"
#include "ui/dialogs/rates_dialog.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/playback/timeline.h"

#include <cmath>

namespace {
void play_pause(const Scene& scene, Edits& edits) {
    const bool is_playing = scene.lab.player.transport().is_playing();
    edits.change([is_playing](Player& player) { is_playing ? player.pause() : player.play(); });
}
void step(const Scene&, Edits& edits) {
    edits.change([](Player& player) {
        player.pause();
        player.step();
    });
}
void step_back(const Scene&, Edits& edits) {
    edits.change([](Sequencer& sequencer) { sequencer.scrubber().step_back(); });
}
template <int seconds>
void seek_by(const Scene& scene, Edits& edits) {
    seek_by_seconds(seconds, scene, edits);
}
bool has_loop_region(const Scene& scene) {
    return has_region(scene.lab.player.signal());
}
void remove_loop_region(const Scene&, Edits& edits) {
    edits.change([](Document& document, Player& player) { remove_region(document, player); });
}
void restart(const Scene&, Edits& edits) {
    edits.change([](FrameLoop& frames) { frames.restart(); });
}
template <int octaves>
void change_speed(const Scene& scene, Edits& edits) {
    const double speed = scene.lab.player.transport().speed() * std::exp2(octaves);
    edits.change([speed](Player& player) { player.set_speed(speed); });
}
void set_normal_speed(const Scene&, Edits& edits) {
    edits.change([](Player& player) { player.set_speed(1.0); });
}

void start_rates(const Scene&, Edits& edits) {
    compare_rates(edits);
}
void start_impulse(const Scene& scene, Edits& edits) {
    fire_impulse(scene, edits);
}

bool is_recording(const Scene& scene) {
    return scene.lab.automation.recorder().is_running();
}
bool has_automation(const Scene& scene) {
    return !scene.lab.automation.recorder().points().empty();
}
// The end of a recording opens the save dialog.
void record_automation(const Scene& scene, Edits& edits) {
    const bool is_starting = !is_recording(scene);
    edits.change([is_starting](Automation& automation) { automation.record(is_starting); });
    if (!is_starting && has_automation(scene))
        edits.show({.kind = Dialog::Kind::save_automation});
}
void save_automation(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::save_automation});
}
}  // namespace

std::vector<Action> playback_actions::list() {
    return {
        {ActionId::play_pause, Menu::playback, "Play or pause", {' '}, false, play_pause},
        {ActionId::step, Menu::playback, "Step one frame", {'.'}, false, step},
        {ActionId::step_back, Menu::playback, "Step one frame back", {','}, false, step_back},
        {ActionId::seek_forward, Menu::playback, "Forward 5 seconds", {}, false, seek_by<5>},
        {ActionId::seek_back, Menu::playback, "Back 5 seconds", {}, false, seek_by<-5>},
        {ActionId::restart, Menu::playback, "Restart", {'R'}, false, restart},
        {ActionId::remove_loop_region,
         Menu::playback,
         "Remove loop region",
         {},
         false,
         remove_loop_region,
         has_loop_region},
        {ActionId::slower, Menu::playback, "Halve speed", {'['}, true, change_speed<-1>},
        {ActionId::faster, Menu::playback, "Double speed", {']'}, false, change_speed<1>},
        {ActionId::normal_speed, Menu::playback, "Normal speed", {'\\'}, false, set_normal_speed},
        {ActionId::compare_rates,
         Menu::playback,
         "Compare frame rates…",
         {},
         true,
         start_rates,
         file_actions::has_document},
        {ActionId::impulse,
         Menu::playback,
         "Measure impulse response…",
         {'I'},
         false,
         start_impulse,
         file_actions::has_document},
        {ActionId::record_automation,
         Menu::playback,
         "Record automation",
         {},
         true,
         record_automation,
         file_actions::has_document,
         is_recording},
        {ActionId::save_automation,
         Menu::playback,
         "Save automation…",
         {},
         false,
         save_automation,
         has_automation}};
}
