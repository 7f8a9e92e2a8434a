#include "lab/session/first_file.h"

#include <utility>

bool FirstFile::is_one(const std::string& argument) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(argument, ignored) &&
           ContentCommands::is_content(argument);
}

void FirstFile::update(Lab& lab) {
    if (m_file.empty() || !lab.document() || lab.loader().is_loading())
        return;
    const std::string look = lab.content().look_for(m_file);
    if (look.empty() || m_has_asked) {
        lab.looks().open_file(std::exchange(m_file, {}));
        return;
    }
    m_has_asked = true;
    lab.looks().open(look);
}
