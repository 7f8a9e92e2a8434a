#include "ui/playback/playlist_panel.h"

#include "lab/document/opened_preset.h"
#include "lab/library/library_view.h"
#include "lab/sequencer/sequencer.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
void set_playlist(Playlist next, Edits& edits) {
    edits.change(
        [next = std::move(next)](Sequencer& sequencer) { sequencer.playlist().set_list(next); });
}

void draw_playlist_buttons(const Scene& scene, Edits& edits) {
    const bool is_playing = scene.lab.sequencer.playlist().is_playing();
    if (icon_button("##previous", Icon::step_back, scene.actions.help(ActionId::playlist_previous)))
        run(ActionId::playlist_previous, scene, edits);
    edits.mark("playlist_previous");
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##play", is_playing ? Icon::stop : Icon::play,
                    is_playing ? "Stop playlist" : scene.actions.help(ActionId::play_playlist)))
        run(ActionId::play_playlist, scene, edits);
    edits.mark("playlist_play");
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##next", Icon::step, scene.actions.help(ActionId::playlist_next)))
        run(ActionId::playlist_next, scene, edits);
    edits.mark("playlist_next");
}

// A label and a number on the current line.
bool draw_playlist_number(const char* label, const char* id, double& number, const NumberInfo& info,
                          const Scene& scene, Edits& edits) {
    ImGui::SameLine(0.0f, ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    dim_text(label);
    ImGui::SameLine();
    const ScopedFont font(scene.fonts.numbers);
    const bool is_changed = draw_number(id, number, ImGui::GetFontSize() * 4.5f, info).is_changed;
    edits.mark(std::string("playlist") + id);
    return is_changed;
}

void draw_playlist_settings(const Scene& scene, Edits& edits) {
    Playlist next = scene.lab.sequencer.playlist().list();
    bool is_changed = draw_playlist_number(
        "Every", "##every", next.every, {.limit = Limit{0.125, max_playlist_every}}, scene, edits);
    ImGui::SameLine();
    constexpr std::array units{"Bars", "Seconds"};
    const int unit = next.unit == Playlist::Unit::bars ? 0 : 1;
    if (const int chosen = choice("playlist_unit", units.data(), 2, unit, edits); chosen != unit) {
        next.unit = chosen == 0 ? Playlist::Unit::bars : Playlist::Unit::seconds;
        is_changed = true;
    }
    is_changed |=
        draw_playlist_number("Morph", "##morph", next.morph_seconds,
                             {.unit = "s", .limit = Limit{0.0, max_playlist_morph}}, scene, edits);
    ImGui::SameLine(0.0f, ImGui::GetFontSize());
    is_changed |= ImGui::Checkbox("Shuffle", &next.is_shuffled);
    edits.mark("playlist_shuffle");
    if (is_changed)
        set_playlist(std::move(next), edits);
}

void draw_playlist_adding(const Scene& scene, Edits& edits) {
    {
        const ScopedDisabled disabled(preset_file(*scene.lab.document).empty());
        if (ImGui::Button("Add open preset"))
            edits.change([](Sequencer& sequencer) { sequencer.playlist().add_open_preset(); });
        edits.mark("playlist_add");
    }
    ImGui::SameLine();
    if (ImGui::Button("Add all"))
        edits.change([](Sequencer& sequencer) { sequencer.playlist().add_all(); });
    edits.mark("playlist_add_all");
    ImGui::SameLine();
    const ScopedDisabled disabled(scene.lab.sequencer.playlist().list().presets.empty());
    if (ImGui::Button("Clear"))
        edits.change([](Sequencer& sequencer) { sequencer.playlist().clear(); });
    edits.mark("playlist_clear");
}

// The displayed name of a preset in the list.
std::string label_of(const std::string& preset, const Scene& scene) {
    for (const ListedLook& look : scene.library_view.looks())
        if (is_listed_as(scene.lab.document->look(), look))
            for (const ListedLookPreset& listed : look.presets)
                if (listed.entry.id == preset)
                    return listed.name;
    const std::filesystem::path path(preset);
    return path.is_absolute() ? path.stem().string() : preset;
}

void draw_playlist_row(std::size_t index, const Scene& scene, Edits& edits) {
    const PlaylistControl& control = scene.lab.sequencer.playlist();
    const Playlist& list = control.list();
    const ScopedId id(static_cast<int>(index));
    const bool is_current = control.is_playing() && control.index() == index;
    const float buttons = 3.0f * ImGui::GetFrameHeight();
    const float width = std::max(ImGui::GetContentRegionAvail().x - buttons, 1.0f);
    const std::string label =
        fmt::format("{:>3}  {}", index + 1, label_of(list.presets[index], scene));
    if (ImGui::Selectable(label.c_str(), is_current, 0, {width, ImGui::GetFrameHeight()}))
        edits.change([index](Sequencer& sequencer) { sequencer.playlist().go_to(index); });
    edits.mark(fmt::format("playlist:{}", index + 1));
    const auto move = [&](std::size_t to) {
        Playlist next = list;
        std::swap(next.presets[index], next.presets[to]);
        set_playlist(next, edits);
    };
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##up", Icon::up, "Move up", theme::dim) && index > 0)
        move(index - 1);
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##down", Icon::down, "Move down", theme::dim) &&
        index + 1 < list.presets.size())
        move(index + 1);
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##remove", Icon::close, "Remove from playlist", theme::dim)) {
        Playlist next = list;
        next.presets.erase(next.presets.begin() + static_cast<std::ptrdiff_t>(index));
        set_playlist(next, edits);
    }
    if (!is_current)
        return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float left = low.x - width - 2.0f * ImGui::GetFrameHeight();
    const auto share = static_cast<float>(control.share(scene.lab.sequencer.tempo().tempo()));
    ImGui::GetWindowDrawList()->AddRectFilled({left, high.y - 2.0f}, {left + width * share, high.y},
                                              theme::packed(theme::accent));
}
}  // namespace

void draw_playlist_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return wrapped_dim_text("Open a look to make a playlist of its presets.");
    draw_playlist_buttons(scene, edits);
    draw_playlist_settings(scene, edits);
    draw_playlist_adding(scene, edits);
    const Playlist& list = scene.lab.sequencer.playlist().list();
    if (list.presets.empty())
        wrapped_dim_text("Add presets, then press Play. The list is saved for this look.");
    for (std::size_t i = 0; i < list.presets.size(); ++i)
        draw_playlist_row(i, scene, edits);
}
