#pragma once

#include "lab/offline/offline.h"
#include "parity/plain_chain.h"

#include <memory>

namespace plain {

/// Over all pixels and channels of two pictures; 1 is white.
struct Difference {
    double mean = 0.0;
    double largest = 0.0;
};
Difference difference_of(const std::vector<float>& a, const std::vector<float>& b);

/// A preset drawn by the program and by the plain chain, in one context.
class Pair {
public:
    static Result<Pair> open(const std::filesystem::path& preset, Extent original, Extent viewport);

    /// Sets the original of both, from the next frame.
    Result<void> set_original(const Bytes& picture);
    void draw_ours() { m_ours->advance(); }
    void draw_plain() { m_plain->draw(); }
    /// Draws `frames` frames of a moving picture. Returns the larger difference of the first and
    /// last frame.
    Result<Difference> compare(int frames);

    Offline& ours() { return *m_ours; }
    /// Feedback or history.
    bool reads_the_past() const { return m_reads_the_past; }

private:
    Difference difference() const;

    Extent m_original;
    bool m_reads_the_past = false;
    std::unique_ptr<Offline> m_ours;  // first: its context must outlive the chain
    std::unique_ptr<Chain> m_plain;
};

}  // namespace plain
