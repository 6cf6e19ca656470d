/// \file
/// How the page looks on screens of any width; its colors are those of apps/draw/look.h, whose
/// rules stand before these.
#pragma once

#include <string_view>

namespace soms::reproduce {

inline constexpr std::string_view kPageStyle = R"css(
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0 auto;max-width:66rem;padding:1rem 1.25rem 4rem;background:var(--paper);
color:var(--ink);font:1rem/1.5 system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
h1{font-size:1.9rem;line-height:1.2;margin:1rem 0 .5rem}
h2{font-size:1.4rem;line-height:1.25;margin:3rem 0 .5rem;padding-top:.75rem;
border-top:2px solid var(--line)}
h3{font-size:1.12rem;line-height:1.3;margin:2.5rem 0 .5rem}
p,ul,dl{max-width:46rem}
a{color:var(--link)}
.lead{font-size:1.08rem}
.note,figcaption,caption,.faint{color:var(--faint)}
.note{font-size:.9rem}
.warn{background:var(--warn);border-left:4px solid var(--warn-line);padding:.6rem .9rem;
margin:1rem 0;max-width:none}
dl.run{display:grid;grid-template-columns:max-content 1fr;gap:.2rem 1rem;margin:1rem 0}
dl.run dt{color:var(--faint)}
dl.run dd{margin:0;overflow-wrap:anywhere}
.scroll{overflow-x:auto;margin:.5rem 0 .25rem}
.scroll.tall{max-height:32rem;overflow-y:auto;border-bottom:1px solid var(--line)}
table{border-collapse:collapse;font-size:.9rem;line-height:1.35}
caption{caption-side:top;text-align:left;padding:.25rem 0 .5rem;max-width:46rem}
th,td{padding:.3rem .7rem;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th:first-child,td:first-child{padding-left:.25rem}
thead th{position:sticky;top:0;background:var(--paper);border-bottom:2px solid var(--line);
vertical-align:bottom}
.scroll th span{font-weight:400;color:var(--faint)}
th.number,td.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
td.short{white-space:nowrap}
th.timed,td.timed{font-style:italic}
.badge{display:inline-block;border:1.5px solid currentColor;border-radius:1rem;
padding:.05rem .6rem;font-size:.85rem;font-weight:600;white-space:nowrap}
.holds,.mostly_holds{color:var(--good)}.holds_under,.holds_on_some,.mixed{color:var(--part)}
.undecided{color:var(--link)}.does_not_hold,.mostly_fails{color:var(--bad)}
.cannot_be_checked,.too_few_rows{color:var(--open)}.mostly_holds,.mostly_fails{border-style:dashed}
.mark{display:inline-block;border:1px dashed var(--warn-line);background:var(--warn);
border-radius:.3rem;padding:0 .4rem;font-size:.82rem;white-space:nowrap}
nav ul{list-style:none;padding:0;columns:22rem;column-gap:2rem;max-width:none;margin:.3rem 0 1rem}
nav li{break-inside:avoid;padding:.12rem 0}
nav b{font-weight:600}
figure{margin:1.25rem 0 1.75rem}
figure .picture{overflow-x:auto;border:1px solid var(--line);border-radius:.4rem;
max-width:60rem}
figure svg,figure img{display:block;width:100%;min-width:36rem;height:auto}
figcaption{max-width:46rem;padding-top:.5rem;font-size:.95rem}
details{margin:.75rem 0}
summary{cursor:pointer;color:var(--link)}
details.item{margin:.15rem 0}details.item>summary>h3{display:inline;margin:0;font-size:1rem;
font-weight:500}details.item[open]>summary>h3{font-size:1.12rem;font-weight:700}
details.item[open]{margin:1rem 0 2rem}.anchor{scroll-margin-top:3rem}
header.title .lead{max-width:none}header.title+h2{margin-top:1rem}
svg.matrix{display:block;width:100%;height:auto;font:12.5px system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
svg.matrix.narrow{display:none}svg.matrix text{fill:var(--ink)}svg.matrix .rule{stroke:var(--line)}
svg.matrix .head{font-weight:600}svg.matrix a>text{fill:var(--link)}svg.matrix .stand{font-weight:600;fill:currentColor}
svg.matrix .cell{outline:0}svg.matrix .cell rect{fill:currentColor}
svg.matrix .cell text{fill:var(--paper);font-size:9px;font-weight:700;text-anchor:middle}
svg.matrix .cell.holds{color:var(--good)}svg.matrix .cell.holds_on_some{color:var(--part)}
svg.matrix .cell.undecided{color:var(--link)}svg.matrix .cell.does_not_hold{color:var(--bad)}
svg.matrix .cell.cannot_be_checked rect{fill:none;stroke:var(--line)}svg.matrix .cell.cannot_be_checked text{fill:var(--faint)}
svg.matrix .cell.nearest rect{stroke:var(--ink);stroke-width:2}
.cell{display:inline-block;width:1.15rem;height:1.15rem;margin:1px;border-radius:.2rem;
text-align:center;font-size:.75rem;line-height:1.15rem;font-weight:700;text-decoration:none;
color:var(--paper)}
.cell.holds{background:var(--good);color:var(--paper)}
.cell.holds_on_some{background:var(--part);color:var(--paper)}
.cell.undecided{background:var(--link);color:var(--paper)}
.cell.does_not_hold{background:var(--bad);color:var(--paper)}
.cell.cannot_be_checked{background:none;color:var(--open);box-shadow:inset 0 0 0 1px var(--open)}
.cell.nearest{outline:2px solid var(--ink);outline-offset:-1px;margin:3px 2px}
ol.questions{max-width:52rem;padding-left:1.6rem}ol.questions li{margin:.5rem 0}
.changed{background:var(--soft);border-left:4px solid var(--link);padding:.6rem .9rem;
max-width:none}
table.matrix td{min-width:0}table.matrix td:nth-child(-n+2){min-width:11rem}table.matrix td.number{white-space:normal;min-width:6rem}
.scroll td:first-child{min-width:7rem}
@media (max-width:40rem){svg.matrix.wide{display:none}svg.matrix.narrow{display:block}}
)css";

}  // namespace soms::reproduce
