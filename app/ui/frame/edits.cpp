#include "ui/frame/edits.h"

#include "lab/session.h"

#include <imgui/imgui.h>

void Edits::add(const MenuCommand& command) {
    if (const auto* of_window = std::get_if<std::function<void(WindowState&)>>(&command))
        arrange(*of_window);
    else if (const auto* of_document = std::get_if<std::function<void(Document&)>>(&command))
        change(*of_document);
    else
        m_lab.push_back(std::get<std::function<void(Lab&)>>(command));
}

void Edits::set(const std::string& name, Value value) {
    change([name, value = std::move(value)](Document& document) {
        document.set_value(name, value, true);
    });
}

void Edits::finish() {
    change([](Document& document) { document.finish(); });
}

void Edits::show(Dialog dialog) {
    arrange([dialog = std::move(dialog)](WindowState& window) { window.dialog = dialog; });
}

void Edits::open(const std::string& argument) {
    change([argument](LookCommands& looks) { looks.open(argument); });
}

void Edits::open_with_content(const std::string& argument) {
    change([argument](LookCommands& looks) { looks.open_with_content(argument); });
}

void Edits::open_file(const std::filesystem::path& file) {
    change([file](LookCommands& looks) { looks.open_file(file); });
}

void Edits::open_unsaved(const std::filesystem::path& stored) {
    m_lab.emplace_back([stored](Lab& lab) { restore_kept(lab, stored); });
}

void Edits::mark(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    if (ImGui::IsItemVisible())
        m_widget_rects[name] = {low.x, low.y, high.x, high.y};
}

void Edits::apply(Lab& lab, WindowState& window) const {
    for (const auto& edit : m_window)
        edit(window);
    for (const auto& edit : m_lab)
        edit(lab);
}
