// Compiled only for its precompiled header, which all layers share; see CMakeLists.txt.
