#include "lab/gallery/gallery_style.h"

namespace {
constexpr std::string_view gallery_css = R"css(
:root { color-scheme: dark; --surround: #0e0e0f; --pane: #19191a; --field: #262628;
  --hover: #333335; --line: #38383a; --outline: #6e6e70; --text: #dededc; --dim: #a9a9a8;
  --accent: #e0a05a; --edge: max(16px, calc(50vw - 800px)); }
* { box-sizing: border-box; }
[hidden] { display: none !important; }
html { scroll-padding-top: 64px; scrollbar-gutter: stable; }
body { margin: 0; background: var(--surround); color: var(--text);
  font: 14px/1.45 system-ui, sans-serif; -webkit-text-size-adjust: 100%; }
h1, h2, h3, p, dl, dd { margin: 0; }
small, code { font-size: 12px; }
code, .facts dd { font-family: ui-monospace, monospace; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
button, input { font: inherit; color: inherit; height: 32px; padding: 0 10px; border-radius: 5px;
  border: 1px solid var(--line); background: var(--field); }
button { cursor: pointer; touch-action: manipulation; }
button:hover { background: var(--hover); }
::placeholder { color: var(--dim); opacity: 1; }

body > header { position: sticky; top: 0; z-index: 1; display: flex; align-items: center;
  gap: 8px 16px; padding: 10px var(--edge); background: var(--surround);
  border-bottom: 1px solid var(--line); }
h1 { flex: none; font-size: 17px; }
[type=search] { flex: 0 1 360px; min-width: 0; margin-left: auto; border-color: var(--outline); }
output { flex: none; min-width: 110px; text-align: right; color: var(--dim);
  font-variant-numeric: tabular-nums; }
nav { display: flex; flex-wrap: wrap; gap: 8px; padding: 14px var(--edge) 0; }
nav a { padding: 4px 12px; border: 1px solid var(--line); border-radius: 16px;
  background: var(--pane); color: inherit; text-decoration: none; white-space: nowrap; }
nav a:hover { background: var(--hover); }
nav small { margin-left: 2px; color: var(--dim); }
main { padding: 0 var(--edge) 40px; }
section { padding-top: 28px; }
h2 { font-size: 20px; line-height: 28px; overflow-wrap: anywhere; }
h2 code { margin-left: 6px; color: var(--dim); font-weight: 400; }
section > .about { max-width: 75ch; }
.credits, .author, .about { overflow-wrap: anywhere; }
.credits { margin-top: 2px; color: var(--dim); font-size: 13px; }
.none { padding: 60px 0; text-align: center; color: var(--dim); }
.none button { margin-left: 8px; color: var(--text); }

.cards { display: grid; gap: 16px; margin-top: 14px;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 276px), 1fr)); }
.cards:has(details[open]) { align-items: start; }
article { display: flex; flex-direction: column; min-width: 0; overflow: hidden;
  padding: 0 12px 12px; border: 1px solid var(--line); border-radius: 8px;
  background: var(--pane); }
