#include "ui/passes/pass_inputs.h"

#include "lab/views/views.h"
#include "model/look/format.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>

namespace {
const char* filter_text(const Sampler& sampler) {
    const bool is_linear = sampler.filter == Filter::linear;
    if (sampler.mipmap)
        return is_linear ? "linear, mipmaps" : "nearest, mipmaps";
    return is_linear ? "linear" : "nearest";
}

const char* wrap_text(Wrap wrap) {
    static constexpr std::array names{"edge", "border", "repeat", "mirror"};
    return names[static_cast<std::size_t>(wrap)];
}

void draw_read(const SamplerReport& sampler, Edits& edits) {
    if (!sampler.reads) {
        dim_text("none (transparent black)");
        return;
    }
    if (quiet_button(sampler.reads->label() + "##" + sampler.uniform))
        edits.arrange([choice = *sampler.reads](WindowState& window) {
            window.views.inspected.inspect(choice);
        });
    edits.mark("reads:" + sampler.uniform);
    tooltip("Click to inspect this picture.");
}

void draw_sampler(const SamplerReport& sampler, Edits& edits) {
    const auto cell = [](const std::string& text) {
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        dim_text(text);
    };
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(sampler.uniform.c_str());
    ImGui::TableNextColumn();
    draw_read(sampler, edits);
    if (sampler.extent.is_empty()) {
        cell(!sampler.reads ? "" : "not available yet (transparent black)");
        return;
    }
    cell(size_text(sampler.extent));
    cell(std::string(info_of(sampler.format).name));
    cell(filter_text(sampler.sampler));
    cell(wrap_text(sampler.sampler.wrap));
}

void name_columns(int columns) {
    ImGui::TableNextRow();
    for (int i = 0; i < columns; ++i) {
        ImGui::TableSetColumnIndex(i);
        dim_text(ImGui::TableGetColumnName(i));
    }
}

void draw_samplers(const PassReport& report, Edits& edits) {
    if (report.samplers.empty())
        dim_text("This pass has no inputs.");
    else if (ImGui::BeginTable("##samplers", 6, ImGuiTableFlags_SizingFixedFit)) {
        for (const char* head : {"Sampler", "Input", "Size", "Format", "Filter", "Wrap"})
            ImGui::TableSetupColumn(head);
        name_columns(6);
        for (const SamplerReport& sampler : report.samplers)
            draw_sampler(sampler, edits);
        ImGui::EndTable();
    }
}

void draw_built_ins(const PassReport& report) {
    if (report.built_ins.empty())
        dim_text("This pass uses no built-in uniforms.");
    else if (ImGui::BeginTable("##built_ins", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const char* head : {"Built-in uniform", "Value"})
            ImGui::TableSetupColumn(head);
        name_columns(2);
        for (const BuiltInReport& built_in : report.built_ins) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted(built_in.name.c_str());
            ImGui::TableNextColumn();
            std::string text;
            for (const double number : built_in.numbers)
                text += fmt::format("{}{:.9g}", text.empty() ? "" : "  ", number);
            dim_text(text);
        }
        ImGui::EndTable();
    }
}
}  // namespace

void draw_pass_inputs(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer || scene.lab.renderer->executor().plan().targets.empty())
        return;
    const Executor& executor = scene.lab.renderer->executor();
    const PassReport report =
        executor.drawer().report(inspected_pass(executor.look(), scene.window.views.inspected));
    const ScopedFont font(scene.fonts.numbers);
    const ScopedStyle<ImVec2> padding(
        ImGuiStyleVar_CellPadding,
        ImVec2(ImGui::GetStyle().ItemSpacing.x, ImGui::GetStyle().CellPadding.y * 0.5f));
    ImGui::BeginGroup();
    draw_samplers(report, edits);
    ImGui::EndGroup();
    ImGui::SameLine(0.0f, 3.0f * ImGui::GetFontSize());
    ImGui::BeginGroup();
    draw_built_ins(report);
    ImGui::EndGroup();
}
