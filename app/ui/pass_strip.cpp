#include "ui/pass_strip.h"

#include "lab/heavy_pass.h"
#include "lab/tryouts.h"
#include "model/own_name.h"
#include "model/parameter_use.h"
#include "ui/pass_switch_actions.h"
#include "ui/scoped.h"
#include "ui/slider.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
struct Cell {
    std::size_t index = 0;
    const Pass& pass;
    const PlannedTarget& target;
    double milliseconds = 0.0;
    const Gain* gain = nullptr;             // null: not measured yet
    std::optional<PassChange> change = {};  // by the step that somebody asks about
    bool is_chosen = false;
    float width = 0.0f;
    bool is_narrow = false;  // the time stands in the place of size and format
    std::string state = {};  // what is switched about it; "": nothing
};

constexpr float word_lines = 3.7f;  // below the picture: name, facts, gain

std::string facts_text(const Cell& cell) {
    return fmt::format("{}×{} {}", cell.target.extent.width, cell.target.extent.height,
                       facts_of(cell.target.format).name);
}

// As many digits as are worth telling: three.
std::string time_text(double milliseconds) {
    if (milliseconds <= 0.0)
        return {};
    const int decimals = milliseconds < 99.995 ? 2 : milliseconds < 999.95 ? 1 : 0;
    return fmt::format("{:.{}f} ms", milliseconds, decimals);  // "00.00 ms" is room for all
}

std::string percent_text(double share) {
    return fmt::format("{:.{}f} %", share * 100.0, share < 0.0995 ? 1 : 0);
}

bool is_clipped(const Gain& gain) {
    constexpr double counts = 0.0005;  // "0.1 %"
    return gain.clipped >= counts;
}

// A peak at the ceiling may be a rounding above it: that is 0.0, not -0.0.
std::string stops_text(double stops) {
    return fmt::format("{:.1f}", std::round(stops * 10.0) / 10.0 + 0.0);
}

// What counts most, in the room there is.
std::string gain_text(const Gain& gain, bool is_narrow) {
    if (is_narrow && is_clipped(gain))
        return percent_text(gain.clipped) + " clipped";
    if (is_clipped(gain))
        return fmt::format("peak {:.3g}, {} clipped", gain.peak, percent_text(gain.clipped));
    const auto headroom = headroom_stops(gain);
    if (!headroom)
        return "no light";
    if (is_narrow || *headroom > meter_stops)
        return fmt::format("peak {:.3g}", gain.peak);
    return fmt::format("peak {:.3g}, {} stops", gain.peak, stops_text(*headroom));
}

std::string gain_help(const Gain& gain) {
    const auto headroom = headroom_stops(gain);
    return fmt::format(
        "\npeak {}, mean {}\n{} at the ceiling, {}\n{}", short_number(gain.peak),
        short_number(gain.mean), percent_text(gain.clipped), short_number(gain.ceiling),
        headroom ? stops_text(*headroom) + " stops of headroom" : std::string("no light"));
}

// In a stack the looks are named above their passes.
std::string look_key(const std::string& pass) {
    const std::size_t end = pass.find('/');
    return end == std::string::npos ? std::string() : pass.substr(0, end);
}

void draw_image(const Views::Image& image, const ImVec2& low, float width, float height,
                float density, bool is_faint) {
    const float image_width = static_cast<float>(image.extent.width) / density;
    const float image_height = static_cast<float>(image.extent.height) / density;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 start(low.x + std::floor((width - image_width) * 0.5f),
                       low.y + std::floor((height - image_height) * 0.5f));
    list.AddRectFilled(low, {low.x + width, low.y + height}, theme::packed(theme::surround));
    if (image.handle != 0)
        list.AddImage(texture_id(image.handle), start,
                      {start.x + image_width, start.y + image_height}, {0.0f, 1.0f}, {1.0f, 0.0f},
                      is_faint ? IM_COL32(255, 255, 255, 96) : IM_COL32_WHITE);
}

