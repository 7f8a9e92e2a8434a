#pragma once

/// Prepares glslang for the whole process, once; before anything else of it.
void start_glslang();
