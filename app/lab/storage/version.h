#pragma once

/// The version of the program: "0.9.0".
const char* program_version();
