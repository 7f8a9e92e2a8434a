#pragma once

#include "model/devices/date.h"

/// The current date and time in the local time zone.
Date local_date();
