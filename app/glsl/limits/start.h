#pragma once

/// Initialises glslang once per process. Call before any other glslang function.
void start_glslang();
