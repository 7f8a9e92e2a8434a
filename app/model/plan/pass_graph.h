#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// What reads what in a look, laid out to be drawn: from left to right in the order of a frame.
struct PassGraph {
    struct Node {
        Input::From kind = Input::From::pass;
        std::string name;  // of the pass or image; "source"
        int column = 0;
        double row = 0.0;  // rows are one apart; 0 is in the middle
    };
    /// `to` reads what `from` has drawn.
    struct Edge {
        std::size_t from = 0;  // places in `nodes`
        std::size_t to = 0;
        int frames_ago = 0;
        std::vector<std::string> uniforms;  // that read it so
        std::vector<double> bends;  // rows in the columns between, where it is of this frame
    };
    std::vector<Node> nodes;  // passes first, in their order
    std::vector<Edge> edges;
    int columns = 0;
    double lowest = 0.0;  // rows
    double highest = 0.0;
};

/// Every pass stands to the right of all that it reads of this frame. What crosses columns has a
/// place of its own in each, so that lines run between the passes and not over them.
PassGraph graph_of(const Look& look);
