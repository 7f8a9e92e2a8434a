#include "ui/sound_controls.h"

#include "ui/form.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

#include <cmath>

std::string clock_text(double seconds) {
    const double whole = std::floor(seconds / 60.0);
    return fmt::format("{:.0f}:{:05.2f}", whole, seconds - whole * 60.0);
}

namespace {
void draw_seek_bar(double time, double length, const Scene& scene, Edits& edits) {
    double place = length > 0.0 ? std::fmod(time, length) : 0.0;
    const SliderFacts facts{
        .low = 0.0, .high = length, .step = 0.01, .unit = "s", .limit = Limit{0.0, length}};
    const Turned turned = draw_slider("##seek", place, facts, ImGui::GetContentRegionAvail().x);
    edits.mark("seek");
    if (turned.is_changed)
        edits.add([place](Lab& lab) { lab.transport().seek(place); });
    const ScopedFont font(scene.fonts.numbers);
    dim_text(clock_text(place) + " / " + clock_text(length));
}

void draw_volume(const Player& player, const Scene& scene, Edits& edits) {
    const ScopedId id(std::string("volume"));
    const FormColumns columns = form_columns();
    form_label("Volume", {}, columns, false);
    tooltip("Of the loudspeaker; the trace stays as it is.");
    form_control(columns);
    double level = player.level();
    if (form_slider(
            "##value", level,
            {.low = 0.0, .high = 2.0, .initial = 1.0, .unit = "×", .limit = Limit{0.0, 2.0}},
            columns, scene.fonts)
            .is_changed)
        edits.add([level](Lab& lab) { lab.transport().set_level(level); });
}
}  // namespace

void draw_sound_controls(const Scene& scene, Edits& edits) {
    const Player& player = scene.lab.player();
    if (player.sound().sound)
        draw_seek_bar(player.time(), player.sound_seconds(), scene, edits);
    draw_volume(player, scene, edits);
    if (player.silence().empty())
        return;
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::TextWrapped("%s", player.silence().c_str());
}
