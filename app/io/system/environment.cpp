#include "io/system/environment.h"

#include <cstdlib>

void set_environment(const char* name, const char* value) {
    ::setenv(name, value, 1);
}

bool unset_environment(const char* name) {
    return ::unsetenv(name) == 0;
}
