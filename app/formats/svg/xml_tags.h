#pragma once

#include "base/diagnostic.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A tag of an XML text. Text between tags is not included.
struct XmlTag {
    std::string name;  // without the namespace prefix
    bool is_closing = false;
    bool is_empty = false;                          // "<path ... />"
    std::map<std::string, std::string> attributes;  // entities resolved
    int line = 0;
};

/// The tags of an XML text in order. Skips comments, declarations and CDATA, and never loads
/// external content. Errors have `file` and the line.
Result<std::vector<XmlTag>> parse_xml_tags(std::string_view text,
                                           const std::filesystem::path& file);
