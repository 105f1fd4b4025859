// How the report looks: light or dark as the reader's system is, and on narrow screens too.
#pragma once

namespace amalgam::report {

inline constexpr const char* kPageStyle = R"css(
:root { color-scheme: light dark; --text: #1c1c1c; --back: #fcfcfa; --faint: #6a6a6a;
        --line: #d8d8d2; --good: #2c7a2c; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e4e4e0; --back: #17181a; --faint: #9a9a96; --line: #3a3b3d;
          --good: #7ac77a; --bad: #ff8a80; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--text); background: var(--back);
       max-width: 76rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 2.5rem; }
p { max-width: 48rem; } .faint { color: var(--faint); }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 34rem), 1fr));
          gap: 1rem; }
figure { margin: 0; max-width: 46rem; } figure svg { width: 100%; height: auto; }
figcaption { color: var(--faint); font-size: .9rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; padding: .2rem .7rem .2rem 0; border-bottom: 1px solid var(--line);
         vertical-align: top; white-space: nowrap; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.good { color: var(--good); } .bad { color: var(--bad); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 16rem), 1fr));
            gap: .5rem; }
img { width: 100%; image-rendering: pixelated; }
)css";

}  // namespace amalgam::report
