#pragma once

#include "formats/portable/portable_json.h"

#include <string>

/// Reads a page again. Returns what is wrong, as a sentence: it has no data, a shader does not
/// compile, or its passes, parameters or content are not those of the description. "": nothing.
std::string page_fault(const std::string& html, const PortableFiles& described);