// From 16 stops below the ceiling: filled up to the mean, a line at the peak. The ceiling of a
// 32-bit float is out of all sight.
void draw_meter(const Gain& gain, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](double number) {
        return low.x + (high.x - low.x) * static_cast<float>(meter_place(number, gain.ceiling));
    };
    list.AddRectFilled(low, high, theme::packed(theme::field));
    list.AddRectFilled(low, {at(gain.mean), high.y}, theme::packed(theme::filled));
    const theme::Color color = is_clipped(gain) ? theme::warning : theme::label;
    const float peak = std::clamp(at(gain.peak), low.x + 2.0f, high.x);
    if (gain.peak > 0.0)
        list.AddRectFilled({peak - 2.0f, low.y}, {peak, high.y}, theme::packed(color));
}

// What is switched about the pass, over its picture.
void draw_state(const Cell& cell, const Scene& scene, const ImVec2& low, float width) {
    const ScopedFont font(scene.fonts.numbers);
    const ImVec2 pad(4.0f * scene.scale, 1.0f * scene.scale);
    const std::string words = cut_to_fit(cell.state, width - 2.0f * pad.x);
    const ImVec2 text = ImGui::CalcTextSize(words.c_str());
    const ImVec2 right(low.x + width, low.y + text.y + 2.0f * pad.y);
    const ImVec2 left(right.x - text.x - 2.0f * pad.x, low.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(left, right, theme::packed(theme::popup), 3.0f * scene.scale);
    list.AddText({left.x + pad.x, left.y + pad.y}, theme::packed(theme::warning), words.c_str());
}

// By how much, and a word where not at all.
std::string change_text(const PassChange& change) {
    if (!change.has_changed())
        return "the same";
    const double percent = 100.0 * change_share(change);
    return percent < 0.01 ? "changed < 0.01 %" : fmt::format("changed {:.2g} %", percent);
}

// From a hundredth of a per cent on.
void draw_change(const PassChange& change, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = (high.x - low.x) * static_cast<float>(change_place(change));
    list.AddRectFilled(low, high, theme::packed(theme::field));
    list.AddRectFilled(low, {low.x + width, high.y}, theme::packed(theme::accent));
}

ImU32 color_of_time(double milliseconds) {
    return theme::packed(milliseconds > heavy_pass_milliseconds ? theme::problem : theme::dim);
}

// To the left of that point; gives its width.
float draw_time(double milliseconds, const ImVec2& right, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const std::string time = time_text(milliseconds);
    const float width = ImGui::CalcTextSize(time.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({right.x - width, right.y}, color_of_time(milliseconds),
                                        time.c_str());
    return width;
}

void draw_words(const Cell& cell, const Scene& scene, const ImVec2& at, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetFontSize();
    const std::string time = time_text(cell.milliseconds);
    float room = width;
    if (!cell.is_narrow && !time.empty())
        room -= draw_time(cell.milliseconds, {at.x + width, at.y + 1.0f}, scene) + line * 0.6f;
    const std::string name = cut_to_fit(own_name(cell.pass.name), room);
    list.AddText(at, theme::packed(cell.is_chosen ? theme::accent : theme::text), name.c_str());
    const ScopedFont font(scene.fonts.numbers);
    const std::string facts = cut_to_fit(cell.is_narrow ? time : facts_text(cell), width);
    list.AddText({at.x, at.y + line * 1.2f},
                 cell.is_narrow ? color_of_time(cell.milliseconds) : theme::packed(theme::dim),
                 facts.c_str());
    if (cell.change) {
        const std::string change = cut_to_fit(change_text(*cell.change), width);
        const theme::Color color = cell.change->has_changed() ? theme::accent : theme::dim;
        list.AddText({at.x, at.y + line * 2.4f}, theme::packed(color), change.c_str());
        return;
    }
    if (!cell.gain)
        return;
    const std::string gain = cut_to_fit(gain_text(*cell.gain, cell.is_narrow), width);
    list.AddText({at.x, at.y + line * 2.4f},
                 theme::packed(is_clipped(*cell.gain) ? theme::warning : theme::dim), gain.c_str());
}

// Wide enough for the picture, and for a name of some length beside its time; it does not change
// with the time.
float wanted_width(const Cell& cell, const Scene& scene, float image_width) {
    const float longest = ImGui::GetFontSize() * 11.0f;
    const float name = std::min(ImGui::CalcTextSize(own_name(cell.pass.name).c_str()).x, longest);
    const ScopedFont font(scene.fonts.numbers);
    const float time = ImGui::CalcTextSize("00.00 ms").x;
    const float facts = ImGui::CalcTextSize(facts_text(cell).c_str()).x;
    return std::max({image_width, name + time + ImGui::GetFontSize() * 0.6f, facts});
}

float image_width(const Cell& cell, const Scene& scene) {
    return static_cast<float>(scene.views.thumbnail(cell.index).extent.width) / scene.density;
}

// Where there is room they have some for their gains; where there is too little, as many as
// possible are in sight.
void share_room(std::vector<Cell>& cells, float room, const Scene& scene) {
    if (cells.empty())
        return;
    const float gap = ImGui::GetFontSize() * 0.6f;
    const float gaps = gap * static_cast<float>(cells.size() - 1);
    const float each = std::floor((room - gaps) / static_cast<float>(cells.size()));
    const float gain = ImGui::CalcTextSize("peak 0.000, 0.0 stops").x;
    float sum = gaps;
    for (Cell& cell : cells) {
        const float wanted = wanted_width(cell, scene, image_width(cell, scene));
        cell.width = std::max(wanted, std::min(gain, each));
        sum += cell.width;
    }
    if (sum <= room)
        return;
    const float least = ImGui::GetFontSize() * 4.8f;
    for (Cell& cell : cells) {
        cell.width = std::max({image_width(cell, scene), least, each});
        cell.is_narrow = true;
    }
}

std::string cell_help(const Cell& cell) {
    const double mebibytes = static_cast<double>(memory_of(cell.target)) / (1024.0 * 1024.0);
    return fmt::format(
        "{}\n{}, {:.1f} MiB{}{}{}{}\nA double click shows it as large as the picture, the right "
        "button "
        "switches it.",
        cell.pass.name, facts_text(cell), mebibytes,
        cell.milliseconds > 0.0 ? "\n" + time_text(cell.milliseconds) : "",
        cell.milliseconds > heavy_pass_milliseconds ? ", so the window answers slowly" : "",
        cell.gain ? gain_help(*cell.gain) : "", cell.state.empty() ? "" : "\n" + cell.state);
}

void draw_cell(const Cell& cell, const Scene& scene, float image_height, Edits& edits) {
    const ScopedId id(static_cast<int>(cell.index));
    const Views::Image image = scene.views.thumbnail(cell.index);
    const float width = cell.width;
    const float words = ImGui::GetFontSize() * word_lines;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("##pass", {width, image_height + words}))
        edits.arrange([name = cell.pass.name](WindowState& window) {
            window.inspected.look_into(name);
            window.shows_inspector = true;
        });
    edits.mark("pass:" + cell.pass.name);
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered && ImGui::IsMouseDoubleClicked(0))
        edits.arrange([](WindowState& window) { window.shows_pass_large = true; });
    if (ImGui::BeginPopupContextItem("##switches")) {
        pass_switch_actions::draw_items(cell.pass.name, scene, edits);
        ImGui::EndPopup();
    } else {
        tooltip(cell_help(cell));
    }
    draw_image(image, low, width, image_height, scene.density, cell.state.ends_with("not drawn"));
    if (!cell.change && cell.gain && headroom_stops(*cell.gain).value_or(0.0) <= meter_stops)
        draw_meter(*cell.gain, {low.x, low.y + image_height - 4.0f * scene.scale},
                   {low.x + width, low.y + image_height});
    if (cell.is_chosen || is_hovered)
        ImGui::GetWindowDrawList()->AddRect(
            low, {low.x + width, low.y + image_height},
            theme::packed(cell.is_chosen ? theme::accent : theme::faint));
    if (!cell.state.empty())
        draw_state(cell, scene, low, width);
    if (cell.change)
        draw_change(*cell.change, {low.x, low.y + image_height - 6.0f * scene.scale},
                    {low.x + width, low.y + image_height});
    draw_words(cell, scene, {low.x, low.y + image_height + 3.0f * scene.scale}, width);
}

