#include "lab/session/first_file.h"

#include <utility>

bool FirstFile::is_one(const std::string& argument, const Lab& lab) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(argument, ignored) && !lab.opens_document(argument);
}

void FirstFile::update(Lab& lab) {
    if (m_file.empty() || !lab.document() || lab.loader().is_loading())
        return;
    const std::string look = lab.look_for(m_file);
    if (look.empty() || m_has_asked) {
        lab.open_file(std::exchange(m_file, {}));
        return;
    }
    m_has_asked = true;
    lab.open(look);
}
