#pragma once

#include "model/date.h"

/// Now, where this machine is.
Date local_date();