/// The passes of one look of a stack, as they lie in the strip.
struct Group {
    std::string key;
    float left;
    float right;
};

// A tag that stays in sight as long as any of its passes is.
void draw_key(const Group& group, float top, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const ImVec2 text = ImGui::CalcTextSize(group.key.c_str());
    const ImVec2 pad(5.0f * scene.scale, 2.0f * scene.scale);
    const float width = text.x + 2.0f * pad.x;
    const float seen = std::max(group.left, ImGui::GetWindowPos().x);
    const float left = std::max(group.left, std::min(seen, group.right - width));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, top}, {left + width, top + text.y + 2.0f * pad.y},
                       theme::packed(theme::popup), 3.0f * scene.scale);
    list.AddText({left + pad.x, top + pad.y}, theme::packed(theme::label), group.key.c_str());
}

// Where the next cell comes: nearer to one of the same look.
void go_on(const std::vector<Group>& groups, const std::string& key, const Scene& scene) {
    const float gap = ImGui::GetFontSize() * 0.6f;
    const bool is_other = groups.back().key != key;
    ImGui::SameLine(0.0f, is_other ? 2.5f * gap : gap);
    if (!is_other)
        return;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float x = std::floor(low.x - 1.25f * gap);
    const float bottom = ImGui::GetWindowPos().y + ImGui::GetContentRegionAvail().y;
    ImGui::GetWindowDrawList()->AddLine({x, low.y}, {x, bottom}, theme::packed(theme::line),
                                        scene.scale);
}
}  // namespace

