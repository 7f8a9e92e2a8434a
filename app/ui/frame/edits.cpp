#include "ui/frame/edits.h"

#include "lab/lab_parts.h"
#include "lab/session.h"

#include <imgui/imgui.h>

void Edits::set(const std::string& name, Value value) {
    change([name, value = std::move(value)](Document& document) {
        document.set_value(name, value, true);
    });
}

void Edits::finish() {
    change([](Document& document) { document.finish(); });
}

void Edits::append(Edits other) {
    std::ranges::move(other.m_edits, std::back_inserter(m_edits));
    WindowRequests& added = other.m_requests;
    if (added.copied)
        m_requests.copied = std::move(added.copied);
    m_requests.copies_picture |= added.copies_picture;
    m_requests.quits |= added.quits;
    m_requests.shows_dialog |= added.shows_dialog;
    m_widget_rects.merge(other.m_widget_rects);
}

void Edits::show(Dialog dialog) {
    m_requests.shows_dialog = true;
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
    change([stored](Lab& lab) { restore_stashed(lab, stored); });
}

void Edits::mark(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    if (ImGui::IsItemVisible())
        m_widget_rects[name] = {low.x, low.y, high.x, high.y};
}

void Edits::apply(Lab& lab, WindowState& window) const {
    for (const Edit& edit : m_edits)
        edit(mutable_parts(lab, &window));  // an edit may open the first document
}
