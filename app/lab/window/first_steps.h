#pragma once

/// The tutorial on the first start: three steps, each marked when done.
struct FirstSteps {
    bool is_shown = false;
    bool has_turned = false;  // a parameter was changed
    bool has_driven = false;  // another signal or picture was used
    bool has_looked = false;  // a pass was inspected

    bool operator==(const FirstSteps&) const = default;
    bool are_done() const { return has_turned && has_driven && has_looked; }
};
