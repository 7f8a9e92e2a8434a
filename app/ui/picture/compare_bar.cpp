#include "ui/picture/compare_bar.h"

#include "ui/frame/action.h"
#include "ui/picture/comparison_edits.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
float gain_number_width() {
    return ImGui::GetFontSize() * 2.8f;
}

constexpr theme::Color bar_color{0.098f, 0.098f, 0.102f, 0.92f};

void draw_modes(const Scene& scene, Edits& edits) {
    static constexpr std::array modes{CompareMode::wipe, CompareMode::side_by_side,
                                      CompareMode::difference};
    static constexpr std::array labels{"Wipe", "Side by side", "Difference"};
    const CompareMode current = scene.lab.frames.comparison().selection().chosen().mode;
    const int chosen = static_cast<int>(current) - static_cast<int>(modes[0]);
    const int next =
        choice("compare", labels.data(), static_cast<int>(labels.size()), chosen, edits);
    if (next != chosen)
        set_compare_mode(modes[static_cast<std::size_t>(next)], edits);
}

void draw_other(const std::string& label, const Other& other, const Scene& scene, Edits& edits) {
    if (ImGui::Selectable(label.c_str(),
                          scene.lab.frames.comparison().selection().chosen().other == other))
        edits.change([other](ComparisonView& comparison) { comparison.compare_with(other); });
    edits.mark("other:" + label);
}

void draw_others(const Scene& scene, float width, Edits& edits) {
    const auto sides = scene.lab.frames.comparison().sides();
    const bool is_open = begin_combo("##other", sides ? sides->other : std::string(), width);
    edits.mark("other");
    if (!is_open)
        return;
    const Document& document = *scene.lab.document;
    const Comparing& comparing = scene.lab.frames.comparison().selection();
    if (const auto article = comparing.variant({}, document.look(), document.values()))
        draw_other(article->sides.other, {}, scene, edits);
    for (std::size_t i = 0; i < scene.lab.frames.comparison().slots().size(); ++i) {
        const Other other{Other::Kind::slot, i};
        if (const auto slot = comparing.variant(other, document.look(), document.values()))
            draw_other(slot->sides.other, other, scene, edits);
    }
    if (const auto& file = comparing.reference().file(); comparing.reference().picture())
        draw_other(file.filename().string(), {Other::Kind::file, 0, file}, scene, edits);
    ImGui::Separator();
    if (ImGui::Selectable("Image file…"))
        run(ActionId::with_file, scene, edits);
    edits.mark("other:file");
    ImGui::EndCombo();
}

std::string brightness_label(const Scene& scene) {
    if (!scene.lab.frames.comparison().selection().chosen().has_equal_brightness)
        return "Equal brightness";
    const ComparedPictures& compared = scene.views.main().compared();
    const auto stops = compared.stops();
    return stops ? fmt::format("Equal brightness {:+.2f} stops", *stops)
                 : std::string("Equal brightness …");
}

void draw_brightness(const Scene& scene, Edits& edits) {
    const bool is_on = scene.lab.frames.comparison().selection().chosen().has_equal_brightness;
    const ScopedColor text(ImGuiCol_Text, is_on ? theme::accent : theme::dim);
    const ScopedColor field(ImGuiCol_Button, is_on ? theme::field : theme::none);
    if (ImGui::Button((brightness_label(scene) + "##brightness").c_str()))
        run(ActionId::equal_brightness, scene, edits);
    edits.mark("equal_brightness");
    const ScopedColor normal(ImGuiCol_Text, theme::text);
    tooltip(
        fmt::format("{}\nScales the reference to the mean luminance of this picture, because a "
                    "brighter picture often looks better.",
                    scene.actions.help(ActionId::equal_brightness)));
}

void draw_choices(const Scene& scene, Edits& edits) {
    const float side = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    draw_modes(scene, edits);
    ImGui::SameLine();
    const float brightness = ImGui::CalcTextSize(brightness_label(scene).c_str()).x +
                             2.0f * ImGui::GetStyle().FramePadding.x;
    const float room = ImGui::GetContentRegionAvail().x - brightness - side - 2.0f * gap;
    draw_others(scene, std::max(room, 4.0f * side), edits);
    ImGui::SameLine();
    draw_brightness(scene, edits);
    same_line_right(side);
    if (icon_button("##end", Icon::close, "Stop comparing", theme::dim))
        set_compare_mode(CompareMode::off, edits);
    edits.mark("compare_end");
}

