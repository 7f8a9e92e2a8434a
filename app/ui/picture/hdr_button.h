#pragma once

struct Scene;
class Edits;

/// While the HDR preview is on: its peak. Click to choose paper white and peak.
void draw_hdr_button(const Scene& scene, Edits& edits);
float hdr_button_width(const Scene& scene);
