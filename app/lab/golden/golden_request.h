#pragma once

#include "model/look/extent.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What to compare or update. Missing settings are those of golden.json, otherwise the defaults.
struct GoldenRequest {
    std::filesystem::path folder;     // of looks and presets
    std::filesystem::path directory;  // of golden pictures
    std::optional<Extent> size = {};
    std::optional<int> frames = {};
    std::optional<double> levels = {};    // see GoldenBounds
    std::optional<double> percent = {};   // see GoldenBounds
    bool updates = false;                 // writes pictures instead of failing
    std::vector<std::string> names = {};  // to update; empty: all, and orphaned ones are removed
    std::string update_command = {};      // prefix of the commands in results
};

/// Files in the folder of the golden pictures.
std::filesystem::path golden_picture_file(const GoldenRequest& request, const std::string& name);
std::filesystem::path golden_record_file(const GoldenRequest& request);
std::filesystem::path golden_report_file(const GoldenRequest& request);
