// Compiled for its precompiled header only, which all layers share; see CMakeLists.txt.
