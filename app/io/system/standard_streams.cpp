#include "io/system/standard_streams.h"

#include <unistd.h>

static_assert(standard_output == STDOUT_FILENO && standard_error == STDERR_FILENO);

bool is_terminal(int descriptor) {
    return ::isatty(descriptor) == 1;
}
