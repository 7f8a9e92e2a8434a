#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// The inputs between passes of a look, laid out from left to right in drawing order.
struct PassGraph {
    struct Node {
        Input::From kind = Input::From::pass;
        std::string name;  // of the pass or image; "source"
        int column = 0;
        double row = 0.0;  // 1 apart; 0 is the middle
    };
    /// `to` reads the output of `from`.
    struct Edge {
        std::size_t from = 0;  // indices into `nodes`
        std::size_t to = 0;
        int frames_ago = 0;
        std::vector<std::string> uniforms;  // of these inputs
        std::vector<double> bends;  // rows in the columns between, for an edge within a frame
    };
    std::vector<Node> nodes;  // passes first, in their order
    std::vector<Edge> edges;
    int columns = 0;
    double lowest = 0.0;  // rows
    double highest = 0.0;
};

/// Each pass is to the right of everything that it reads in this frame. An edge that crosses
/// columns has a row in each, so that lines run between passes and not over them.
PassGraph graph_of(const Look& look);
