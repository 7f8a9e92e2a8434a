#pragma once

#include "base/diagnostic.h"

#include <pugixml.hpp>

#include <string_view>

/// The elements and character data of an XML text, with entities in attributes resolved. Never
/// loads external content. Errors have `file` and the line.
Result<pugi::xml_document> parse_xml(std::string_view text, const std::filesystem::path& file);

/// The line of an element, from 1. `text` is what it was parsed from.
int line_of(const pugi::xml_node& element, std::string_view text);
