#include "ui/status/remote_panel.h"

#include "lab/remote/remote_control.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>

namespace {
constexpr std::array log_columns{"Time", "Address", "Value", "Sender", "Reason"};

void draw_head(const RemoteLog& log, Edits& edits) {
    ImGui::AlignTextToFramePadding();
    dim_text(fmt::format("{} accepted, {} rejected", log.accepted(), log.rejected()));
    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttons =
        ImGui::CalcTextSize("CopyClear").x + 4.0f * style.FramePadding.x + style.ItemSpacing.x;
    same_line_right(buttons);
    const ScopedDisabled disabled(log.messages().empty());
    if (ImGui::Button("Copy"))
        edits.copy(log.text());
    edits.mark("remote_copy");
    ImGui::SameLine();
    if (ImGui::Button("Clear"))
        edits.change([](RemoteControl& remote) { remote.clear_log(); });
    edits.mark("remote_clear");
}

void draw_rejected(const RejectedMessage& message, const Fonts& fonts) {
    ImGui::TableNextRow();
    const auto draw_cell = [](const std::string& text, const theme::Color& color) {
        ImGui::TableNextColumn();
        fitted_text(text, ImGui::GetContentRegionAvail().x, color);
    };
    const ScopedFont font(fonts.numbers);
    draw_cell(message.count > 1
                  ? fmt::format("{} ×{}", time_of_day_text(message.seconds), message.count)
                  : time_of_day_text(message.seconds),
              theme::dim);
    draw_cell(message.address, theme::text);
    draw_cell(message.value, theme::text);
    draw_cell(message.sender, theme::dim);
    const ScopedFont reason_font(fonts.text);
    draw_cell(message.reason, theme::warning);
}

void draw_rejected_list(const RemoteLog& log, const Scene& scene) {
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_Resizable | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("##rejected", static_cast<int>(log_columns.size()), flags,
                           ImGui::GetContentRegionAvail()))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    constexpr std::array weights{0.8f, 2.2f, 1.2f, 1.0f, 3.2f};
    for (std::size_t i = 0; i < log_columns.size(); ++i)
        ImGui::TableSetupColumn(log_columns[i], ImGuiTableColumnFlags_WidthStretch, weights[i]);
    {
        const ScopedColor color(ImGuiCol_Text, theme::dim);
        ImGui::TableHeadersRow();
    }
    int row = 0;
    for (const RejectedMessage& message : log.messages()) {
        const ScopedId id(row++);
        draw_rejected(message, scene.fonts);
    }
    ImGui::EndTable();
}
}  // namespace

void draw_remote_panel(const Scene& scene, Edits& edits) {
    const RemoteLog& log = scene.lab.remote.log();
    draw_head(log, edits);
    if (log.messages().empty())
        dim_text("No rejected OSC or MIDI messages.");
    else
        draw_rejected_list(log, scene);
}
