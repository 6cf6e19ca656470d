/// \file
/// How the page looks on paper: printed by a reader's browser, and as the PDF of a run.
#pragma once

#include <string_view>

namespace soms::reproduce {

/// For whoever prints the page from a browser.
inline constexpr std::string_view kPrintStyle = R"css(
@media print{body{max-width:none;font-size:10pt;padding:0}h2,h3{break-after:avoid}
figure,tr{break-inside:avoid}.scroll,.scroll.tall,figure .picture{overflow:visible;
max-height:none}figure svg{min-width:0}thead th{position:static}}
)css";

/// For the PDF. The text block, 172 by 250 mm, fits A4 and Letter. Where a figure or a row does not
/// fit the rest of a page it moves to the next one; a table goes on there under its header.
inline constexpr std::string_view kPaperStyle = R"css(
@page{size:A4;margin:22mm 19mm 25mm;
@top-left{content:"SOMS: the experiments of the thesis, run again";color:#55595e;
font-family:"Liberation Sans",Arial,Helvetica,sans-serif;font-size:7.5pt}
@bottom-center{content:counter(page) " of " counter(pages);color:#55595e;
font-family:"Liberation Sans",Arial,Helvetica,sans-serif;font-size:7.5pt}}
@page:first{@top-left{content:none}}
:root{color-scheme:light}
html{-webkit-print-color-adjust:exact;print-color-adjust:exact}
body{max-width:none;padding:0;hyphens:manual;
font:10pt/1.38 "Liberation Serif","Times New Roman",Times,serif}
p,ul,dl,caption,figcaption{max-width:none}
p{margin:.45em 0;orphans:3;widows:3;text-align:justify}
h1,h2,h3,h4,dl.run,nav,table,figcaption,summary,.note,.byline,.warn
{font-family:"Liberation Sans",Arial,Helvetica,"DejaVu Sans",sans-serif;text-align:left}
header.title{text-align:center;margin:10mm 8mm 6mm}
header.title h1{font-size:18pt;line-height:1.2;margin:0 0 4mm;text-align:center}
header.title .lead{font-size:10.5pt;text-align:center;margin:0 0 4mm}
header.title .byline{font-size:9pt;color:var(--faint);text-align:center;margin:0}
h2{font-size:14pt;margin:9mm 0 2mm;padding:0;border:0}
h3{font-size:11pt;margin:6mm 0 1mm}
h2,h3,h4,summary,caption,thead,h3+p,summary+*,.anchor,.anchor+p{break-after:avoid}
details.item>summary>h3{display:block;font-size:11pt;font-weight:700;margin:6mm 0 1mm}
details.item{margin:0}
h2,h3,h4,summary,caption,li,dt,dd,nav,.warn,.scroll:not(.tall):not(:has(.claims)){break-inside:avoid}
.note{font-size:8pt;margin:.3em 0}
.warn{border-left-width:2pt;padding:2mm 3mm;margin:2mm 0;font-size:9pt}
.lead{font-size:inherit}
dl.run{font-size:8.5pt;gap:.4mm 4mm;margin:3mm 0}
nav ul{columns:2;column-gap:7mm;font-size:8.5pt;margin:1mm 0 3mm}
nav li{padding:.15mm 0 .15mm 3mm;text-indent:-3mm}
a{color:inherit;text-decoration:none}
code{font-family:"Liberation Mono","DejaVu Sans Mono",monospace;font-size:.86em}
figure{margin:3mm 0 4mm;break-inside:avoid}
figure .picture{overflow:visible;border:0;max-width:none}
figure svg{min-width:0;width:auto;max-width:100%;height:auto;max-height:196mm;margin:0 auto}
figure svg[width="720"]{max-width:128mm}
figcaption{font-size:8.5pt;line-height:1.3;padding-top:1.5mm}
details{margin:2mm 0}
details ul{font-size:9pt;margin:1mm 0;padding-left:5mm}
summary{list-style:none;color:inherit;font-size:8.5pt;line-height:1.3}
summary::-webkit-details-marker{display:none}
.scroll,.scroll.tall{overflow:visible;max-height:none;margin:1.5mm 0 .5mm;border:0}
table{font-size:8pt;line-height:1.25;width:auto;min-width:100mm;max-width:100%}
caption{font-size:8.5pt;padding:0 0 1.2mm}
thead{display:table-header-group}
thead th{position:static;background:none;border-top:.8pt solid var(--ink);
border-bottom:.6pt solid var(--ink)}
tbody tr:last-child td{border-bottom:.6pt solid var(--ink)}
th,td{padding:.25em .45em;border-bottom:.3pt solid var(--line);overflow-wrap:break-word}
td code{overflow-wrap:break-word}
td.short,th.number{white-space:normal}
.scroll td:first-child{min-width:0}
tr{break-inside:avoid}
th.turned{vertical-align:bottom;text-align:left;padding-top:.6em;padding-left:.3em;padding-right:.3em}
th.turned>div{writing-mode:vertical-rl;transform:rotate(180deg);white-space:nowrap;
display:inline-block;text-align:left}
table.claims{font-size:8pt}
table.claims td{min-width:0}
.badge{border-width:.7pt;padding:0 .4em;font-size:.92em}
.mark{padding:0 .3em;font-size:.92em}
)css";

}  // namespace soms::reproduce
