#pragma once

#include "model/devices/date.h"

/// Now, where this machine is.
Date local_date();