// `room`: the width for the label, the slider and its number.
void draw_gain(const Scene& scene, float room, Edits& edits) {
    double gain = scene.lab.frames.comparison().selection().chosen().gain_stops;
    const SliderInfo info{.low = -4.0,
                          .high = 12.0,
                          .initial = 0.0,
                          .is_changed = gain != 0.0,
                          .unit = "stops",
                          .limit = Limit{-16.0, 16.0}};
    ImGui::AlignTextToFramePadding();
    dim_text("Gain");
    ImGui::SameLine(0.0f, 4.0f);
    const float taken = ImGui::CalcTextSize("Gain").x + 6.0f + gain_number_width();
    const float letter = ImGui::GetFontSize();
    ValueEdit edited =
        draw_slider("##gain", gain, info, std::clamp(room - taken, 2.0f * letter, 8.0f * letter));
    edits.mark("difference_gain");
    tooltip(fmt::format("Gain of the difference view. White is a difference of {}.",
                        short_number(std::exp2(-gain))));
    ImGui::SameLine(0.0f, 2.0f);
    {
        const ScopedFont font(scene.fonts.numbers);
        edited |= draw_number("##gain_number", gain, gain_number_width(), number_info(info));
        edits.mark("number:difference_gain");
    }
    ImGui::SameLine(0.0f, 0.0f);
    const bool can_fit =
        scene.lab.frames.comparison().selection().chosen().measure != DifferenceMeasure::relative;
    if (icon_button("##fit", Icon::fit, "Auto gain: show the largest difference as white.",
                    can_fit ? theme::text : theme::faint) &&
        can_fit)
        edits.arrange([](WindowState& window) { window.views.pending.gain = true; });
    edits.mark("fit_gain");
    if (edited.is_changed)
        change_comparison(edits, [gain](Comparison& comparison) { comparison.gain_stops = gain; });
}

std::string numbers_text(const Scene& scene) {
    const ComparedPictures& compared = scene.views.main().compared();
    const auto& distances = compared.distances();
    if (!distances)
        return "Measuring…";
    if (std::isinf(distances->psnr_db) && distances->psnr_db > 0.0)
        return fmt::format("mean {:.3g}  RMS {:.3g}  max {:.3g}  identical", distances->mean,
                           distances->rms, distances->largest);
    return fmt::format("mean {:.3g}  RMS {:.3g}  max {:.3g}  PSNR {:.1f} dB", distances->mean,
                       distances->rms, distances->largest, distances->psnr_db);
}

void draw_numbers(const Scene& scene, Edits& edits) {
    const ComparedPictures& compared = scene.views.main().compared();
    if (compared.other() && !compared.difference() && !compared.distances() &&
        !scene.lab.renderer->replay().is_running())
        return dim_text("No difference view for integer formats");
    {
        const ScopedFont font(scene.fonts.numbers);
        ImGui::AlignTextToFramePadding();
        fitted_text(numbers_text(scene), ImGui::GetContentRegionAvail().x, theme::text);
    }
    edits.mark("difference_numbers");
    if (const auto& distances = compared.distances())
        tooltip(fmt::format(
            "Absolute differences of red, green and blue, as in the command \"afterglow "
            "compare\". They don't depend on the metric chosen here. {:.1f} % of the "
            "pixels differ by more than 1/255.",
            100.0 * distances->share_beyond));
}

// The width of the row minus the numbers.
float gain_room(const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const float gaps = 2.0f * ImGui::GetStyle().ItemSpacing.x + ImGui::GetFrameHeight();
    return ImGui::GetContentRegionAvail().x - gaps -
           ImGui::CalcTextSize(numbers_text(scene).c_str()).x;
}

void draw_difference_row(const Scene& scene, Edits& edits) {
    static constexpr std::array labels{"Absolute", "Relative", "Squared"};
    const int chosen = static_cast<int>(scene.lab.frames.comparison().selection().chosen().measure);
    const int next =
        choice("measure", labels.data(), static_cast<int>(labels.size()), chosen, edits);
    if (next != chosen)
        change_comparison(edits, [next](Comparison& comparison) {
            comparison.measure = static_cast<DifferenceMeasure>(next);
        });
    ImGui::SameLine();
    draw_gain(scene, gain_room(scene), edits);
    ImGui::SameLine();
    draw_numbers(scene, edits);
}

float padding() {
    return ImGui::GetFontSize() * 0.35f;
}
}  // namespace

float compare_bar_height(const Scene& scene) {
    const CompareMode mode = scene.lab.frames.comparison().mode();
    if (mode == CompareMode::off || scene.window.layout.is_picture_only)
        return 0.0f;
    const float rows = mode == CompareMode::difference ? 2.0f : 1.0f;
    return rows * ImGui::GetFrameHeight() + (rows - 1.0f) * ImGui::GetStyle().ItemSpacing.y +
           2.0f * padding();
}

void draw_compare_bar(const Scene& scene, Edits& edits) {
    const float height = compare_bar_height(scene);
    if (height <= 0.0f)
        return;
    ImGui::SetCursorPos({0.0f, ImGui::GetWindowHeight() - height});
    const ScopedColor color(ImGuiCol_ChildBg, bar_color);
    const ScopedStyle<ImVec2> pad(ImGuiStyleVar_WindowPadding, ImVec2(padding(), padding()));
    ImGui::BeginChild("##compare", {ImGui::GetWindowWidth(), height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                          ImGuiWindowFlags_NoScrollWithMouse);
    draw_choices(scene, edits);
    if (scene.lab.frames.comparison().mode() == CompareMode::difference)
        draw_difference_row(scene, edits);
    ImGui::EndChild();
}
