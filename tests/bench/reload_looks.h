#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// A look whose composite is edited.
struct ReloadLook {
    std::string key;     // of its topic
    std::string name;    // of what is edited
    std::string folder;  // below the folder of the looks
    std::string turned;  // a parameter of the composite
    std::string before;  // of the line that is edited, up to the factor
    std::string after;
};

/// The article's look as it is written there, and Phosphor.
const std::vector<ReloadLook>& reload_looks();

/// All looks of the program, and that of the article beside them.
void write_reload_looks(const std::filesystem::path& folder);

std::string text_of(const std::filesystem::path& file);

/// The composite's text with a factor that no text had before, and that changes nothing one could
/// see. A driver knows a text again in which only comments or unused functions are new.
std::string with_factor(std::string text, const ReloadLook& look, int number);

/// The line of such a text that holds the factor.
std::string edited_line(const std::string& text, const ReloadLook& look);

}  // namespace bench
