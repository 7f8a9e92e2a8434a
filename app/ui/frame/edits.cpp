#include "ui/frame/edits.h"

#include "lab/lab.h"

#include <imgui/imgui.h>

void Edits::document(std::function<void(Document&)> edit) {
    add([edit = std::move(edit)](Lab& lab) { lab.edit(edit); });
}

void Edits::set(const std::string& name, Value value) {
    document([name, value = std::move(value)](Document& document) {
        document.set_value(name, value, true);
    });
}

void Edits::finish() {
    document([](Document& document) { document.finish(); });
}

void Edits::end_line() {
    add([](Lab& lab) {
        lab.drawing().edit(
            [](DrawingBoard& board, Document& document) { board.end_line(document); });
    });
}

void Edits::show(Dialog dialog) {
    arrange([dialog = std::move(dialog)](WindowState& window) { window.dialog = dialog; });
}

void Edits::open(const std::string& argument) {
    add([argument](Lab& lab) { lab.looks().open(argument); });
}

void Edits::open_with_content(const std::string& argument) {
    add([argument](Lab& lab) { lab.looks().open_with_content(argument); });
}

void Edits::open_file(const std::filesystem::path& file) {
    add([file](Lab& lab) { lab.looks().open_file(file); });
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
