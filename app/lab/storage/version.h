#pragma once

/// The version of the program: "0.1.0".
const char* program_version();
