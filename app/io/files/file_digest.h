#pragma once

#include "base/diagnostic.h"
#include "base/job_progress.h"

#include <filesystem>
#include <string>

/// The CRC-32 of a regular file's bytes as eight hexadecimal digits. Identifies the sound or
/// picture that a preset was made with; not secure against forgery.
Result<std::string> file_digest(const std::filesystem::path& file, JobProgress* work = nullptr);
