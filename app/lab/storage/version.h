#pragma once

/// The version of the program: "1.0.0".
const char* program_version();
