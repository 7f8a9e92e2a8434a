#pragma once

#include "lab/match/match_job.h"

/// The label of a number that was found: its parameter, and its component if it has several.
std::string found_label(const FoundNumber& number, const Look& look);

/// Writes one HTML file without a network: the straightened photo, what the camera would see of the
/// look, their difference, and the numbers with their intervals. Atomic.
Result<void> write_match_report(const MatchedFile& matched, const std::filesystem::path& photo,
                                const std::filesystem::path& file);