.picture { position: relative; display: block; margin: 0 -12px 10px; background: #000; }
.picture img { display: block; width: 100%; height: auto; }
.picture span { position: absolute; right: 8px; bottom: 8px; padding: 1px 9px 1px 7px;
  border-radius: 10px; background: #000b; color: #fff; font-size: 12px; }
.picture span::before { content: "\25B6\FE0E"; margin-right: 5px; font-size: 9px;
  vertical-align: 1px; color: var(--accent); }
a.picture:hover span { background: var(--accent); color: #171309; }
a.picture:hover span::before { color: inherit; }
a.picture:focus-visible { outline-offset: -2px; }
h3 { font-size: 15px; line-height: 20px; overflow-wrap: anywhere; }
.author { color: var(--dim); font-size: 13px; }
article .about { margin-top: 4px; }
.facts { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 2px 10px;
  margin-top: 8px; font-size: 13px; }
dt { color: var(--dim); }
.facts dd { font-size: 12px; line-height: 19px; overflow-wrap: anywhere; }
details { margin-top: 8px; font-size: 13px; }
summary { cursor: pointer; overflow: hidden; display: -webkit-box; -webkit-box-orient: vertical;
  -webkit-line-clamp: 2; overflow-wrap: anywhere; }
summary::-webkit-details-marker { display: none; }
summary::before { content: "\25B8"; display: inline-block; width: 14px; color: var(--dim); }
details[open] > summary::before { content: "\25BE"; }
summary b { font-weight: 600; }
summary span { margin-left: 4px; color: var(--dim); }
details[open] > summary span { display: none; }
details dl { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, auto); gap: 2px 12px;
  margin-top: 4px; font-variant-numeric: tabular-nums; }
details dd { text-align: right; overflow-wrap: anywhere; }
.heading { grid-column: 1 / -1; margin-top: 6px; color: var(--text); font-weight: 600; }
dd i { display: inline-block; width: 13px; height: 13px; margin-right: 6px; border-radius: 3px;
  border: 1px solid var(--outline); vertical-align: -2px; }
.modulation { display: block; color: var(--dim); }
.note { margin-top: 8px; color: var(--dim); font-size: 13px; overflow-wrap: anywhere; }
.share { display: flex; gap: 6px; margin-top: auto; padding-top: 12px; }
.share input { flex: 1; min-width: 0; padding: 0 8px; color: var(--dim);
  font: 12px ui-monospace, monospace; text-overflow: ellipsis; }
.share button { flex: none; min-width: 74px; }

@media (max-width: 640px) {
  body > header { flex-wrap: wrap; padding-block: 8px; }
  h1 { font-size: 16px; }
  output { margin-left: auto; }
  [type=search] { order: 1; flex: 1 0 100%; }
  button, input { height: 40px; font-size: 16px; }
  .share input { font-size: 16px; }
  nav { flex-wrap: nowrap; overflow-x: auto; scrollbar-width: none; }
  nav a { padding: 8px 14px; border-radius: 20px; }
  details { margin-top: 12px; }
  html { scroll-padding-top: 100px; }
}
)css";

constexpr std::string_view gallery_js = R"js(
"use strict";
const search = document.querySelector("[type=search]");
const shown = document.querySelector("output");
const none = document.querySelector(".none");
const all = shown.textContent;
const text = (root, selector) => root.querySelector(selector)?.textContent ?? "";
const looks = [...document.querySelectorAll("section")].map((section) => ({
  section,
  link: document.querySelector(`nav a[href="#${encodeURIComponent(section.id)}"]`),
  words: `${text(section, "h2")} ${text(section, ":scope > .about")}`.toLowerCase(),
}));
const cards = looks.flatMap((look) => [...look.section.querySelectorAll("article")].map((card) => ({
  card,
  words: `${look.words} ${text(card, "h3")} ${text(card, ".about")}`.toLowerCase(),
})));
function filter() {
  const words = search.value.toLowerCase().split(/\s+/);
  let found = 0;
  for (const { card, words: own } of cards) {
    card.hidden = !words.every((word) => own.includes(word));
    if (!card.hidden) ++found;
  }
  for (const { section, link } of looks) {
    const count = section.querySelectorAll("article:not([hidden])").length;
    section.hidden = count === 0;
    if (!link) continue;
    link.hidden = section.hidden;
    link.querySelector("small").textContent = count;
  }
  none.hidden = found > 0;
  shown.textContent = found === cards.length ? all : `${found} of ${all}`;
}
async function copy(button) {
  const field = button.previousElementSibling;
  try {
    await navigator.clipboard.writeText(field.value);
  } catch {  // not allowed, or not a secure page
    field.focus();
    field.select();
    document.execCommand("copy");
  }
  button.textContent = "Copied";
  setTimeout(() => { button.textContent = "Copy"; }, 1500);
}
for (const field of document.querySelectorAll(".share input"))
  field.addEventListener("focus", () => field.select());
for (const button of document.querySelectorAll(".share button"))
  button.addEventListener("click", () => copy(button));
none.querySelector("button").addEventListener("click", () => {
  search.value = "";
  filter();
  search.focus();
});
search.addEventListener("input", filter);
search.hidden = false;
filter();
)js";
}  // namespace

std::string_view gallery_style() {
    return gallery_css;
}

std::string_view gallery_script() {
    return gallery_js;
}
