/// \file
/// How the page of a list of parts looks, beyond what page_style.h says.
#pragma once

#include <string_view>

namespace soms::report {

inline constexpr std::string_view kPartsStyle = R"css(
#look{grid-template-columns:minmax(0,1fr) minmax(0,1fr)}
#filters{display:flex;flex-wrap:wrap;gap:.4rem .8rem;align-items:center}
#filters #find{flex:1 1 14rem}
#filters fieldset{border:1px solid var(--line);border-radius:.35rem;margin:0;padding:.1rem .5rem .25rem;display:flex;flex-wrap:wrap;
gap:.1rem .8rem;font-size:.9rem}
#filters legend{color:var(--faint);font-size:.8rem}
#filters label.none{color:var(--faint)}
#pair-filter{margin:0}
#table{flex:1 1 0;min-height:8rem;overflow-x:hidden;overflow-y:auto;border:1px solid var(--line);border-radius:.4rem;position:relative}
#table:focus-visible{outline:3px solid var(--link);outline-offset:-3px}
#head{position:sticky;top:0;z-index:1;display:grid;background:var(--paper);border-bottom:2px solid var(--line)}
#head [role=columnheader]{min-width:0}
#head,.clash{grid-template-columns:var(--wide)}
#look #head button{width:100%;min-height:2rem;border:0;border-radius:0;text-align:left;font-weight:600;padding:.2rem .4rem;font-size:.9rem;
white-space:nowrap;overflow:hidden}
#head [aria-sort=ascending] button::after{content:" \25b4"}#head [aria-sort=descending] button::after{content:" \25be"}
#rows{position:relative}
.clash{position:absolute;left:0;right:0;height:40px;display:grid;align-items:center;border-bottom:1px solid var(--line);cursor:pointer;
font-size:.88rem;line-height:1.2}
.clash:hover{background:var(--soft)}
.clash[aria-selected=true]{background:var(--soft);box-shadow:inset 0 0 0 2px var(--link)}
.clash>span{padding:0 .4rem;min-width:0;overflow:hidden;text-overflow:ellipsis;display:-webkit-box;-webkit-line-clamp:2;
-webkit-box-orient:vertical;overflow-wrap:anywhere}
.clash>.number,#head .number button{text-align:right!important;font-variant-numeric:tabular-nums;white-space:nowrap;overflow-wrap:normal}
#picked{font-size:1rem;line-height:1.35;padding:0;border:0}
#side{display:block;height:auto!important;margin:0}
#side h2,#matrix-view h2{margin-top:1rem}
#details{columns:26rem;column-gap:2rem;max-width:none;margin:0;font-size:.9rem}
#details div{break-inside:avoid;display:grid;grid-template-columns:10rem minmax(0,1fr);gap:.7rem;padding:.1rem 0}
#details dt{color:var(--faint)}#details dd{margin:0;overflow-wrap:anywhere;user-select:text}
#tools label{background:var(--paper);border:1px solid var(--faint);border-radius:.35rem;padding:.25rem .6rem}
#matrices table{margin:.5rem 0 1rem}
#matrices th{max-width:14rem;overflow-wrap:anywhere}
#matrices td button{font:inherit;color:var(--link);background:none;border:0;padding:0;cursor:pointer;text-decoration:underline}
#matrices td.number{min-width:4rem}#matrices .picture{overflow-x:auto}
#printed{width:100%;font-size:.66rem;border-collapse:collapse;grid-column:1/-1;table-layout:fixed}
#printed td,#printed th{padding:.1rem .25rem;overflow-wrap:break-word}
#printed thead{display:table-header-group}#printed thead th{position:static}
#printed tr{break-inside:avoid}#prints p{grid-column:1/-1}
@media (max-width:60rem){#look{display:block}#table{flex:none;height:24rem;margin-top:.4rem}#beside{display:block}#filters{margin-bottom:.3rem}}
@media (max-width:40rem){#head,.clash{grid-template-columns:var(--narrow)}#table .wide{display:none}
#details{columns:auto}#details div{grid-template-columns:7rem minmax(0,1fr)}}
@media print{#side{display:none}#matrices td button{text-decoration:none;color:inherit}}
)css";

}  // namespace soms::report
