// Compiled for its precompiled header only, which all test programs share; see CMakeLists.txt.