void draw_pass_strip(const Scene& scene, Edits& edits) {
    const Renderer* renderer = scene.lab.renderer();
    if (!renderer)
        return;
    const Look& look = renderer->executor().look();
    const std::vector<PlannedTarget>& targets = renderer->executor().plan().targets;
    const std::vector<double>& times = renderer->latest_pass_milliseconds();
    const auto& changes = scene.lab.tryouts().probe().changes();
    const float scrollbar = ImGui::GetStyle().ScrollbarSize;
    const float room =
        ImGui::GetContentRegionAvail().y - ImGui::GetFontSize() * word_lines - scrollbar;
    const float image_height = std::max(24.0f, std::floor(room));
    const int wanted = static_cast<int>(image_height * scene.density);
    if (wanted != scene.window.views.thumbnail_height)
        edits.arrange([wanted](WindowState& window) { window.views.thumbnail_height = wanted; });
    {  // of the strip alone: what pops up above it has its own
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##cells", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
    }
    const float top = ImGui::GetCursorScreenPos().y;
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < std::min(look.passes.size(), targets.size()); ++i) {
        const Cell cell{.index = i,
                        .pass = look.passes[i],
                        .target = targets[i],
                        .milliseconds = i < times.size() ? times[i] : 0.0,
                        .gain = scene.views.gain(i),
                        .change = i < changes.size() ? changes[i] : std::nullopt,
                        .is_chosen = look.passes[i].name == scene.window.inspected.pass,
                        .state = pass_switch_actions::words_of(i, look, scene.lab.pass_switches())};
        if (cell.is_chosen || !cell.state.empty() || !is_idle(look, i, targets[i].extent))
            cells.push_back(cell);
    }
    share_room(cells, ImGui::GetContentRegionAvail().x, scene);
    std::vector<Group> groups;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string key = look_key(cells[i].pass.name);
        if (i > 0)
            go_on(groups, key, scene);
        if (groups.empty() || groups.back().key != key)
            groups.push_back({key, ImGui::GetCursorScreenPos().x, 0.0f});
        draw_cell(cells[i], scene, image_height, edits);
        groups.back().right = ImGui::GetItemRectMax().x;
    }
    for (const Group& group : groups)
        if (!group.key.empty())
            draw_key(group, top, scene);
    // It has no height to scroll, so the wheel goes along it.
    constexpr float a_notch = 5.0f;  // letters
    if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0.0f && ImGui::IsWindowHovered())
        ImGui::SetScrollX(ImGui::GetScrollX() - wheel * a_notch * ImGui::GetFontSize());
    ImGui::EndChild();
}
