#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// A look whose composite is edited.
struct ReloadLook {
    std::string key;     // of its topic
    std::string name;    // of the edited pass
    std::string folder;  // in the folder of looks
    std::string turned;  // a parameter of the composite
    std::string before;  // of the edited line, up to the factor
    std::string after;
};

/// The article's look as originally written, and Phosphor.
const std::vector<ReloadLook>& reload_looks();

/// Writes all built-in looks and the article's look.
void write_reload_looks(const std::filesystem::path& folder);

std::string text_of(const std::filesystem::path& file);

/// The composite's text with a new factor that has no visible effect. A driver recognises a text in
/// which only comments or unused functions differ.
std::string with_factor(std::string text, const ReloadLook& look, int number);

/// The line of such a text that contains the factor.
std::string edited_line(const std::string& text, const ReloadLook& look);

}  // namespace bench
