#include "model/look/readout_text.h"

#include <fmt/format.h>

std::string readout_text(const Readout& readout, double number) {
    return fmt::format("{}: {:.3g}{}{}", readout.label, number, readout.unit.empty() ? "" : " ",
                       readout.unit);
}
