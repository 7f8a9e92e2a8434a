#include "lab/storage/version.h"

const char* program_version() {
    return AFTERGLOW_VERSION;
}
