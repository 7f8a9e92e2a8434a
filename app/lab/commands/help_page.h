#pragma once

#include "lab/editor/external_programs.h"
#include "lab/messages/messages.h"
#include "lab/storage/roots.h"

#include <filesystem>
#include <string>

/// The folder with the documentation; "" if it is not installed.
std::filesystem::path find_docs(const Roots& roots);

/// Writes all pages of a documentation folder as HTML below `target`; equal files stay. Fails if a
/// page cannot be read or written.
Result<void> write_help_pages(const std::filesystem::path& docs,
                              const std::filesystem::path& target);

/// Opens a page ("manual.md") as HTML in the user's browser, without network. A notice reports what
/// is missing, and where the page is.
void open_help_page(const Roots& roots, const std::string& page, ExternalPrograms& programs,
                    Messages& messages);
