#include "lab/golden/golden_page.h"

namespace {
constexpr std::string_view style_sheet = R"css(
:root { color-scheme: light dark; --line: #8885; --bad: #d33; --warn: #b70; --good: #293; }
@media (prefers-color-scheme: dark) { :root { --bad: #f66; --warn: #fb4; --good: #6c7; } }
body { font: 15px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 1500px; padding: 1rem; }
h1 { font-size: 1.4rem; margin: 0 0 0.5rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0 1rem; margin: 0.5rem 0 1rem; }
dt { opacity: 0.7; }
dd { margin: 0; overflow-wrap: anywhere; }
code, pre { font: 13px/1.5 ui-monospace, monospace; }
pre { overflow-x: auto; background: #8881; padding: 0.5rem; }
button { font: inherit; margin-right: 0.5rem; padding: 0.2rem 0.7rem; }
details { border-top: 1px solid var(--line); }
summary { cursor: pointer; display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 1rem;
  padding: 0.4rem 0; }
summary::before { content: "\25B8"; width: 1ch; }
details[open] > summary::before { content: "\25BE"; }
summary b { min-width: 6.5em; }
summary code { font-weight: 600; overflow-wrap: anywhere; }
summary span { opacity: 0.8; }
.different b, .broken b, .missing b { color: var(--bad); }
.orphaned b, .skipped b, .created b, .updated b, .removed b { color: var(--warn); }
.equal b { color: var(--good); }
.pictures { display: grid; gap: 1rem; padding-bottom: 1rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 340px), 1fr)); }
@media (min-width: 800px) and (max-width: 1599px) {
  .pictures { grid-template-columns: 1fr 1fr; } }
figure { margin: 0; }
figcaption { opacity: 0.8; }
figure img { display: block; width: 100%; height: auto; background: #000;
  image-rendering: pixelated; }
.wipe[hidden] { display: none; }
.wipe div { position: relative; cursor: ew-resize; touch-action: pan-y; user-select: none; }
.wipe img + img { position: absolute; inset: 0; height: 100%;
  clip-path: inset(0 0 0 var(--at, 50%)); }
.wipe div::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--at, 50%);
  width: 2px; margin-left: -1px; background: #fff; box-shadow: 0 0 0 1px #000; }
.wipe input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0;
  pointer-events: none; }
.wipe div:focus-within { outline: 3px solid Highlight; outline-offset: 2px; }
)css";

constexpr std::string_view page_script = R"js(
"use strict";
function setUpWipe(entry) {
  const golden = entry.querySelector(".golden img");
  const drawn = entry.querySelector(".new img");
  const wipe = entry.querySelector(".wipe");
  if (!golden || !drawn || !wipe) return;
  if (!drawn.getAttribute("src")) drawn.src = golden.src;
  const area = wipe.querySelector("div");
  const [below, above] = area.querySelectorAll("img");
  const slider = area.querySelector("input");
  below.src = golden.src;
  above.src = drawn.src;
  wipe.hidden = false;
  const show = (percent) => area.style.setProperty("--at", percent + "%");
  const follow = (event) => {
    const box = area.getBoundingClientRect();
    const percent = 100 * (event.clientX - box.left) / box.width;
    slider.value = String(percent);  // rounded and clamped, for the keyboard
    show(Math.min(Math.max(percent, 0), 100));
  };
  slider.addEventListener("input", () => show(slider.value));
  area.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    area.setPointerCapture(event.pointerId);
    slider.focus({ preventScroll: true });
    follow(event);
  });
  area.addEventListener("pointermove", (event) => {
    if (area.hasPointerCapture(event.pointerId)) follow(event);
  });
}
const entries = document.querySelectorAll("details");
for (const entry of entries) setUpWipe(entry);
for (const button of document.querySelectorAll("button"))
  button.addEventListener("click", () => {
    for (const entry of entries) entry.open = button.value === "open";
  });
)js";
}  // namespace

std::string_view golden_page_style() {
    return style_sheet;
}

std::string_view golden_page_script() {
    return page_script;
}
